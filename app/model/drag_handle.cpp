// See drag_handle.h.
#include "app/model/drag_handle.h"

#include <cmath>

#include "app/frame/pick_cell.h"

namespace gridscope {

namespace {

// Where along centre + s * axis the line is nearest to a ray; nothing where they are parallel.
std::optional<float> nearestOnAxis(const vec3& centre, const vec3& axis, const EyeRay& ray) {
  const float along = glm::dot(axis, ray.direction), sine = 1.0f - along * along;
  if (sine < 1e-4f) return std::nullopt;
  const vec3 offset = ray.origin - centre;
  return (glm::dot(offset, axis) - along * glm::dot(offset, ray.direction)) / sine;
}

vec3 onViewPlane(const CameraParameters& camera, const vec3& centre, const EyeRay& ray) {
  const float depth = glm::dot(centre - camera.eye, camera.forward);
  return ray.origin + ray.direction * (depth / glm::dot(ray.direction, camera.forward));
}

}  // namespace

vec3 dragOffset(const CameraParameters& camera, const vec3& centre, DragWay way, vec2 from, vec2 to) {
  const EyeRay before = eyeRay(camera, from), after = eyeRay(camera, to);
  if (way == DragWay::plane) return onViewPlane(camera, centre, after) - onViewPlane(camera, centre, before);
  vec3 axis(0.0f);
  axis[int(way)] = 1.0f;
  const std::optional<float> start = nearestOnAxis(centre, axis, before), end = nearestOnAxis(centre, axis, after);
  return start && end ? axis * (*end - *start) : vec3(0.0f);
}

float worldPerPixel(const CameraParameters& camera, const vec3& point) {
  return 2.0f * camera.tanHalfHeight * std::max(glm::dot(point - camera.eye, camera.forward), camera.nearPlane) / float(camera.height);
}

}  // namespace gridscope
