// A layer of cells as a picture.
#ifndef GRIDSCOPE_SHARED_SLICE_H
#define GRIDSCOPE_SHARED_SLICE_H

#include "shaders/shared/grid/grid.h"

BEGIN_SHARED

// A slice shows one layer of cells as a person stands before it: row 0 is the top. Across x and z up is y; across y (from above) the
// rows run along z.
SHARED int sliceColumnAxis(int sliceAxis) { return sliceAxis == 0 ? 2 : 0; }
SHARED int sliceRowAxis(int sliceAxis) { return sliceAxis == 1 ? 2 : 1; }

// Columns and rows of a slice's image: ViewParameters' width and height.
SHARED uvec2 sliceSize(ivec3 cellCount, int sliceAxis) {
  return uvec2(uint(cellCount[sliceColumnAxis(sliceAxis)]), uint(cellCount[sliceRowAxis(sliceAxis)]));
}

// The cell of an element of a slice.
SHARED ivec3 sliceCell(ivec3 cellCount, int sliceAxis, int sliceIndex, uint element) {
  uvec2 size = sliceSize(cellCount, sliceAxis);
  int row = int(element / size.x);
  ivec3 cell = ivec3(sliceIndex, sliceIndex, sliceIndex);
  cell[sliceColumnAxis(sliceAxis)] = int(element % size.x);
  cell[sliceRowAxis(sliceAxis)] = sliceAxis == 1 ? row : int(size.y) - 1 - row;
  return cell;
}

END_SHARED

#endif
