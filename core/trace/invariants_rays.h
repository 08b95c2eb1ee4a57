// What must hold of a trace's hits: every ray ended with a reason, and names a triangle of the scene where it should.
#pragma once

#include <span>

#include "core/grid/invariants.h"
#include "core/trace/trace.h"

namespace gridscope {

// No ray was left unfinished or cut short, and pixels without a ray have no hit.
Invariant testEnds(std::span<const Ray> rays, std::span<const Hit> hits);

// A triangle or voxel hit names a triangle of the scene, at a finite distance that is not before tMin (a voxel hit: not negative).
Invariant testHits(const NumberedScene& scene, const TraceParameters& trace, std::span<const Hit> hits);

// The grid is what it was before the trace.
Invariant testGridKept(const Grid& before, const Grid& after);

}  // namespace gridscope
