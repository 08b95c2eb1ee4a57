// See truth_marks.h.
#include "app/ui/panels/truth_marks.h"

#include "shaders/shared/trace/ray.h"
#include "shaders/shared/truth/truth.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

uint32_t hitKindColour(uint32_t kind) {
  switch (kind) {
    case kHitTriangle: return kColourTriangleHit;
    case kHitVoxel: return kColourVoxelHit;
    default: return kColourMiss;
  }
}

uint32_t verdictColour(uint32_t verdict) {
  switch (verdict) {
    case kVerdictAgrees: return kColourTriangleHit;
    case kVerdictHole: return kColourHole;
    case kVerdictVoxelRight: return kColourVoxelRight;
    case kVerdictVoxelWrong: return kColourVoxelWrong;
    case kVerdictTooFar: return kColourTooFar;
    case kVerdictTooNear: return kColourTooNear;
    default: return kColourEmpty;
  }
}

uint32_t causeColour(uint32_t cause) {
  switch (cause) {
    case kCauseRefused: return kColourSaturated;
    case kCauseSteppedOver: return kColourHole;
    case kCauseRevisit: return kColourRevisit;
    case kCauseSegmentEnd: return kColourTooFar;
    case kCauseAcceptedEarly: return kColourTooNear;
    case kCauseGate: return kColourGate;
    case kCauseFilledEarly: return kColourVoxelWrong;
    case kCauseNumeric: return kColourSelected;
    default: return kColourEmpty;
  }
}

}  // namespace gridscope
