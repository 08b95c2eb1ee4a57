// See viewport_place.h.
#include "app/frame/viewport_place.h"

#include <algorithm>
#include <cmath>

namespace gridscope {

float fitScale(vec2 frame, vec2 pane) { return std::min(pane.x / std::max(frame.x, 1.0f), pane.y / std::max(frame.y, 1.0f)); }

PlacedFrame placeFrame(const ViewportPlace& place, vec2 frame, vec2 pane) {
  const bool zoomed = place.zoom > 0.0f;
  const float scale = zoomed ? place.zoom : fitScale(frame, pane);
  return {0.5f * pane - (zoomed ? place.centre : vec2(0.5f)) * frame * scale, scale};
}

ViewportPlace zoomedAt(const ViewportPlace& place, vec2 frame, vec2 pane, vec2 mouse, float steps) {
  const PlacedFrame before = placeFrame(place, frame, pane);
  const float fit = fitScale(frame, pane);
  const float zoom = std::clamp(before.scale * std::pow(1.25f, steps), fit, std::max(fit, kMostZoom));
  if (zoom <= fit * 1.001f) return {};
  const vec2 pixel = (mouse - before.origin) / before.scale;
  return {zoom, glm::clamp((pixel + (0.5f * pane - mouse) / zoom) / frame, vec2(0.0f), vec2(1.0f))};
}

ViewportPlace movedBy(const ViewportPlace& place, vec2 frame, vec2 pane, vec2 way) {
  if (place.zoom <= 0.0f) return place;
  const float scale = placeFrame(place, frame, pane).scale;
  return {place.zoom, glm::clamp(place.centre - way / scale / frame, vec2(0.0f), vec2(1.0f))};
}

ViewportPlace showingPixel(const ViewportPlace& place, vec2 frame, vec2 pane, vec2 pixel) {
  if (place.zoom <= 0.0f) return place;
  const PlacedFrame placed = placeFrame(place, frame, pane);
  const vec2 at = placed.origin + pixel * placed.scale;
  const bool seen = at.x >= 0.0f && at.y >= 0.0f && at.x <= pane.x && at.y <= pane.y;
  return seen ? place : ViewportPlace{place.zoom, glm::clamp(pixel / frame, vec2(0.0f), vec2(1.0f))};
}

ViewportPlace placeForSize(const ViewportPlace& place, vec2 frame, vec2 other) {
  return {place.zoom * frame.x / std::max(other.x, 1.0f), place.centre};
}

}  // namespace gridscope
