// Does the order in which references arrive matter? Builds of the same scene compared: which cells hold other references, which the same
// in another order, and which rays end differently for it. For first-come insertion; sorted insertion must show nothing.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/pipeline/pipeline.h"

namespace gridscope {

struct Stability {
  uint32_t builds = 0;          // compared
  std::vector<uint32_t> cells;  // kStable..., x fastest
  std::vector<uint32_t> rays;   // 1: the ray's result is not the same in all builds
  uint64_t occupied = 0;        // cells that hold a reference, in the first build
  uint64_t setDiffers = 0;      // cells that hold other references
  uint64_t orderDiffers = 0;    // cells that hold the same ones in another order, now and then
  uint64_t raysChange = 0;
};

// Takes in builds one after the other. `hits` may be empty: then rays are not compared.
class BuildComparison {
 public:
  void add(Grid grid, std::span<const Hit> hits);
  Stability result() const;

 private:
  Grid first_;
  std::vector<Hit> firstHits_;
  Stability found_;
};

// Runs `rebuild` (build and update) and a trace of the pipeline's present rays `builds` times. Leaves the last build.
Stability compareBuilds(Pipeline& pipeline, uint32_t builds, const std::function<void()>& rebuild);

}  // namespace gridscope
