// How the fixed-capacity grid is stored: one 3D image, one axis stretched. A cell owns `capacity` slots in a row along it and `reserved` texels
// after them. Only the grid's own rooms include this.
#ifndef GRIDSCOPE_SHARED_GRID_LAYOUT_H
#define GRIDSCOPE_SHARED_GRID_LAYOUT_H

#include "shaders/shared/grid/grid.h"

BEGIN_SHARED

// Texel of a cell's slot; slots at and beyond the capacity are the reserved texels.
SHARED ivec3 gridTexel(GridParameters grid, ivec3 cell, int slot) {
  ivec3 texel = cell;
  texel[grid.stretchAxis] = cell[grid.stretchAxis] * grid.stride + slot;
  return texel;
}

// Texel that counts the static or dynamic references a cell refused (two reserved texels).
SHARED ivec3 gridRefusedTexel(GridParameters grid, ivec3 cell, bool isDynamic) {
  return gridTexel(grid, cell, grid.capacity + (isDynamic ? 1 : 0));
}

SHARED ivec3 gridTexelCount(GridParameters grid) {
  ivec3 count = grid.cellCount;
  count[grid.stretchAxis] = count[grid.stretchAxis] * grid.stride;
  return count;
}

END_SHARED

#endif
