// One pixel's story in three short sentences, for the window: what its ray should have shown, what kept it from that, and how it ended.
// pixel_story.h tells it at length.
#pragma once

#include "app/report/pixel_story.h"

namespace gridscope {

std::vector<StoryPart> tellBriefly(const StoryInput& input);

// What was done to the ray for a proof by one event: "With the triangle added".
const char* proofWords(uint32_t cause);

}  // namespace gridscope
