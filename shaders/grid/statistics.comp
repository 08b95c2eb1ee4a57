// Counts references, refusals and the occupancy of all cells, in integers.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"
layout(scalar, set = 0, binding = kBindStatistics) buffer StatisticsBuffer { GridStatistics statistics; };
layout(scalar, set = 0, binding = kBindHistogram) buffer HistogramBuffer { uint histogram[]; };

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID);
  GridParameters grid = gridParameters();
  if (!gridContains(grid, cell)) return;
  uint firstDynamic = firstDynamicReference(grid);
  uint fixedCount = 0u;
  uint dynamicCount = 0u;
  CellList list = cellList(grid, cell);
  for (int place = 0; place < list.most; ++place) {
    uint reference = listReference(grid, list, place);
    if (reference == kNoReference) break;
    if (reference < firstDynamic) ++fixedCount;
    else ++dynamicCount;
  }
  uint occupancy = fixedCount + dynamicCount;
  if (occupancy == 0u) return;  // histogram[0] is what is left over

  uint fixedRefused = grid.reserved == 2 ? slotLoad(gridRefusedTexel(grid, cell, false)) : 0u;
  uint dynamicRefused = grid.reserved == 2 ? slotLoad(gridRefusedTexel(grid, cell, true)) : 0u;
  bool saturated = cellRefused(grid, cell, int(occupancy)) != 0u;

  atomicAdd(histogram[occupancy], 1u);
  atomicAdd(statistics.occupied, 1u);
  if (fixedCount > 0u) atomicAdd(statistics.staticStored, fixedCount);
  if (dynamicCount > 0u) atomicAdd(statistics.dynamicStored, dynamicCount);
  if (fixedRefused > 0u) atomicAdd(statistics.staticRefused, fixedRefused);
  if (dynamicRefused > 0u) atomicAdd(statistics.dynamicRefused, dynamicRefused);
  if (saturated) atomicAdd(statistics.saturated, 1u);
  atomicMax(statistics.maxDemand, occupancy + fixedRefused + dynamicRefused);
}
