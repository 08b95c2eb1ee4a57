// Build, update and trace in C++ with the verbs of a Pipeline, for replays on machines without Vulkan.
#pragma once

#include <span>
#include <vector>

#include "core/pipeline/pipeline.h"

namespace gridscope {

class CpuStages {
 public:
  explicit CpuStages(PipelineInputs inputs);

  void build();
  void update(std::span<const Instance> instances);
  void useGrid(std::span<const uint32_t> words);
  void useRays(std::span<const Ray> rays) { rays_.assign(rays.begin(), rays.end()); }
  void trace(bool counting);

  Grid grid() const { return grid_; }
  std::vector<Hit> hits() const { return hits_; }
  std::vector<RayCounters> counters() const { return counters_; }

 private:
  NumberedScene scene_;
  FrameParameters parameters_;
  UpdateMode mode_;
  bool dynamicAdded_ = false;  // the grid holds the dynamic instances
  Grid grid_;
  std::vector<Triangle> worldTriangles_;
  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
  std::vector<RayCounters> counters_;
};

}  // namespace gridscope
