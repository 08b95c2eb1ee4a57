// Which cell lies under the mouse: that of the nearest drawn box, or of the surface that the frame shows there. No ImGui here.
#pragma once

#include <optional>
#include <span>

#include "app/frame/cell_boxes.h"

namespace gridscope {

// A ray from the eye through a place of the frame; (0, 0) is the upper left corner of the first pixel. The direction is a unit vector.
struct EyeRay {
  vec3 origin{0.0f}, direction{0.0f};
};
EyeRay eyeRay(const CameraParameters& camera, vec2 pixel);

// Where a ray enters a box, world units; nothing where it misses it or starts inside.
std::optional<float> boxEntry(const EyeRay& ray, const Bounds& bounds);

// `boxes`: those that are drawn. A box counts where its front lies before the surface under the mouse, or within a cell edge behind it.
std::optional<ivec3> pickCell(const FrameSnapshot& frame, const CameraParameters& camera, vec2 pixel, std::span<const BoxCell> boxes);

}  // namespace gridscope
