// Runs the stages of frames of one scene: build, update, gather, bounce, trace, views. The caller says which stage to run when; each
// stage reads the products of those before it. Build, update and trace run on the Vulkan device or, with StageDevice::cpu, in C++.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/build.h"
#include "core/derive.h"
#include "core/gpu_context.h"
#include "core/invariants.h"
#include "core/numbering.h"
#include "core/scene.h"
#include "core/settings.h"
#include "core/trace.h"
#include "views/element.h"

namespace gridscope {

class GpuStages;

enum class StageDevice { vulkan, cpu };  // where build, update and trace run

// Milliseconds of each stage's last run: GPU time on the Vulkan device, wall time in C++.
struct StageTimes {
  double build = 0.0;     // clear and insertion of the static instances
  double clear = 0.0;     // update: taking dynamic references out
  double add = 0.0;       // update: transform and insertion
  double gather = 0.0;
  double bounce = 0.0;
  double trace = 0.0;
  double views = 0.0;     // sum since the last gather
};

// A layer of cells for the view `slice`. index < 0: the layer in the middle of the grid.
struct SliceSettings {
  int axis = 1;
  int index = -1;
};

class Pipeline {
 public:
  // Numbers and uploads the scene; throws Error when the scene or the grid does not fit. `scene` must outlive the pipeline.
  // Stages are compiled here, so that their times hold no compilation.
  Pipeline(GpuContext& gpu, const Scene& scene, const FrameSettings& settings, StageDevice device = StageDevice::vulkan);
  ~Pipeline();

  // Stages, in this order. build() ends with a grid of the static instances alone.
  void build();
  void update(float timeSeconds);              // moves the dynamic instances; the first after a build adds all of them
  void gather();
  void bounce(uint32_t frame);
  void useRays(std::span<const Ray> rays);     // instead of bounce; as many as the frame has pixels
  void trace(bool counting);                   // counting: also the counters, which cost a little

  // Elements of a view over the present products: one a pixel, or one a cell of the slice.
  struct ViewImage {
    uint32_t width;
    uint32_t height;
    std::vector<ViewElement> elements;         // row by row, first row at the top (slice: see sliceSize())
  };
  ViewImage view(std::string_view name, const SliceSettings& slice = {});

  // Settings. Those of a stage take effect when it runs next; a changed grid setting asks for build() again, which setGrid() says.
  const FrameSettings& settings() const { return settings_; }
  void setCamera(const CameraPose& camera);
  void setTrace(const TraceSettings& settings);
  void setBounce(const BounceSettings& settings);

  // Facts.
  const Scene& scene() const { return scene_; }
  const NumberedScene& numbered() const { return numbered_; }
  const FrameParameters& parameters() const { return parameters_; }
  const StageTimes& times() const { return times_; }
  const BuildReport& buildReport() const { return buildReport_; }    // of the last build()
  const UpdateReport& updateReport() const { return updateReport_; } // of the last update()
  StageDevice device() const { return device_; }
  uint32_t rayCount() const { return settings_.width * settings_.height; }
  GridTotals gridTotals();                     // counted on the device
  uint64_t referencesTried();                  // by the build and all that updates left in the grid: stored + refused must equal it

  // Products, copied to the host.
  Grid grid();
  std::vector<Triangle> worldTriangles();
  std::vector<GatherPixel> gatherPixels();
  std::vector<Ray> rays();
  std::vector<Hit> hits();
  std::vector<RayCounters> counters();
  // The recorded steps of one ray of the present products, from the recording trace of the pipeline's device.
  RayRecord record(uint32_t pixel);

 private:
  void setFrameParameters();

  GpuContext& gpu_;
  const Scene& scene_;
  FrameSettings settings_;
  StageDevice device_;
  Bounds bounds_;
  NumberedScene numbered_;
  FrameParameters parameters_{};
  StageTimes times_;
  BuildReport buildReport_{};
  UpdateReport updateReport_{};
  uint64_t dynamicTried_ = 0;
  bool dynamicAdded_ = false;                  // the grid holds the dynamic instances
  std::unique_ptr<GpuStages> stages_;
  Grid cpuGrid_;                               // StageDevice::cpu
  std::vector<Triangle> cpuWorldTriangles_;
};

}  // namespace gridscope
