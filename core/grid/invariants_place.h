// What must hold of a grid beside its triangles: each is where the overlap test puts it, and nothing dynamic is left from an earlier frame.
#pragma once

#include "core/grid/demand.h"
#include "core/grid/invariants.h"

namespace gridscope {

struct PlaceInput {
  const Grid& grid;
  const Demand& demand;      // of the present world triangles
  bool dynamicAdded = true;  // false: after a build, before the first update: no dynamic reference may be there
};

// A cell holds no static reference that its overlap test turns down, lacks none while it has room, keeps the statics first, and of
// sorted insertion the smallest of what it was asked to take.
Invariant testPlacement(const PlaceInput& input);

// A cell holds no dynamic reference that its overlap test turns down now.
Invariant testStale(const PlaceInput& input);

}  // namespace gridscope
