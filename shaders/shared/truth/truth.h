// What a ray's hit is worth beside the exact one: a verdict, and for every ray that does not agree the one cause. core/truth/truth.h says how
// they are found.
#ifndef GRIDSCOPE_SHARED_TRUTH_H
#define GRIDSCOPE_SHARED_TRUTH_H

#include "shaders/shared/scene/scene.h"

BEGIN_SHARED

const uint kVerdictNoRay = 0u;       // the pixel has no ray
const uint kVerdictAgrees = 1u;      // both miss, or a triangle hit within kAgreement of the exact distance
const uint kVerdictHole = 2u;        // a surface is there, the ray missed everything
const uint kVerdictVoxelRight = 3u;  // a voxel hit within a cell's diagonal of the true surface
const uint kVerdictVoxelWrong = 4u;  // every other voxel hit
const uint kVerdictTooFar = 5u;      // a triangle hit behind the true surface
const uint kVerdictTooNear = 6u;     // a triangle hit before it, or where there is none
const uint kVerdictCount = 7u;

const uint kCauseNone = 0u;           // the ray agrees, or there is none
const uint kCauseRefused = 1u;        // the reference of the exact hit found no slot in the cell that the hit lies in
const uint kCauseSteppedOver = 2u;    // that cell was never queried
const uint kCauseRevisit = 3u;        // it was skipped as the cell visited last
const uint kCauseSegmentEnd = 4u;     // queried, but the hit lay outside the elongated segment
const uint kCauseAcceptedEarly = 5u;  // a farther hit of an earlier cell was accepted first
const uint kCauseGate = 6u;           // the cell is saturated, but gap-filling was held back near the launching surface
const uint kCauseFilledEarly = 7u;    // a voxel hit of an earlier saturated cell ended the ray
const uint kCauseAlpha = 8u;          // alpha keying turned the hit down, or let it through
const uint kCauseSelfHit = 9u;        // tMin hid or made a hit
const uint kCauseOutside = 10u;       // surface or ray outside the grid
const uint kCauseLeftOut = 11u;       // a triangle that load or update left out
const uint kCauseStale = 12u;         // a dynamic reference that the update left or missed
const uint kCauseNotInserted = 13u;   // not there though the cell is not saturated: an invariant is broken
const uint kCauseSegmentLimit = 14u;  // maxSegments ended the ray
const uint kCauseNumeric = 15u;       // an edge within rounding: the rest
const uint kCauseCount = 16u;

// Largest difference of two distances that agree, cell edges.
const float kAgreement = 1e-3f;

struct RayTruth {
  uint verdict;         // kVerdict...
  uint cause;           // kCause...: the first event along the ray that made it differ
  float exactT;         // of the exact hit, world units along the ray; 0 where there is none
  uint exactReference;  // kNoReference where there is none
  float error;          // traced minus exact distance, cell edges; 0 where either is missing
  ivec3 cell;           // where the event took place; (-1, -1, -1): nowhere in the grid
  uint reference;       // that the event is about; kNoReference: none
  int segment;          // at which it took place (StepRecord::segment); -1: none
};

// A ray that a person would call wrong: voxel hits near the true surface are what gap-filling is for.
SHARED bool verdictWrong(uint verdict) {
  return verdict == kVerdictHole || verdict == kVerdictVoxelWrong || verdict == kVerdictTooFar || verdict == kVerdictTooNear;
}

#ifdef __cplusplus
static_assert(sizeof(RayTruth) == 40);
#endif

END_SHARED

#endif
