// What is found out about a frame's cells beside its products, for views and tables. Cells are listed x fastest, then y, then z.
#ifndef GRIDSCOPE_SHARED_FINDINGS_H
#define GRIDSCOPE_SHARED_FINDINGS_H

#include "shaders/shared/grid/grid.h"
#include "shaders/shared/truth/truth.h"

BEGIN_SHARED

// Whether a cell comes out alike in every first-come build.
const uint kStable = 0u;
const uint kStableSet = 1u;  // it holds the same references in every build, but their order differs
const uint kUnstable = 2u;   // which references it holds differs

// What the last update did to a cell's dynamic references.
struct CellUpdate {
  uint cleared;   // held before, no longer
  uint filled;    // held now, not before
  uint kept;      // held before and now: taken out and put back where the update clears everything
  uint instance;  // whose references changed; the first of the cleared or filled ones; of the kept ones where none changed;
                  // kBlank: no dynamic reference before or now
};

SHARED uint cellCountOf(GridParameters grid) { return uint(grid.cellCount.x) * uint(grid.cellCount.y) * uint(grid.cellCount.z); }

// Place of a cell of the grid in such a list.
SHARED uint cellNumber(GridParameters grid, ivec3 cell) {
  return (uint(cell.z) * uint(grid.cellCount.y) + uint(cell.y)) * uint(grid.cellCount.x) + uint(cell.x);
}

#ifdef __cplusplus
static_assert(sizeof(CellUpdate) == 16);
#endif

END_SHARED

#endif
