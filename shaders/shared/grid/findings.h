// What is found out about cells beside the products, for views and tables; an element a cell (cellNumber() in grid.h).
#ifndef GRIDSCOPE_SHARED_FINDINGS_H
#define GRIDSCOPE_SHARED_FINDINGS_H

#include "shaders/shared/grid/grid.h"

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
                  // kNoReference: no dynamic reference before or now
};

#ifdef __cplusplus
static_assert(sizeof(CellUpdate) == 16);
#endif

END_SHARED

#endif
