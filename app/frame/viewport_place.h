// Where in a pane a frame lies: fitted, zoomed at a point, moved, and moved so that a pixel can be seen. No ImGui here. Sizes and places are
// pixels of the screen from the pane's upper left corner, unless they are of the frame.
#pragma once

#include "app/frame/showing.h"

namespace gridscope {

inline constexpr float kMostZoom = 64.0f;  // screen pixels a frame pixel

// Of one frame in one pane.
struct PlacedFrame {
  vec2 origin{0.0f};   // of the frame's upper left corner
  float scale = 1.0f;  // screen pixels a frame pixel
};

float fitScale(vec2 frame, vec2 pane);
PlacedFrame placeFrame(const ViewportPlace& place, vec2 frame, vec2 pane);

// `steps` of the wheel: what is under the mouse stays there; no smaller than fitted.
ViewportPlace zoomedAt(const ViewportPlace& place, vec2 frame, vec2 pane, vec2 mouse, float steps);
ViewportPlace movedBy(const ViewportPlace& place, vec2 frame, vec2 pane, vec2 way);

// The same place where a pixel of the frame is in the pane already, else with the pixel in its middle.
ViewportPlace showingPixel(const ViewportPlace& place, vec2 frame, vec2 pane, vec2 pixel);

// The place of a frame of another size that covers the same part of the pane.
ViewportPlace placeForSize(const ViewportPlace& place, vec2 frame, vec2 other);

}  // namespace gridscope
