// See pick_cell.h.
#include "app/frame/pick_cell.h"

#include <algorithm>
#include <limits>

namespace gridscope {

EyeRay eyeRay(const CameraParameters& camera, vec2 pixel) {
  const vec2 place = pixel / vec2(camera.width, camera.height) * 2.0f - 1.0f;
  return {camera.eye,
          glm::normalize(camera.forward + camera.right * (place.x * camera.tanHalfWidth) - camera.up * (place.y * camera.tanHalfHeight))};
}

// Slabs: Kay and Kajiya, Ray Tracing Complex Scenes, 1986.
std::optional<float> boxEntry(const EyeRay& ray, const Bounds& bounds) {
  float enter = 0.0f, leave = std::numeric_limits<float>::max();
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0.0f) {
      if (ray.origin[axis] < bounds.low[axis] || ray.origin[axis] > bounds.high[axis]) return std::nullopt;
      continue;
    }
    const float a = (bounds.low[axis] - ray.origin[axis]) / ray.direction[axis],
                b = (bounds.high[axis] - ray.origin[axis]) / ray.direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter > leave || enter <= 0.0f) return std::nullopt;
  return enter;
}

std::optional<ivec3> pickCell(const FrameSnapshot& frame, const CameraParameters& camera, vec2 pixel, std::span<const BoxCell> boxes) {
  const GridParameters& grid = frame.gridShape();
  const GatherPixel* seen = nullptr;
  if (pixel.x >= 0.0f && pixel.y >= 0.0f && pixel.x < float(camera.width) && pixel.y < float(camera.height) && frame.gather) {
    const size_t index = size_t(pixel.y) * camera.width + size_t(pixel.x);
    if (index < frame.gather->size() && (*frame.gather)[index].reference != kNoReference) seen = &(*frame.gather)[index];
  }

  // The nearest box that the surface does not hide.
  const EyeRay ray = eyeRay(camera, pixel);
  float nearest = seen ? seen->depth + grid.cellEdge : std::numeric_limits<float>::max();
  std::optional<ivec3> cell;
  for (const BoxCell& box : boxes) {
    const std::optional<float> entry = boxEntry(ray, cellBounds(grid, box.full.cell));
    if (entry && *entry < nearest) nearest = *entry, cell = box.full.cell;
  }
  if (cell || !seen) return cell;
  const ivec3 own = gridCell(grid, seen->position);
  return gridContains(grid, own) ? std::optional(own) : std::nullopt;
}

}  // namespace gridscope
