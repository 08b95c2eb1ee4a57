// Every constant that derives from settings, computed once, in double, rounded to the float that all devices read.
#include "core/grid/derive.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "core/base/error.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/grid/grid.h"
#include "shaders/shared/grid/layout.h"

namespace gridscope {

namespace {

// Cells along one axis of a grid: what 16 bits count.
constexpr double kMostCellsPerSide = 65535.0;

// Slots of a cell: one segment with a test for every slot stays well within the loop budget, and a stretched axis within 31 bits.
constexpr uint32_t kMostCapacity = 16384;

// Slots of a cell on a device: a group of 8 invocations that walk one cell each must stay within the loop budget.
constexpr uint32_t kMostDeviceCapacity = kLoopBudget / 8 - 2;

// A cell edge must be this many times the distance of neighbouring floats at the bounds: a cell's faces and centre are then distinct.
constexpr float kFloatsPerCell = 16.0f;

float largest(const vec3& v) { return std::max(v.x, std::max(v.y, v.z)); }

Bounds checkBounds(const GridSettings& settings, const Bounds& sceneBounds) {
  const Bounds& bounds = settings.bounds ? *settings.bounds : sceneBounds;
  const char* name = settings.bounds ? "--bounds" : "the scene's bounds";
  if (!isFinite(bounds.low) || !isFinite(bounds.high))
    throw Error(printed("%s: not finite; give --bounds minx,miny,minz,maxx,maxy,maxz", name));
  for (int axis = 0; axis < 3; ++axis)
    if (bounds.low[axis] > bounds.high[axis])
      throw Error(printed("%s: the low end %g lies above the high end %g on %c; give --bounds minx,miny,minz,maxx,maxy,maxz", name,
                          bounds.low[axis], bounds.high[axis], "xyz"[axis]));
  if (largest(abs(bounds.low)) > kCoordinateLimit || largest(abs(bounds.high)) > kCoordinateLimit)
    throw Error(printed("%s: coordinates beyond %g are not supported; scale the scene down", name, kCoordinateLimit));
  return bounds;
}

void checkCapacity(uint32_t capacity) {
  if (capacity < 1 || capacity > kMostCapacity)
    throw Error(printed("--capacity %u: give a number of slots from 1 to %u", capacity, kMostCapacity));
}

float chooseCellEdge(const GridSettings& settings, const Bounds& bounds) {
  float edge = settings.cellEdge;
  if (edge == 0.0f) {
    if (settings.cells < 1 || settings.cells > kMostCellsPerSide - 2.0)
      throw Error(printed("--cells %u: give a number from 1 to %.0f", settings.cells, kMostCellsPerSide - 2.0));
    edge = static_cast<float>(double(largest(bounds.high - bounds.low)) / settings.cells);
    if (edge == 0.0f) throw Error("the bounds are a single point, so that --cells says nothing; give --cell-edge, or larger --bounds");
  }
  if (!(edge > 0.0f) || !std::isfinite(edge)) throw Error(printed("--cell-edge %g: give a length above 0, in world units", edge));

  const float farthest = std::max(largest(abs(bounds.low)), largest(abs(bounds.high))) + edge;
  const float finest = std::max(kFloatsPerCell * (std::nextafter(farthest, INFINITY) - farthest), 1e-9f);
  if (edge < finest)
    throw Error(
        printed("cells of %g are too fine for coordinates of up to %g, which are %g apart as 32-bit floats; take fewer --cells or a "
                "--cell-edge of at least %g, or move the scene closer to its origin",
                edge, farthest, finest / kFloatsPerCell, finest));
  return edge;
}

// Cells that cover a side, and one more on each end. A side that is a whole number of cells but for rounding gets that number: the
// bit that sticks out, 1e-6 of the side, lies in the cell beyond.
double cellsAlong(double side, double edge) { return std::ceil(side / edge * (1.0 - 1e-6)) + 2.0; }

ivec3 countCells(const Bounds& bounds, float edge) {
  ivec3 count;
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = cellsAlong(double(bounds.high[axis]) - bounds.low[axis], edge);
    if (cells > kMostCellsPerSide)
      throw Error(printed("a cell edge of %g makes %.0f cells along %c; at most %.0f are supported: give a larger --cell-edge", edge, cells,
                          "xyz"[axis], kMostCellsPerSide));
    count[axis] = static_cast<int>(cells);
  }
  return count;
}

int chooseStretchAxis(Stretch stretch, ivec3 cellCount) {
  if (stretch != Stretch::automatic) return static_cast<int>(stretch);
  int axis = 0;
  for (int other = 1; other < 3; ++other)
    if (cellCount[other] < cellCount[axis]) axis = other;
  return axis;
}

// Why a grid does not fit; empty when it does.
std::string misfit(const GridParameters& grid, const GridLimits& limits) {
  const ivec3 texels = gridTexelCount(grid);
  const int side = std::max(texels.x, std::max(texels.y, texels.z));
  const double mebibytes = gridByteCount(grid) / 1048576.0;
  if (limits.maxImageSide != 0 && uint32_t(grid.capacity) > kMostDeviceCapacity)
    return printed("has more than the %u slots a cell that a device's loops may walk", kMostDeviceCapacity);
  if (limits.maxImageSide != 0 && uint32_t(side) > limits.maxImageSide)
    return printed("is an image %d texels long, and at most %u are possible", side, limits.maxImageSide);
  if (limits.maxImageBytes != 0 && gridByteCount(grid) > limits.maxImageBytes)
    return printed("takes %.1f MiB, and one image can hold %.1f", mebibytes, limits.maxImageBytes / 1048576.0);
  if (limits.maxMemoryBytes != 0 && gridByteCount(grid) > limits.maxMemoryBytes)
    return printed("takes %.1f MiB, and %.1f are free", mebibytes, limits.maxMemoryBytes / 1048576.0);
  return "";
}

// The same grid with another cell edge: cell counts as deriveGrid() would make them, or a little more, for the exact sides are not known here.
GridParameters withCellEdge(const GridSettings& settings, GridParameters grid, double edge) {
  for (int axis = 0; axis < 3; ++axis) {
    const double side = (grid.cellCount[axis] - 2) * double(grid.cellEdge) * (1.0 + 2e-6);
    grid.cellCount[axis] = static_cast<int>(std::min(cellsAlong(side, edge), kMostCellsPerSide));
  }
  grid.cellEdge = static_cast<float>(edge);
  grid.stretchAxis = chooseStretchAxis(settings.stretch, grid.cellCount);
  return grid;
}

GridParameters withCapacity(GridParameters grid, uint32_t capacity) {
  grid.capacity = static_cast<int>(capacity);
  grid.stride = grid.capacity + grid.reserved;
  return grid;
}

// The largest number in [1, most] that fits; 0 when none does. What fits is taken to go on fitting below.
uint32_t largestThat(uint32_t most, const std::function<bool(uint32_t)>& fits) {
  uint32_t low = 0, high = most;
  while (low < high) {
    const uint32_t middle = low + (high - low + 1) / 2;
    if (fits(middle))
      low = middle;
    else
      high = middle - 1;
  }
  return low;
}

// The nearest settings that fit, as options.
std::string adviseSettings(const GridSettings& settings, const GridParameters& grid, const GridLimits& limits) {
  auto fits = [&](const GridParameters& other) { return misfit(other, limits).empty(); };
  const double longest = std::max(grid.cellCount.x, std::max(grid.cellCount.y, grid.cellCount.z)) - 2.0;  // in cells
  const uint32_t cells = largestThat(static_cast<uint32_t>(std::max(longest, 1.0)),
                                     [&](uint32_t n) { return fits(withCellEdge(settings, grid, longest * grid.cellEdge / n)); });
  const uint32_t capacity = largestThat(static_cast<uint32_t>(grid.capacity), [&](uint32_t n) { return fits(withCapacity(grid, n)); });

  std::string advice;
  if (cells > 0 && settings.cellEdge > 0.0f) advice = printed("--cell-edge %.6g fits", longest * grid.cellEdge / cells * 1.00001);
  if (cells > 0 && settings.cellEdge == 0.0f) advice = printed("--cells %u fits", cells);
  if (capacity > 0) advice += printed("%s--capacity %u fits", advice.empty() ? "" : ", or ", capacity);
  return advice.empty() ? "smaller --bounds may fit" : advice;
}

}  // namespace

uint32_t cellsPerInvocation(int capacity) { return std::max(1u, kLoopBudget / (8 * (static_cast<uint32_t>(capacity) + 2))); }

Stretch stretchOf(const GridParameters& grid) { return Stretch(grid.stretchAxis); }

GridParameters laidOutHere(GridParameters grid) {
  grid.reserved = 2;
  grid.stride = grid.capacity + grid.reserved;
  grid.cellsPerInvocation = cellsPerInvocation(grid.capacity);
  return grid;
}

void deriveFromEdge(const GridSettings& settings, GridParameters& grid) {
  const double radius = double(settings.enlargement) * grid.cellEdge * std::sqrt(3.0) / 2.0;
  grid.inverseCellEdge = divide(1.0f, grid.cellEdge);
  grid.planeRadiusSquared = static_cast<float>(radius * radius);
  grid.boxHalfEdge = static_cast<float>(double(settings.enlargement) * grid.cellEdge / 2.0);
  grid.overlap = settings.overlap;
  grid.insertion = settings.insertion;
  grid.cellsPerInvocation = cellsPerInvocation(grid.capacity);
}

GridParameters deriveGrid(const GridSettings& settings, const Bounds& sceneBounds, const NumberedScene& scene) {
  const Bounds bounds = checkBounds(settings, sceneBounds);
  checkCapacity(settings.capacity);
  checkNumber("--enlargement", settings.enlargement, 0.01f, 100.0f);

  // Shape.
  GridParameters grid{};
  grid.cellEdge = chooseCellEdge(settings, bounds);
  grid.cellCount = countCells(bounds, grid.cellEdge);
  grid.origin = vec3(stored(bounds.low.x - grid.cellEdge), stored(bounds.low.y - grid.cellEdge), stored(bounds.low.z - grid.cellEdge));
  grid.capacity = static_cast<int>(settings.capacity);
  grid.reserved = 2;
  grid.stride = grid.capacity + grid.reserved;
  grid.stretchAxis = chooseStretchAxis(settings.stretch, grid.cellCount);

  deriveFromEdge(settings, grid);
  CHECK(gridContains(grid, gridCell(grid, bounds.low)));
  CHECK(gridContains(grid, gridCell(grid, bounds.high)));

  // What the scene says.
  grid.staticInstanceCount = scene.staticInstanceCount;
  grid.instanceCount = scene.instanceCount();
  grid.staticTriangleCount = scene.staticTriangleCount;
  grid.triangleCount = scene.triangleCount;
  return grid;
}

void checkGridFits(const GridSettings& settings, const GridParameters& grid, const GridLimits& limits) {
  const std::string reason = misfit(grid, limits);
  if (reason.empty()) return;
  const std::string shape =
      printed("a grid of %d x %d x %d cells with capacity %d ", grid.cellCount.x, grid.cellCount.y, grid.cellCount.z, grid.capacity);
  const std::string device = *limits.device == '\0' ? "" : printed(" on %s", limits.device);
  throw Error(shape + reason + device + "; " + adviseSettings(settings, grid, limits), kExitDevice);
}

}  // namespace gridscope
