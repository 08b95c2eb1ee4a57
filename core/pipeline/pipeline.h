// Runs the stages of frames of one scene: build, update, gather, bounce, trace, views. The caller says which stage to run when; each
// stage reads the products of those before it. Build, update and trace run on the Vulkan device or, with StageDevice::cpu, in C++.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/gpu/context.h"
#include "core/grid/build.h"
#include "core/grid/invariants.h"
#include "core/scene/numbering.h"
#include "core/scene/scene.h"
#include "core/trace/settings.h"
#include "core/trace/trace.h"
#include "shaders/shared/base/view_element.h"
#include "shaders/shared/grid/findings.h"
#include "shaders/shared/trace/frame.h"
#include "shaders/shared/truth/truth.h"

namespace gridscope {

class GpuStages;

enum class StageDevice { vulkan, cpu };  // where build, update and trace run

// Milliseconds of each stage's last run: GPU time on the Vulkan device, wall time in C++.
struct StageTimes {
  double build = 0.0;  // clear and insertion of the static instances
  double clear = 0.0;  // update: taking dynamic references out
  double add = 0.0;    // update: transform and insertion
  double gather = 0.0;
  double bounce = 0.0;
  double trace = 0.0;
  double views = 0.0;  // sum since the last gather
};

// A scene that is numbered already, with every derived parameter: what a capture holds.
struct PipelineInputs {
  std::string name;  // for messages
  NumberedScene numbered;
  FrameSettings settings;
  FrameParameters parameters;  // taken as they are, bit for bit
  Bounds bounds{};             // of the scene; empty: settings can't be changed later
};

// A layer of cells for the view `slice`. index < 0: the layer in the middle of the grid.
struct SliceSettings {
  int axis = 1;
  int index = -1;
};

// Can the device make every pass from its present shader (shader_code.h)? Throws Error for the first that it refuses.
void tryShaders(GpuContext& gpu);

class Pipeline {
 public:
  // Numbers and uploads the scene; throws Error when the scene or the grid does not fit. `scene` must outlive the pipeline.
  // Stages are compiled here, so that their times hold no compilation.
  Pipeline(GpuContext& gpu, const Scene& scene, const FrameSettings& settings, StageDevice device = StageDevice::vulkan);
  // The same without a scene: no diffuse maps, and updates are told the transforms.
  Pipeline(GpuContext& gpu, PipelineInputs inputs, StageDevice device = StageDevice::vulkan);
  ~Pipeline();

  // Stages, in this order. build() ends with a grid of the static instances alone. On the Vulkan device `goesOn` is told how much of it is done
  // (0..1); where it says no, build() throws Error, and must run again before the other stages.
  void build(const std::function<bool(float)>& goesOn = {});
  void update(float timeSeconds);                    // moves the dynamic instances; the first after a build adds all of them
  void update(std::span<const Instance> instances);  // the same with all instances as of the new frame; static ones must not differ
  void gather();
  void bounce(uint32_t frame);
  void trace(bool counting);  // counting: also the counters, which cost a little

  // Rays [first, end) alone: the caller sees to it that every ray of the frame is traced once. times().trace adds up from first = 0 on.
  void traceTile(uint32_t first, uint32_t end, bool counting);

  // Products from elsewhere, instead of a stage's. Sizes must be those of the frame.
  void useInstances(std::span<const Instance> instances);  // instead of update, for a grid that it can't follow: useGrid comes next
  void useGrid(std::span<const uint32_t> words);           // instead of build and update: the instances' present transforms are applied
  void useGather(std::span<const GatherPixel> pixels);
  void useRays(std::span<const Ray> rays);
  void useHits(std::span<const Hit> hits);
  void useCounters(std::span<const RayCounters> counters);

  // What was found out about the frame, for the views that need it (View::need). Nothing here says when it is out of date.
  void useTruths(std::span<const RayTruth> truths);                                    // one a pixel
  void useTriangleCosts(std::span<const uint32_t> rays);                               // lost to each world triangle
  void useCellRays(std::span<const CellRays> cells);                                   // x fastest, as all that is told of cells
  void useStability(std::span<const uint32_t> cells, std::span<const uint32_t> rays);  // kStable... of each cell; 1 for a ray that changes
  void useCellUpdates(std::span<const CellUpdate> cells);

  // Elements of a view over the present products: one a pixel, or one a cell of the slice.
  struct ViewImage {
    uint32_t width;
    uint32_t height;
    std::vector<ViewElement> elements;  // row by row, first row at the top (slice: see sliceSize())
  };
  // Views of a layer of cells are `slice` and those whose names end in "-slice".
  // readsGrid: with StageDevice::cpu the grid is brought to the device first, where it must fit.
  ViewImage view(std::string_view name, const SliceSettings& slice = {}, bool readsGrid = true);

  // Settings. Those of a stage take effect when it runs next; a changed grid setting asks for build() again, which setGrid() says.
  const FrameSettings& settings() const { return settings_; }
  void setCamera(const CameraPose& camera);
  void setTrace(const TraceSettings& settings);
  void setBounce(const BounceSettings& settings);
  // Another grid for the same numbering: build() comes next. Throws Error, and changes nothing, when it does not fit, when numberBy differs,
  // or when the bounds of the scene are not known.
  void setGrid(const GridSettings& settings);
  // Another frame size: gather() comes next.
  void setSize(uint32_t width, uint32_t height);

  // Facts.
  const std::string& name() const { return name_; }
  const NumberedScene& numbered() const { return numbered_; }
  const FrameParameters& parameters() const { return parameters_; }
  const StageTimes& times() const { return times_; }
  const BuildReport& buildReport() const { return buildReport_; }     // of the last build()
  const UpdateReport& updateReport() const { return updateReport_; }  // of the last update()
  StageDevice device() const { return device_; }
  uint32_t rayCount() const { return settings_.width * settings_.height; }
  GridTotals gridTotals();     // counted on the device
  uint64_t referencesTried();  // by the build and all that updates left in the grid: stored + refused must equal it

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
  void prepare(std::span<const Image> images);
  void setFrameParameters();
  void updateFrom(std::span<const uint32_t> moved);

  GpuContext& gpu_;
  const Scene* scene_ = nullptr;  // null for captured inputs
  std::string name_;
  FrameSettings settings_;
  StageDevice device_;
  Bounds bounds_;
  NumberedScene numbered_;
  FrameParameters parameters_{};
  StageTimes times_;
  BuildReport buildReport_{};
  UpdateReport updateReport_{};
  uint64_t dynamicTried_ = 0;
  bool dynamicAdded_ = false;  // the grid holds the dynamic instances
  std::unique_ptr<GpuStages> stages_;
  Grid cpuGrid_;  // StageDevice::cpu
  std::vector<Triangle> cpuWorldTriangles_;
};

}  // namespace gridscope
