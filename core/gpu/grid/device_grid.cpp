// See device_grid.h.
#include "core/gpu/grid/device_grid.h"

#include <algorithm>

#include "shaders/shared/gpu/bindings.h"

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

DeviceGrid::DeviceGrid(GpuPrograms& programs, SceneBuffers& scene) : programs_(programs), scene_(scene) {
  BoundResources& bound = programs.bound();
  const uint64_t triangles = scene.numbered().triangleCount;
  bound.makeBuffer(kBindBuildReport, "build report", sizeof(BuildReport));
  bound.makeBuffer(kBindBigTriangles, "lists of big triangles", triangles * kBigClassCount * sizeof(uint32_t));
  bound.makeBuffer(kBindBigDispatch, "big dispatch", sizeof(BigDispatch));
  bound.makeBuffer(kBindStatistics, "statistics", sizeof(GridStatistics));
  bound.makeBuffer(kBindUpdateCounts, "update counts", 2 * sizeof(uint32_t));
}

PassDescription DeviceGrid::rasterPass() {
  return {.stem = "build_raster", .shaders = {"build_raster_vert", "build_raster_geom"}, .draws = DrawTargets{}};
}

void DeviceGrid::make(const GridParameters& grid) {
  const GridStorage storage = gridStorage(grid);
  BoundResources& bound = programs_.bound();
  bound.drop(kBindCellMarks);
  const GpuImage& image =
      bound.makeImage(kBindGrid, storage.name,
                      {.type = VK_IMAGE_TYPE_3D,
                       .viewType = VK_IMAGE_VIEW_TYPE_3D,
                       .format = VK_FORMAT_R32_UINT,
                       .extent = {uint32_t(storage.extent.x), uint32_t(storage.extent.y), uint32_t(storage.extent.z)},
                       .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
  bound.makeBuffer(kBindHistogram, "histogram", (uint64_t(grid.capacity) + 1) * sizeof(uint32_t));
  GpuCommands commands(programs_.gpu());
  commands.layout(image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  commands.run();
}

bool DeviceGrid::made() const { return programs_.bound().has(kBindGrid); }

void DeviceGrid::setParameters(const GridParameters& grid) {
  grid_ = grid;
  programs_.specialize(gridConstants(grid));
}

// The small triangles first, which fills the lists of big ones; then those, class by class.
void DeviceGrid::walk(GpuCommands& commands, const std::string& operation, InstanceRange range, uint32_t take) {
  PassArguments arguments = scene_.argumentsFor(range, take);
  if (arguments.endTriangle == arguments.firstTriangle) return;
  programs_.zero(commands, kBindBigDispatch);
  commands.barrier();
  programs_.dispatch(commands, operation, alongX(arguments.endTriangle - arguments.firstTriangle), bytesOf(arguments));
  commands.barrier();
  walkBig(commands, operation, arguments);
}

void DeviceGrid::walkBig(GpuCommands& commands, const std::string& operation, PassArguments arguments) {
  programs_.dispatch(commands, "big_prepare", {1, 1, 1});
  commands.barrier();
  for (int bigClass = 0; bigClass < kBigClassCount; ++bigClass) {
    arguments.bigClass = uint32_t(bigClass);
    programs_.dispatchIndirect(commands, operation + "_big", kBindBigDispatch, bigClass * sizeof(uvec3), bytesOf(arguments));
  }
  commands.barrier();
}

// The paper's builder: one draw an instance, without attachments, vertex and index buffers.
void DeviceGrid::buildRaster(GpuCommands& commands, InstanceRange range) {
  PassArguments arguments = scene_.argumentsFor(range, kTakeAll);
  programs_.zero(commands, kBindBigDispatch);
  commands.barrier();
  VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
  rendering.renderArea.extent = {1, 1};
  rendering.layerCount = 1;
  vkCmdBeginRendering(commands.handle(), &rendering);
  programs_.draw(commands, rasterPass(), rendering.renderArea.extent, [&] { scene_.drawInstances(commands, range, false); });
  vkCmdEndRendering(commands.handle());
  commands.barrier();
  walkBig(commands, "insert", arguments);
}

void DeviceGrid::add(GpuCommands& commands, Builder builder, InstanceRange range) {
  if (range.begin == range.end) return;
  if (builder == Builder::raster) return buildRaster(commands, range);
  scene_.transform(commands, range, kTakeAll);
  walk(commands, "insert", range, kTakeAll);
}

BuildReport DeviceGrid::readReport(const char* stage) {
  BuildReport report = programs_.read<BuildReport>(kBindBuildReport, 1)[0];
  checkWalked(report, stage);
  return report;
}

BuildReport DeviceGrid::build(Builder builder, BuildTimes& times, const std::function<bool(float)>& goesOn) {
  const uint32_t end = scene_.numbered().staticInstanceCount;
  times = {};
  InstanceRange piece = pieceFrom(scene_.numbered(), 0, end);
  for (bool first = true; first || piece.begin < end; first = false, piece = pieceFrom(scene_.numbered(), piece.end, end)) {
    if (goesOn && !goesOn(float(piece.begin) / float(std::max(end, 1u)))) throw Error("the build was cancelled");
    GpuCommands commands(programs_.gpu());
    if (first) {
      programs_.zero(commands, kBindBuildReport);
      commands.pass("clear", [&] { programs_.dispatch(commands, "grid_clear", gridStorage(grid_).extent); });
    }
    commands.pass("build", [&] { add(commands, builder, piece); });
    PassTimes measured = commands.run();
    times.clear += measured["clear"];
    times.add += measured["build"];
  }
  return readReport("build");
}

UpdateReport DeviceGrid::updateAll(Builder builder, BuildTimes& times) {
  GpuCommands commands(programs_.gpu());
  programs_.zero(commands, kBindBuildReport);
  commands.pass("update_clear", [&] { programs_.dispatch(commands, "update_clear", grid_.cellCount); });
  commands.pass("update_add", [&] { add(commands, builder, scene_.dynamicInstances()); });
  PassTimes measured = commands.run();
  times = {measured["update_clear"], measured["update_add"]};
  UpdateReport report;
  report.added = readReport("update");
  report.cellsTouched = cellCountOf(grid_);
  return report;
}

// In a cell without dynamic refusals the grid still knows every dynamic reference that was offered: taking the moved ones out and
// offering them again gives what a full update gives. Where dynamic references had been refused, all of them are offered again.
UpdateReport DeviceGrid::updateMoved(std::span<const uint32_t> moved, BuildTimes& times) {
  if (!programs_.bound().has(kBindCellMarks))
    programs_.bound().makeBuffer(kBindCellMarks, "cell marks", uint64_t(cellCountOf(grid_)) * sizeof(uint32_t));
  scene_.setMoved(moved);
  const InstanceRange dynamic = scene_.dynamicInstances();

  GpuCommands commands(programs_.gpu());
  programs_.zero(commands, kBindBuildReport);
  programs_.zero(commands, kBindUpdateCounts);
  commands.pass("update_clear", [&] {
    // Mark the cells that moved instances leave and enter.
    programs_.zero(commands, kBindCellMarks);
    commands.barrier();
    walk(commands, "mark", dynamic, kTakeMoved);
    scene_.transform(commands, dynamic, kTakeMoved);
    walk(commands, "mark", dynamic, kTakeMoved);
    programs_.dispatch(commands, "update_moved", grid_.cellCount);
  });
  commands.pass("update_add", [&] {
    walk(commands, "insert", dynamic, kTakeMoved);
    walk(commands, "restore", dynamic, kTakeOthers);
  });
  PassTimes measured = commands.run();
  times = {measured["update_clear"], measured["update_add"]};
  UpdateReport report;
  report.added = readReport("update");
  std::vector<uint32_t> counts = programs_.read<uint32_t>(kBindUpdateCounts, 2);
  report.cellsTouched = counts[0];
  report.cellsRebuilt = counts[1];
  return report;
}

GridTotals DeviceGrid::count() {
  GpuCommands commands(programs_.gpu());
  programs_.zero(commands, kBindStatistics);
  programs_.zero(commands, kBindHistogram);
  commands.barrier();
  programs_.dispatch(commands, "statistics", grid_.cellCount);
  commands.barrier();
  commands.run();
  GridTotals totals;
  totals.statistics = programs_.read<GridStatistics>(kBindStatistics, 1)[0];
  totals.occupancyHistogram = programs_.read<uint32_t>(kBindHistogram, size_t(grid_.capacity) + 1);
  totals.occupancyHistogram[0] = cellCountOf(grid_) - totals.statistics.occupied;
  return totals;
}

std::vector<uint32_t> DeviceGrid::read() const {
  std::vector<uint32_t> words(gridStorage(grid_).wordCount());
  downloadImage(programs_.gpu(), programs_.bound().image(kBindGrid), std::as_writable_bytes(std::span(words)));
  return words;
}

void DeviceGrid::write(std::span<const uint32_t> words) {
  uploadImage(programs_.gpu(), programs_.bound().image(kBindGrid), std::as_bytes(words));
}

}  // namespace gridscope
