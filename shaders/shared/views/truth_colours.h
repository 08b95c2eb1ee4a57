// Colours of verdicts and causes. tests/views/palette_test.cpp holds that people with any kind of colour vision can tell them apart.
#ifndef GRIDSCOPE_SHARED_TRUTH_COLOURS_H
#define GRIDSCOPE_SHARED_TRUTH_COLOURS_H

#include "shaders/shared/truth/truth.h"
#include "shaders/shared/views/palette.h"

BEGIN_SHARED

// By cause, 0xRRGGBB. Refused (which is hatched), stepped over, revisit and gate keep the colours that they have everywhere.
const uint kCauseColours[16] = LIST_BEGIN(uint, 16) 0x000000u,  // none
    0xF06EB8u,                                                  // refused
    0xF05A28u,                                                  // stepped over
    0xA99BE0u,                                                  // revisit
    0xA6FF00u,                                                  // segment end
    0xE9EFFFu,                                                  // accepted early
    0xC58A5Cu,                                                  // gate
    0xF2D972u,                                                  // filled early
    0x61A69Du,                                                  // alpha
    0x65FFB9u,                                                  // self-hit
    0x255F53u,                                                  // outside
    0x841100u,                                                  // left out
    0xC05FFFu,                                                  // stale
    0x3200FFu,                                                  // not inserted
    0x6C0070u,                                                  // segment limit
    0x6500AEu                                                   // numeric
    LIST_END;

// What changes among first-come builds.
const uint kColourRayChanges = 0xF4E04Du;
const uint kColourSetDiffers = 0xD9622Bu;
const uint kColourOrderDiffers = 0x3F6FB5u;

// 0xRRGGBB; agreement has none: it shows the picture.
SHARED uint verdictColour(uint verdict) {
  if (verdict == kVerdictHole) return kColourHole;
  if (verdict == kVerdictVoxelRight) return kColourVoxelRight;
  if (verdict == kVerdictVoxelWrong) return kColourVoxelWrong;
  if (verdict == kVerdictTooFar) return kColourTooFar;
  if (verdict == kVerdictTooNear) return kColourTooNear;
  return kColourDim;
}

SHARED uint causeColour(uint cause) { return cause > kCauseNone && cause < kCauseCount ? kCauseColours[int(cause)] : kColourDim; }

END_SHARED

#endif
