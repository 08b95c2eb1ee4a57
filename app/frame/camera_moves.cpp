// See camera_moves.h.
#include "app/frame/camera_moves.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

namespace gridscope {

static constexpr float kSteepest = 1.5533f;  // radians: 89 degrees

vec3 worldUp(const CameraState& camera) { return camera.zUp ? vec3(0, 0, 1) : vec3(0, 1, 0); }

// `direction` turned about the up axis and raised towards it, never quite upright.
static vec3 turned(const vec3& direction, const vec3& up, float turn, float rise) {
  const vec3 unit = glm::normalize(direction);
  const float height = std::asin(std::clamp(glm::dot(unit, up), -1.0f, 1.0f));
  const float wanted = std::clamp(height + rise, -kSteepest, kSteepest);
  vec3 level = unit - up * glm::dot(unit, up);
  if (glm::dot(level, level) < 1e-8f) level = std::abs(up.y) > 0.5f ? vec3(0, 0, 1) : vec3(1, 0, 0);
  level = glm::angleAxis(turn, up) * glm::normalize(level);
  return glm::length(direction) * (level * std::cos(wanted) + up * std::sin(wanted));
}

void aimCamera(CameraState& camera, const FrameSnapshot& frame) {
  if (!frame.gather || !frame.request.settings) return;
  const FrameSettings& settings = *frame.request.settings;
  const size_t middle = size_t(settings.height / 2) * settings.width + settings.width / 2;
  if (middle >= frame.gather->size() || (*frame.gather)[middle].reference == kNoReference) return;
  const vec3 forward = glm::normalize(camera.pose.target - camera.pose.eye);
  camera.pose.target = camera.pose.eye + forward * std::max((*frame.gather)[middle].depth, 1e-4f);
}

void orbitCamera(CameraState& camera, float turn, float rise) {
  camera.pose.name.clear();
  camera.pose.up = worldUp(camera);
  camera.pose.eye = camera.pose.target - turned(camera.pose.target - camera.pose.eye, camera.pose.up, turn, rise);
}

void orbitAround(CameraState& camera, const vec3& pivot, float turn, float rise) {
  CameraPose& pose = camera.pose;
  pose.name.clear();
  const vec3 up = worldUp(camera), before = pose.target - pose.eye, after = turned(before, up, turn, rise);
  const auto height = [&](const vec3& way) { return std::asin(std::clamp(glm::dot(glm::normalize(way), up), -1.0f, 1.0f)); };
  const glm::quat yaw = glm::angleAxis(turn, up),
                  pitch = glm::angleAxis(height(after) - height(before), glm::normalize(glm::cross(yaw * before, up)));
  pose.up = up;
  pose.eye = pivot - pitch * (yaw * (pivot - pose.eye));
  pose.target = pose.eye + after;
}

void turnCamera(CameraState& camera, float turn, float rise) {
  camera.pose.name.clear();
  camera.pose.up = worldUp(camera);
  camera.pose.target = camera.pose.eye + turned(camera.pose.target - camera.pose.eye, camera.pose.up, turn, rise);
}

void moveCamera(CameraState& camera, vec3 way) {
  camera.pose.name.clear();
  const vec3 forward = glm::normalize(camera.pose.target - camera.pose.eye);
  const vec3 right = glm::normalize(glm::cross(forward, camera.pose.up)), up = glm::cross(right, forward);
  const vec3 offset = right * way.x + up * way.y + forward * way.z;
  camera.pose.eye += offset;
  camera.pose.target += offset;
}

void dollyCamera(CameraState& camera, float factor) {
  camera.pose.name.clear();
  camera.pose.eye = camera.pose.target + (camera.pose.eye - camera.pose.target) * std::clamp(factor, 0.05f, 20.0f);
}

void focusCamera(CameraState& camera, const Bounds& bounds) {
  if (bounds.empty()) return;
  camera.pose.name.clear();
  const vec3 middle = 0.5f * (bounds.low + bounds.high);
  const float radius = std::max(0.5f * glm::distance(bounds.low, bounds.high), 1e-6f);
  const float distance = 2.5f * radius / std::tan(0.5f * glm::radians(camera.pose.verticalFovDegrees));
  const vec3 back = glm::normalize(camera.pose.eye - camera.pose.target);
  camera.pose.target = middle;
  camera.pose.eye = middle + back * distance;
}

bool inPicture(const CameraPose& pose, const FrameSettings& frame, const vec3& point) {
  const vec3 forward = glm::normalize(pose.target - pose.eye), right = glm::normalize(glm::cross(forward, pose.up)),
             up = glm::cross(right, forward);
  const vec3 way = point - pose.eye;
  const float depth = glm::dot(way, forward), tall = std::tan(0.5f * glm::radians(pose.verticalFovDegrees));
  const float wide = tall * float(frame.width) / float(std::max(1u, frame.height));
  return depth > 0.0f && std::abs(glm::dot(way, right)) < depth * wide && std::abs(glm::dot(way, up)) < depth * tall;
}

void lookAlong(CameraState& camera, int axis, bool positive) {
  camera.pose.name.clear();
  const float distance = glm::distance(camera.pose.eye, camera.pose.target);
  vec3 back(0.0f);
  back[axis] = positive ? 1.0f : -1.0f;
  const vec3 up = worldUp(camera);
  // Straight along up there is no level direction: a little aside of it.
  if (std::abs(glm::dot(back, up)) > 0.99f) back = glm::normalize(back + 0.01f * (camera.zUp ? vec3(0, -1, 0) : vec3(0, 0, 1)));
  camera.pose.up = up;
  camera.pose.eye = camera.pose.target + back * distance;
}

void lookAlongOrBack(CameraState& camera, int axis, bool positive) {
  constexpr float kAlready = 0.999f;  // cosine: within 2.6 degrees
  const vec3 back = glm::normalize(camera.pose.eye - camera.pose.target);
  const bool already = back[axis] * (positive ? 1.0f : -1.0f) > kAlready;
  lookAlong(camera, axis, already != positive);
}

void moveTargetTo(CameraState& camera, const vec3& point) {
  camera.pose.name.clear();
  camera.pose.eye += point - camera.pose.target;
  camera.pose.target = point;
}

}  // namespace gridscope
