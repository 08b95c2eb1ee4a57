// The colours of verdicts, causes and kinds of hits in tables: those of the views, 0xRRGGBB of the dark theme.
#pragma once

#include <cstdint>

namespace gridscope {

uint32_t hitKindColour(uint32_t kind);     // kHit...
uint32_t verdictColour(uint32_t verdict);  // kVerdict...
uint32_t causeColour(uint32_t cause);      // kCause...

}  // namespace gridscope
