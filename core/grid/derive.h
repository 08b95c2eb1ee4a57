// From settings to the parameters that the stages read: every derived constant is computed here, once, and passed on as bits.
#pragma once

#include "core/grid/settings.h"
#include "shaders/shared/grid/parameters.h"

namespace gridscope {

// The loop iterations that lavapipe grants a group of 8 invocations before it quietly ends every loop. Every device gets work cut to it:
// it costs nothing elsewhere.
inline constexpr uint32_t kLoopBudget = 65535;

// How many cells an invocation of a build may walk, so that its loops stay within that budget.
uint32_t cellsPerInvocation(int capacity);

// The grid for a scene's bounds: `bounds` covered by cubes, one cell more on each side. Throws Error for impossible settings (capacity 0,
// no cells, bounds that are empty or not finite) and for grids beyond the format's limits.
GridParameters deriveGrid(const GridSettings& settings, const Bounds& sceneBounds, const NumberedScene& scene);

// What derives from the cell edge, the capacity and the settings of overlap and insertion.
void deriveFromEdge(const GridSettings& settings, GridParameters& grid);

// The setting that makes the grid's stretched axis.
Stretch stretchOf(const GridParameters& grid);

// As a build of this program lays out a grid of that shape.
GridParameters laidOutHere(GridParameters grid);

// What a device can hold; the defaults are memory's alone (the C++ path).
struct GridLimits {
  uint32_t maxImageSide = 0;    // texels of a 3D image along any axis; 0: no limit, nor one on loops: no Vulkan device
  uint64_t maxImageBytes = 0;   // of one image; 0: no limit
  uint64_t maxMemoryBytes = 0;  // free memory; 0: unknown
  const char* device = "";
};

// Refuses, before anything is allocated, a grid that does not fit: Error with kExitDevice, with the numbers and the nearest setting that fits.
void checkGridFits(const GridSettings& settings, const GridParameters& grid, const GridLimits& limits);

}  // namespace gridscope
