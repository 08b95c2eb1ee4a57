// Finds the first event that makes a ray differ from the exact answer, in the record of its trace. TRUTH.md says what counts as which
// event.
#pragma once

#include "core/truth/truth.h"

namespace gridscope {

// An event that makes a ray differ. Also what an edited trace can do without (edits.h).
struct TruthEvent {
  uint32_t cause = kCauseNumeric;
  ivec3 cell{-1};                     // where it took place; (-1, -1, -1): nowhere in the grid
  uint32_t reference = kNoReference;  // that it is about
  int32_t segment = -1;               // at which it took place (StepRecord::segment)
  float along = 0.0f;  // where it took place along the ray, world units: the start of that step. A finding, no part of what it is
  bool operator==(const TruthEvent& other) const {
    return cause == other.cause && cell == other.cell && reference == other.reference && segment == other.segment;
  }
};

// The first event in a record whose end does not agree with `exact`. The record may be an edited trace's.
TruthEvent findEvent(const TruthInput& input, const Ray& ray, const RayRecord& record, const Hit& exact);

// The rule by which a hit that was traced elsewhere differs from one under this trace's rules (the exact hit, or its own record's): alpha or
// self-hit; otherwise numeric.
TruthEvent findForeignEvent(const TruthInput& input, const Ray& ray, const Hit& traced, const Hit& ruled);

// The triangle of a reference that the scene has.
const Triangle& referencedTriangle(const TraceInput& input, uint32_t reference);

// Where a ray enters and leaves a cell: low > high when it misses it.
vec2 cellStay(const GridParameters& grid, const Ray& ray, ivec3 cell);

// The steps' place in a frame's own rules: the window in which a step accepts hits.
vec2 stepWindow(const TraceParameters& trace, const StepRecord& step);

}  // namespace gridscope
