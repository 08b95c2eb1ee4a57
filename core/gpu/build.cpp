// Build and update on the Vulkan device. core/grid/build.h is the same in C++, and says what each stage leaves in the grid.
#include <algorithm>

#include "core/gpu/stages.h"

namespace gridscope {
namespace {

// A driver that ends loops early loses references without a word: every build counts the cells it walked against those it had to.
void checkWalked(const BuildReport& report, const char* stage) {
  if (report.cellsExpected == report.cellsWalked && report.loopsCut == 0) return;
  throw Error(std::string(stage) + ": the driver cut loops short (" + std::to_string(report.cellsWalked) + " of " +
                  std::to_string(report.cellsExpected) + " cells walked, " + std::to_string(report.loopsCut) +
                  " slot walks cut); the grid is not valid. Use a smaller --capacity, or --device cpu",
              kExitDevice);
}

ivec3 alongX(uint32_t count) { return {int(count), 1, 1}; }

// Triangles of one submission of a build: a fifth of a second or so on the slowest device, after which it can be given up.
constexpr uint32_t kPieceTriangles = 1u << 19;

// Instances from `begin` on whose triangles fill one piece.
InstanceRange pieceFrom(const NumberedScene& scene, uint32_t begin, uint32_t end) {
  InstanceRange piece{begin, begin};
  uint32_t triangles = 0;
  while (piece.end < end && (piece.end == begin || triangles + scene.instances[piece.end].triangleCount <= kPieceTriangles))
    triangles += scene.instances[piece.end++].triangleCount;
  return piece;
}

}  // namespace

void GpuStages::makeGrid(const GridParameters& grid) {
  ivec3 texels = gridTexelCount(grid);
  ImageShape shape{.type = VK_IMAGE_TYPE_3D,
                   .viewType = VK_IMAGE_VIEW_TYPE_3D,
                   .format = VK_FORMAT_R32_UINT,
                   .extent = {uint32_t(texels.x), uint32_t(texels.y), uint32_t(texels.z)},
                   .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT};
  grid_ = GpuImage();  // the old one goes before the new one comes
  grid_ = GpuImage(gpu_, "grid", shape);
  programs_.bind(kBindGrid, grid_);
  makeBuffer(kBindHistogram, "histogram", (uint64_t(grid.capacity) + 1) * sizeof(uint32_t));
  buffers_[kBindCellMarks] = GpuBuffer();
  GpuCommands commands(gpu_);
  commands.layout(grid_, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  commands.run();
}

PassArguments GpuStages::argumentsFor(InstanceRange range, uint32_t take) const {
  auto firstTriangle = [&](uint32_t instance) {
    return instance < numbered_.instanceCount() ? numbered_.instances[instance].firstWorldTriangle : numbered_.triangleCount;
  };
  return {range.begin, range.end, firstTriangle(range.begin), firstTriangle(range.end), take, 0};
}

void GpuStages::zero(GpuCommands& commands, int binding) {
  vkCmdFillBuffer(commands.handle(), buffers_[binding].handle(), 0, VK_WHOLE_SIZE, 0);
}

void GpuStages::clearGrid(GpuCommands& commands) { programs_.dispatch(commands, "grid_clear", gridTexelCount(parameters_.grid)); }

void GpuStages::transform(GpuCommands& commands, InstanceRange range, uint32_t take) {
  PassArguments arguments = argumentsFor(range, take);
  programs_.dispatch(commands, "transform", alongX(arguments.endTriangle - arguments.firstTriangle), bytesOf(arguments));
  commands.barrier();
}

// The small triangles first, which fills the lists of big ones; then those, class by class.
void GpuStages::walk(GpuCommands& commands, const std::string& operation, InstanceRange range, uint32_t take) {
  PassArguments arguments = argumentsFor(range, take);
  if (arguments.endTriangle == arguments.firstTriangle) return;
  zero(commands, kBindBigDispatch);
  commands.barrier();
  programs_.dispatch(commands, operation, alongX(arguments.endTriangle - arguments.firstTriangle), bytesOf(arguments));
  commands.barrier();
  walkBig(commands, operation, arguments);
}

void GpuStages::walkBig(GpuCommands& commands, const std::string& operation, PassArguments arguments) {
  programs_.dispatch(commands, "big_prepare", {1, 1, 1});
  commands.barrier();
  for (int bigClass = 0; bigClass < kBigClassCount; ++bigClass) {
    arguments.bigClass = uint32_t(bigClass);
    programs_.dispatchIndirect(commands, operation + "_big", buffers_[kBindBigDispatch], bigClass * sizeof(uvec3), bytesOf(arguments));
  }
  commands.barrier();
}

// The paper's builder: one draw an instance, without attachments, vertex and index buffers.
void GpuStages::buildRaster(GpuCommands& commands, InstanceRange range) {
  PassArguments arguments = argumentsFor(range, kTakeAll);
  zero(commands, kBindBigDispatch);
  commands.barrier();
  VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
  rendering.renderArea.extent = {1, 1};
  rendering.layerCount = 1;
  vkCmdBeginRendering(commands.handle(), &rendering);
  programs_.bindBuildRaster(commands);
  for (uint32_t i = range.begin; i < range.end; ++i) {
    const Instance& instance = numbered_.instances[i];
    vkCmdDraw(commands.handle(), 3 * instance.triangleCount, 1, 3 * instance.firstTriangle, i);
  }
  vkCmdEndRendering(commands.handle());
  commands.barrier();
  walkBig(commands, "insert", arguments);
}

void GpuStages::add(GpuCommands& commands, Builder builder, InstanceRange range) {
  if (range.begin == range.end) return;
  if (builder == Builder::raster) return buildRaster(commands, range);
  transform(commands, range, kTakeAll);
  walk(commands, "insert", range, kTakeAll);
}

void GpuStages::transformAll() {
  GpuCommands commands(gpu_);
  transform(commands, {0, numbered_.instanceCount()}, kTakeAll);
  commands.run();
}

BuildReport GpuStages::readReport(const char* stage) {
  BuildReport report = read<BuildReport>(kBindBuildReport, 1)[0];
  checkWalked(report, stage);
  return report;
}

BuildReport GpuStages::build(Builder builder, BuildTimes& times, const std::function<bool(float)>& goesOn) {
  const uint32_t end = numbered_.staticInstanceCount;
  times = {};
  InstanceRange piece = pieceFrom(numbered_, 0, end);
  for (bool first = true; first || piece.begin < end; first = false, piece = pieceFrom(numbered_, piece.end, end)) {
    if (goesOn && !goesOn(float(piece.begin) / float(std::max(end, 1u)))) throw Error("the build was cancelled");
    GpuCommands commands(gpu_);
    if (first) {
      zero(commands, kBindBuildReport);
      commands.pass("clear", [&] { clearGrid(commands); });
    }
    commands.pass("build", [&] { add(commands, builder, piece); });
    PassTimes measured = commands.run();
    times.clear += measured["clear"];
    times.add += measured["build"];
  }
  return readReport("build");
}

UpdateReport GpuStages::updateAll(Builder builder, BuildTimes& times) {
  GpuCommands commands(gpu_);
  zero(commands, kBindBuildReport);
  commands.pass("update_clear", [&] { programs_.dispatch(commands, "update_clear", parameters_.grid.cellCount); });
  commands.pass("update_add", [&] { add(commands, builder, {numbered_.staticInstanceCount, numbered_.instanceCount()}); });
  PassTimes measured = commands.run();
  times = {measured["update_clear"], measured["update_add"]};
  UpdateReport report;
  report.added = readReport("update");
  report.cellsTouched = uint32_t(parameters_.grid.cellCount.x * parameters_.grid.cellCount.y * parameters_.grid.cellCount.z);
  return report;
}

// In a cell without dynamic refusals the grid still knows every dynamic reference that was offered: taking the moved ones out and
// offering them again gives what a full update gives. Where dynamic references had been refused, all of them are offered again.
UpdateReport GpuStages::updateMoved(std::span<const uint32_t> moved, BuildTimes& times) {
  ivec3 cells = parameters_.grid.cellCount;
  if (!buffers_[kBindCellMarks]) makeBuffer(kBindCellMarks, "cell marks", uint64_t(cells.x) * cells.y * cells.z * sizeof(uint32_t));
  std::vector<uint32_t> bits(numbered_.instanceCount() / 32 + 1, 0);
  for (uint32_t instance : moved) bits[instance / 32] |= 1u << (instance % 32);
  write(kBindMovedInstances, std::span<const uint32_t>(bits));
  InstanceRange dynamic{numbered_.staticInstanceCount, numbered_.instanceCount()};

  GpuCommands commands(gpu_);
  zero(commands, kBindBuildReport);
  zero(commands, kBindUpdateCounts);
  commands.pass("update_clear", [&] {
    // Mark the cells that moved instances leave and enter.
    zero(commands, kBindCellMarks);
    commands.barrier();
    walk(commands, "mark", dynamic, kTakeMoved);
    transform(commands, dynamic, kTakeMoved);
    walk(commands, "mark", dynamic, kTakeMoved);
    programs_.dispatch(commands, "update_moved", cells);
  });
  commands.pass("update_add", [&] {
    walk(commands, "insert", dynamic, kTakeMoved);
    walk(commands, "restore", dynamic, kTakeOthers);
  });
  PassTimes measured = commands.run();
  times = {measured["update_clear"], measured["update_add"]};
  UpdateReport report;
  report.added = readReport("update");
  std::vector<uint32_t> counts = read<uint32_t>(kBindUpdateCounts, 2);
  report.cellsTouched = counts[0];
  report.cellsRebuilt = counts[1];
  return report;
}

GridTotals GpuStages::countGrid() {
  GpuCommands commands(gpu_);
  zero(commands, kBindStatistics);
  zero(commands, kBindHistogram);
  commands.barrier();
  programs_.dispatch(commands, "statistics", parameters_.grid.cellCount);
  commands.barrier();
  commands.run();
  GridTotals totals;
  totals.statistics = read<GridStatistics>(kBindStatistics, 1)[0];
  totals.occupancyHistogram = read<uint32_t>(kBindHistogram, size_t(parameters_.grid.capacity) + 1);
  ivec3 cells = parameters_.grid.cellCount;
  totals.occupancyHistogram[0] = uint32_t(cells.x * cells.y * cells.z) - totals.statistics.occupied;
  return totals;
}

std::vector<uint32_t> GpuStages::readGrid() {
  ivec3 texels = gridTexelCount(parameters_.grid);
  std::vector<uint32_t> values(size_t(texels.x) * texels.y * texels.z);
  downloadImage(gpu_, grid_, std::as_writable_bytes(std::span(values)));
  return values;
}

void GpuStages::writeGrid(std::span<const uint32_t> texels) { uploadImage(gpu_, grid_, std::as_bytes(texels)); }

}  // namespace gridscope
