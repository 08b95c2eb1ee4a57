// What one pane of the viewport shows of the frame, for what is drawn over it.
#pragma once

#include <imgui.h>

#include "shaders/shared/trace/frame.h"

namespace gridscope {

struct PaneRect {
  ImVec2 min, max;            // of the pane on the screen, pixels
  ImVec2 origin;              // screen place of the frame's upper left corner; may lie outside the pane
  float scale = 1.0f;         // screen pixels a frame pixel
  CameraParameters camera{};  // that the frame was gathered from
  int pane = 0;               // 0..3
  ImVec2 legend{0, 0};        // size of the view's legend in the lower right corner; 0: none

  // (0, 0): the first pixel's corner.
  ImVec2 toScreen(vec2 pixel) const { return {origin.x + pixel.x * scale, origin.y + pixel.y * scale}; }
  vec2 toPixel(ImVec2 place) const { return {(place.x - origin.x) / scale, (place.y - origin.y) / scale}; }
};

}  // namespace gridscope
