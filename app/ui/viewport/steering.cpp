// See steering.h. camera_moves.h has the moves.
#include "app/ui/viewport/steering.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/base/text.h"
#include "app/frame/camera_moves.h"
#include "app/model/selected_bounds.h"

namespace gridscope {

namespace {

constexpr float kTurnPerPixel = 0.005f;  // radians
constexpr float kFaster = 4.0f;          // with Shift
constexpr float kSpeedStep = 1.2f;       // of the wheel and the speed keys

// The button that steers now, from its press over a pane to its release.
struct Steering {
  int button = -1;
  std::optional<vec3> pivot;  // of an orbit; nothing: the camera's target
};

int pressedOverPane(const ImGuiIO& io) {
  for (int button : {1, 2})
    if (ImGui::IsMouseClicked(button)) return button;
  return io.KeyAlt && ImGui::IsMouseClicked(0) ? 0 : -1;
}

void orbit(CameraState& camera, const std::optional<vec3>& pivot, const ImGuiIO& io) {
  const ImVec2 way = io.MouseDelta;
  if (way.x == 0.0f && way.y == 0.0f) return;
  camera.mode = CameraMode::orbit;
  const float turn = -way.x * kTurnPerPixel, rise = -way.y * kTurnPerPixel;
  if (!io.KeyShift) return pivot ? orbitAround(camera, *pivot, turn, rise) : orbitCamera(camera, turn, rise);
  const float perPixel =
      2.0f * std::tan(0.5f * glm::radians(camera.pose.verticalFovDegrees)) * glm::distance(camera.pose.eye, camera.pose.target) / 800.0f;
  moveCamera(camera, {-way.x * perPixel, way.y * perPixel, 0.0f});
}

// Steps by which the speed is to change: the wheel's, and those of + and -.
float speedSteps(const ImGuiIO& io) {
  float steps = io.MouseWheel;
  for (const int key : {int('+'), int('='), int(GLFW_KEY_KP_ADD)}) steps += ImGui::IsKeyPressed(key) ? 1.0f : 0.0f;
  for (const int key : {int('-'), int(GLFW_KEY_KP_SUBTRACT)}) steps -= ImGui::IsKeyPressed(key) ? 1.0f : 0.0f;
  return steps;
}

void fly(WindowModel& model, const ImGuiIO& io) {
  CameraState& camera = model.camera;
  camera.mode = CameraMode::fly;
  const ImVec2 way = io.MouseDelta;
  if (way.x != 0.0f || way.y != 0.0f) turnCamera(camera, -way.x * kTurnPerPixel, -way.y * kTurnPerPixel);
  if (const float steps = speedSteps(io); steps != 0.0f) camera.speed = std::clamp(camera.speed * std::pow(kSpeedStep, steps), 1e-4f, 1e5f);
  const auto axis = [](int more, int less) { return float(ImGui::IsKeyDown(more)) - float(ImGui::IsKeyDown(less)); };
  const vec3 keys(axis('D', 'A'), axis('E', 'Q'), axis('W', 'S'));
  if (keys != vec3(0.0f)) moveCamera(camera, keys * (camera.speed * io.DeltaTime * (io.KeyShift ? kFaster : 1.0f)));
}

}  // namespace

void steerCamera(WindowModel& model, bool overPane) {
  static Steering steering;
  const ImGuiIO& io = ImGui::GetIO();
  if (overPane && steering.button < 0) {
    steering.button = pressedOverPane(io);
    if (steering.button >= 0 && steering.button != 1 && model.frame) {
      steering.pivot = selectedPivot(model);
      if (!steering.pivot) aimCamera(model.camera, *model.frame);
    }
  }
  if (steering.button >= 0 && !ImGui::IsMouseDown(steering.button)) steering.button = -1;
  model.flying = steering.button == 1;
  if (steering.button < 0) return;
  if (model.flying)
    fly(model, io);
  else
    orbit(model.camera, steering.pivot, io);
}

}  // namespace gridscope
