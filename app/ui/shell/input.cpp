// See input.h.
#include "app/ui/shell/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cfloat>
#include <utility>

namespace gridscope {

namespace {

WindowInput& inputOf(GLFWwindow* window) { return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window)); }

// The letter or sign that the layout has on a key; GLFW's code for all others.
int layoutKey(int key, int scancode) {
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_EQUAL) return key;
  const char* name = key == GLFW_KEY_UNKNOWN || key < GLFW_KEY_ESCAPE ? glfwGetKeyName(key, scancode) : nullptr;
  if (name && name[0] && !name[1]) return std::toupper(static_cast<unsigned char>(name[0]));
  return key;
}

}  // namespace

WindowInput::WindowInput(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window, this);
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
    inputOf(w).push({.kind = Event::key,
                     .code = layoutKey(key, scancode),
                     .down = action != GLFW_RELEASE,
                     .repeated = action == GLFW_REPEAT,
                     .modifiers = modifiers});
  });
  glfwSetCharCallback(window,
                      [](GLFWwindow* w, unsigned character) { inputOf(w).push({.kind = Event::character, .code = int(character)}); });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
    inputOf(w).push({.kind = Event::button, .code = button, .down = action == GLFW_PRESS, .modifiers = modifiers});
  });
  glfwSetScrollCallback(window,
                        [](GLFWwindow* w, double x, double y) { inputOf(w).push({.kind = Event::wheel, .x = float(x), .y = float(y)}); });
  glfwSetCursorPosCallback(window,
                           [](GLFWwindow* w, double x, double y) { inputOf(w).push({.kind = Event::move, .x = float(x), .y = float(y)}); });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    if (!entered) inputOf(w).push({.kind = Event::leave});
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { inputOf(w).activity_ = true; });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { inputOf(w).activity_ = true; });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { inputOf(w).activity_ = true; });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    inputOf(w).dropped_.assign(paths, paths + count);
    inputOf(w).activity_ = true;
  });

  ImGuiIO& io = ImGui::GetIO();
  const std::pair<ImGuiKey, int> keys[] = {{ImGuiKey_Tab, GLFW_KEY_TAB},
                                           {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                           {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                           {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                           {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                           {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
                                           {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
                                           {ImGuiKey_Home, GLFW_KEY_HOME},
                                           {ImGuiKey_End, GLFW_KEY_END},
                                           {ImGuiKey_Insert, GLFW_KEY_INSERT},
                                           {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                           {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                           {ImGuiKey_Space, GLFW_KEY_SPACE},
                                           {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                           {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                           {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
                                           {ImGuiKey_A, 'A'},
                                           {ImGuiKey_C, 'C'},
                                           {ImGuiKey_V, 'V'},
                                           {ImGuiKey_X, 'X'},
                                           {ImGuiKey_Y, 'Y'},
                                           {ImGuiKey_Z, 'Z'}};
  for (const auto& [key, code] : keys) io.KeyMap[key] = code;
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  io.ClipboardUserData = window;
  io.SetClipboardTextFn = [](void* w, const char* text) { glfwSetClipboardString(static_cast<GLFWwindow*>(w), text); };
  io.GetClipboardTextFn = [](void* w) -> const char* { return glfwGetClipboardString(static_cast<GLFWwindow*>(w)); };
}

void WindowInput::push(const Event& event) {
  activity_ = true;
  // Only the last of several moves in a row matters.
  if (event.kind == Event::move && !events_.empty() && events_.back().kind == Event::move)
    events_.back() = event;
  else
    events_.push_back(event);
}

bool WindowInput::takeActivity() { return std::exchange(activity_, false); }

std::vector<std::string> WindowInput::takeDroppedFiles() { return std::exchange(dropped_, {}); }

void WindowInput::feedKey(const Event& event, std::vector<KeyPress>& pressed) {
  ImGuiIO& io = ImGui::GetIO();
  if (event.code >= 0 && event.code < IM_ARRAYSIZE(io.KeysDown)) io.KeysDown[event.code] = event.down;
  const bool isControl = event.code == GLFW_KEY_LEFT_CONTROL || event.code == GLFW_KEY_RIGHT_CONTROL;
  const bool isShift = event.code == GLFW_KEY_LEFT_SHIFT || event.code == GLFW_KEY_RIGHT_SHIFT;
  const bool isAlt = event.code == GLFW_KEY_LEFT_ALT || event.code == GLFW_KEY_RIGHT_ALT;
  // Of a modifier's own event, the modifiers are those before it.
  io.KeyCtrl = isControl ? event.down : (event.modifiers & GLFW_MOD_CONTROL) != 0;
  io.KeyShift = isShift ? event.down : (event.modifiers & GLFW_MOD_SHIFT) != 0;
  io.KeyAlt = isAlt ? event.down : (event.modifiers & GLFW_MOD_ALT) != 0;
  if (event.down && !isControl && !isShift && !isAlt) pressed.push_back({event.code, io.KeyCtrl, io.KeyAlt, io.KeyShift});
}

std::vector<KeyPress> WindowInput::feed(float width, float height, double secondsSinceLast) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {width, height};
  io.DeltaTime = float(std::max(secondsSinceLast, 1e-4));
  std::vector<KeyPress> pressed;
  bool fed = false;
  while (!events_.empty()) {
    const Event event = events_.front();
    const bool exclusive = event.kind == Event::key || event.kind == Event::button;
    if (exclusive && fed) break;
    // A move after a button belongs to the next frame: the click happened before it.
    if (event.kind == Event::move && fed) break;
    events_.pop_front();
    switch (event.kind) {
      case Event::key: feedKey(event, pressed); break;
      case Event::character:
        io.AddInputCharacter(static_cast<unsigned>(event.code));
        if (event.code == '?' && !io.WantTextInput) pressed.push_back({'?'});
        break;
      case Event::button:
        if (event.code >= 0 && event.code < IM_ARRAYSIZE(io.MouseDown)) io.MouseDown[event.code] = event.down;
        break;
      case Event::wheel: io.MouseWheelH += event.x, io.MouseWheel += event.y; break;
      case Event::move: io.MousePos = {event.x, event.y}; break;
      case Event::leave:
        if (!ImGui::IsAnyMouseDown()) io.MousePos = {-FLT_MAX, -FLT_MAX};
        break;
    }
    fed |= exclusive;
  }
  return pressed;
}

}  // namespace gridscope
