// See pipeline.h.
#include "core/pipeline/pipeline.h"

#include <algorithm>
#include <chrono>
#include <cstring>

#include "core/base/error.h"
#include "core/gpu/grid/limits.h"
#include "core/gpu/stages.h"
#include "core/trace/derive.h"
#include "shaders/shared/gpu/bindings.h"
#include "shaders/shared/grid/slice.h"

namespace gridscope {
namespace {

// How far a ray starts above its surface, in diagonals of the scene: above the rounding of a gathered position.
constexpr float kOriginOffset = 1e-5f;

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Passes that every frame runs.
std::vector<std::string> framePasses(StageDevice device) {
  std::vector<std::string> stems = {"gather_resolve", "bounce"};
  if (device == StageDevice::cpu) return stems;
  stems.insert(stems.end(), {"grid_clear", "transform", "insert", "big_prepare", "insert_big", "update_clear", "statistics", "trace"});
  return stems;
}

}  // namespace

void tryShaders(GpuContext& gpu) { GpuStages::tryShaders(gpu); }

Pipeline::Pipeline(GpuContext& gpu, const Scene& scene, const FrameSettings& settings, StageDevice device)
    : gpu_(gpu),
      scene_(&scene),
      name_(scene.name),
      settings_(settings),
      device_(device),
      bounds_(settings.grid.bounds.value_or(sceneBounds(scene))),
      numbered_(numberScene(scene, settings.grid.numberBy)) {
  parameters_.grid = deriveGrid(settings.grid, bounds_, numbered_);
  setFrameParameters();
  prepare(scene.images);
}

Pipeline::Pipeline(GpuContext& gpu, PipelineInputs inputs, StageDevice device)
    : gpu_(gpu),
      name_(std::move(inputs.name)),
      settings_(inputs.settings),
      device_(device),
      bounds_(inputs.bounds),
      numbered_(std::move(inputs.numbered)),
      parameters_(inputs.parameters) {
  prepare({});
}

// Refuses what does not fit, then allocates, uploads and compiles.
void Pipeline::prepare(std::span<const Image> images) {
  bool onDevice = device_ == StageDevice::vulkan;
  checkGridFits(settings_.grid, parameters_.grid, onDevice ? gridLimits(gpu_.report()) : GridLimits{});
  if (settings_.grid.builder == Builder::raster && onDevice && !gpu_.report().geometryStage)
    throw Error("--builder raster: " + gpu_.report().name + " has no geometry stage; use --builder compute", kExitDevice);
  stages_ = std::make_unique<GpuStages>(gpu_, images, numbered_, settings_);
  if (onDevice)
    stages_->makeGrid(parameters_.grid);
  else
    cpuWorldTriangles_.resize(numbered_.triangleCount);
  stages_->setParameters(parameters_);
  stages_->warm(framePasses(device_));
}

Pipeline::~Pipeline() = default;

void Pipeline::setFrameParameters() {
  float diagonal = std::max(glm::distance(bounds_.low, bounds_.high), 1e-6f);
  parameters_.trace = deriveTrace(settings_.trace, parameters_.grid);
  parameters_.camera = deriveCamera(settings_.camera, settings_.width, settings_.height, diagonal);
  parameters_.bounce.seed = settings_.bounce.seed;
  parameters_.bounce.roughness = settings_.bounce.roughness;
  parameters_.bounce.originOffset = kOriginOffset * diagonal;
  parameters_.view.farDistance = diagonal;
  parameters_.view.sunDirection = glm::normalize(vec3(0.35f, 0.85f, 0.25f));
}

void Pipeline::setCamera(const CameraPose& camera) {
  settings_.camera = camera;
  setFrameParameters();
}

void Pipeline::setTrace(const TraceSettings& settings) {
  settings_.trace = settings;
  setFrameParameters();
}

void Pipeline::setBounce(const BounceSettings& settings) {
  settings_.bounce = settings;
  setFrameParameters();
}

void Pipeline::setGrid(const GridSettings& settings) {
  if (settings.numberBy != settings_.grid.numberBy)
    throw Error(name_ + ": its references are numbered already; another order needs the scene");
  if (bounds_.empty()) throw Error(name_ + ": it does not say its scene's bounds, so its grid's settings are fixed");
  const bool onDevice = device_ == StageDevice::vulkan;
  const GridParameters grid = deriveGrid(settings, settings.bounds.value_or(bounds_), numbered_);
  checkGridFits(settings, grid, onDevice ? gridLimits(gpu_.report()) : GridLimits{});
  settings_.grid = settings;
  parameters_.grid = grid;
  setFrameParameters();
  if (onDevice) stages_->makeGrid(grid);
  stages_->setParameters(parameters_);
}

void Pipeline::setSize(uint32_t width, uint32_t height) {
  settings_.width = width;
  settings_.height = height;
  setFrameParameters();
  stages_->makeTargets(width, height);
  stages_->setParameters(parameters_);
}

void Pipeline::build(const std::function<bool(float)>& goesOn) {
  dynamicAdded_ = false;
  updateReport_ = {};
  dynamicTried_ = 0;
  if (device_ == StageDevice::vulkan) {
    stages_->setParameters(parameters_);
    BuildTimes times;
    buildReport_ = stages_->build(settings_.grid.builder, times, goesOn);
    times_.build = times.clear + times.add;
    return;
  }
  auto start = std::chrono::steady_clock::now();
  cpuGrid_ = buildGrid(parameters_.grid, numbered_, cpuWorldTriangles_, buildReport_);
  times_.build = millisecondsSince(start);
}

void Pipeline::update(float timeSeconds) {
  CHECK(scene_ != nullptr);
  updateFrom(setTransforms(numbered_, *scene_, timeSeconds));
}

void Pipeline::update(std::span<const Instance> instances) {
  CHECK_EQ(instances.size(), numbered_.instances.size());
  std::vector<uint32_t> moved;
  for (uint32_t i = numbered_.staticInstanceCount; i < instances.size(); ++i) {
    if (!std::memcmp(&instances[i], &numbered_.instances[i], sizeof(Instance))) continue;
    numbered_.instances[i] = instances[i];
    moved.push_back(i);
  }
  updateFrom(moved);
}

void Pipeline::updateFrom(std::span<const uint32_t> moved) {
  bool all = !dynamicAdded_ || settings_.grid.update == UpdateMode::all;
  stages_->setInstances(numbered_.instances);
  if (device_ == StageDevice::vulkan) {
    stages_->setParameters(parameters_);
    BuildTimes times;
    updateReport_ = all ? stages_->updateAll(settings_.grid.builder, times) : stages_->updateMoved(moved, times);
    times_.clear = times.clear;
    times_.add = times.add;
  } else {
    auto start = std::chrono::steady_clock::now();
    updateReport_ = all ? updateAll(numbered_, cpuWorldTriangles_, cpuGrid_) : updateMoved(numbered_, moved, cpuWorldTriangles_, cpuGrid_);
    times_.clear = 0.0;
    times_.add = millisecondsSince(start);
    stages_->write(kBindWorldTriangles, std::span<const Triangle>(cpuWorldTriangles_));
  }
  dynamicAdded_ = true;
  dynamicTried_ = updateReport_.added.tried;
  if (all) return;
  GridTotals totals = gridTotals();
  dynamicTried_ = uint64_t(totals.statistics.dynamicStored) + totals.statistics.dynamicRefused;
}

void Pipeline::gather() {
  stages_->setParameters(parameters_);
  times_.gather = stages_->gather();
  times_.views = 0.0;
}

void Pipeline::bounce(uint32_t frame) {
  parameters_.bounce.frame = frame;
  stages_->setParameters(parameters_);
  times_.bounce = stages_->bounce();
}

void Pipeline::useInstances(std::span<const Instance> instances) {
  CHECK_EQ(instances.size(), numbered_.instances.size());
  std::ranges::copy(instances, numbered_.instances.begin());
}

void Pipeline::useGrid(std::span<const uint32_t> words) {
  CHECK_EQ(words.size(), gridWordCount(parameters_.grid));
  stages_->setInstances(numbered_.instances);
  stages_->setParameters(parameters_);
  if (device_ == StageDevice::vulkan) {
    stages_->writeGrid(words);
    stages_->transformAll();
  } else {
    cpuGrid_ = {parameters_.grid, {words.begin(), words.end()}};
    transformTriangles(numbered_, {0, numbered_.instanceCount()}, cpuWorldTriangles_);
    stages_->write(kBindWorldTriangles, std::span<const Triangle>(cpuWorldTriangles_));
  }
}

void Pipeline::useGather(std::span<const GatherPixel> pixels) {
  CHECK_EQ(pixels.size(), rayCount());
  stages_->write(kBindGather, pixels);
}

void Pipeline::useRays(std::span<const Ray> rays) {
  CHECK_EQ(rays.size(), rayCount());
  stages_->write(kBindRays, rays);
  times_.bounce = 0.0;
}

void Pipeline::useHits(std::span<const Hit> hits) {
  CHECK_EQ(hits.size(), rayCount());
  stages_->write(kBindHits, hits);
}

void Pipeline::useCounters(std::span<const RayCounters> counters) {
  CHECK_EQ(counters.size(), rayCount());
  stages_->write(kBindCounters, counters);
}

void Pipeline::useTruths(std::span<const RayTruth> truths) {
  CHECK_EQ(truths.size(), rayCount());
  stages_->keep(kBindTruths, "truths", truths);
}

void Pipeline::useTriangleCosts(std::span<const uint32_t> rays) {
  CHECK_EQ(rays.size(), numbered_.triangleCount);
  stages_->keep(kBindTriangleCosts, "triangle costs", rays);
}

void Pipeline::useCellRays(std::span<const CellRays> cells) {
  CHECK_EQ(cells.size(), cellCountOf(parameters_.grid));
  stages_->keep(kBindCellRays, "cell rays", cells);
}

void Pipeline::useStability(std::span<const uint32_t> cells, std::span<const uint32_t> rays) {
  CHECK_EQ(cells.size(), cellCountOf(parameters_.grid));
  CHECK_EQ(rays.size(), rayCount());
  stages_->keep(kBindStableCells, "stable cells", cells);
  stages_->keep(kBindStableRays, "stable rays", rays);
}

void Pipeline::useCellUpdates(std::span<const CellUpdate> cells) {
  CHECK_EQ(cells.size(), cellCountOf(parameters_.grid));
  stages_->keep(kBindCellUpdates, "cell updates", cells);
}

void Pipeline::trace(bool counting) { traceTile(0, rayCount(), counting); }

void Pipeline::traceTile(uint32_t first, uint32_t end, bool counting) {
  CHECK(first <= end && end <= rayCount());
  if (first == 0) times_.trace = 0.0;
  if (device_ == StageDevice::vulkan) {
    stages_->setParameters(parameters_);
    if (counting) stages_->warm(std::vector<std::string>{"trace_counting"});
    times_.trace += stages_->trace(first, end, counting);
    return;
  }
  std::vector<Ray> traced = rays();
  std::vector<Hit> hit = first == 0 && end == rayCount() ? std::vector<Hit>(traced.size()) : hits();
  std::vector<RayCounters> counted(counting ? end - first : 0);
  auto start = std::chrono::steady_clock::now();
  traceRays({cpuGrid_, numbered_, cpuWorldTriangles_, parameters_.trace}, std::span(traced).subspan(first, end - first),
            std::span(hit).subspan(first, end - first), counted);
  times_.trace += millisecondsSince(start);
  stages_->write(kBindHits, std::span<const Hit>(hit));
  if (!counting) return;
  std::vector<RayCounters> all = first == 0 && end == rayCount() ? std::vector<RayCounters>(end) : counters();
  std::ranges::copy(counted, all.begin() + first);
  stages_->write(kBindCounters, std::span<const RayCounters>(all));
}

Pipeline::ViewImage Pipeline::view(std::string_view name, const SliceSettings& slice, bool readsGrid) {
  bool isSlice = name == "slice" || name.ends_with("-slice");
  ivec3 cells = parameters_.grid.cellCount;
  int layer = slice.index < 0 ? cells[slice.axis] / 2 : slice.index;
  if (layer >= cells[slice.axis])
    throw Error("--slice: layer " + std::to_string(layer) + " is beyond the grid's " + std::to_string(cells[slice.axis]) +
                " cells along that axis");
  ViewImage image;
  uvec2 size = isSlice ? sliceSize(cells, slice.axis) : uvec2(settings_.width, settings_.height);
  image.width = size.x;
  image.height = size.y;
  parameters_.view.width = image.width;
  parameters_.view.height = image.height;
  parameters_.view.sliceAxis = slice.axis;
  parameters_.view.sliceIndex = layer;

  bool bringGrid = device_ == StageDevice::cpu && readsGrid;
  if (bringGrid && !stages_->hasGrid()) {
    checkGridFits(settings_.grid, parameters_.grid, gridLimits(gpu_.report()));
    stages_->makeGrid(parameters_.grid);
  }
  stages_->setParameters(parameters_);
  if (bringGrid) stages_->writeGrid(cpuGrid_.words);

  std::string stem = "view_" + std::string(name);
  std::replace(stem.begin(), stem.end(), '-', '_');
  times_.views += stages_->view(stem, image.width, image.height);
  image.elements = stages_->read<ViewElement>(kBindViewElements, size_t(image.width) * image.height);
  return image;
}

GridTotals Pipeline::gridTotals() { return device_ == StageDevice::vulkan ? stages_->countGrid() : countGrid(cpuGrid_); }

uint64_t Pipeline::referencesTried() { return buildReport_.tried + dynamicTried_; }

Grid Pipeline::grid() {
  if (device_ == StageDevice::cpu) return cpuGrid_;
  return {parameters_.grid, stages_->readGrid()};
}

std::vector<Triangle> Pipeline::worldTriangles() {
  if (device_ == StageDevice::cpu) return cpuWorldTriangles_;
  return stages_->read<Triangle>(kBindWorldTriangles, numbered_.triangleCount);
}

std::vector<GatherPixel> Pipeline::gatherPixels() { return stages_->read<GatherPixel>(kBindGather, rayCount()); }
std::vector<Ray> Pipeline::rays() { return stages_->read<Ray>(kBindRays, rayCount()); }
std::vector<Hit> Pipeline::hits() { return stages_->read<Hit>(kBindHits, rayCount()); }
std::vector<RayCounters> Pipeline::counters() { return stages_->read<RayCounters>(kBindCounters, rayCount()); }

RayRecord Pipeline::record(uint32_t pixel) {
  CHECK_LT(pixel, rayCount());
  if (device_ == StageDevice::vulkan) {
    stages_->setParameters(parameters_);
    return stages_->record(pixel);
  }
  return recordRay({cpuGrid_, numbered_, cpuWorldTriangles_, parameters_.trace}, rays()[pixel]);
}

}  // namespace gridscope
