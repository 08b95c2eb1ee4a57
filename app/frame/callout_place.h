// Where a callout goes so that it hides neither what it is about nor anything else that matters. No ImGui here.
#pragma once

#include <span>

#include "shaders/shared/base/language.h"

namespace gridscope {

struct Area {
  vec2 low{0.0f}, high{0.0f};
};

// The upper left corner of a box of `size` beside the place `at`, within `pane`. Of places around it, near ones first, the one that covers
// the fewest `points` (of a ray on the screen) and the least of the `boxes`.
vec2 placeCallout(const Area& pane, vec2 at, vec2 size, std::span<const vec2> points, std::span<const Area> boxes, float unit);

}  // namespace gridscope
