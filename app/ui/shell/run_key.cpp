// See run_key.h.
#include "app/ui/shell/run_key.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cctype>
#include <string_view>
#include <utility>

#include "app/model/actions.h"

namespace gridscope {

static KeyPress pressOf(std::string_view text) {
  KeyPress press;
  const auto take = [&](std::string_view prefix) {
    const bool there = text.starts_with(prefix);
    if (there) text.remove_prefix(prefix.size());
    return there;
  };
  press.control = take("Ctrl+");
  press.alt = take("Alt+");
  press.shift = take("Shift+");
  static constexpr std::pair<std::string_view, int> kNames[] = {
      {"Right", GLFW_KEY_RIGHT}, {"Left", GLFW_KEY_LEFT},      {"Up", GLFW_KEY_UP},
      {"Down", GLFW_KEY_DOWN},   {"PageUp", GLFW_KEY_PAGE_UP}, {"PageDown", GLFW_KEY_PAGE_DOWN},
      {"Tab", GLFW_KEY_TAB},     {"Home", GLFW_KEY_HOME},      {"End", GLFW_KEY_END},
      {"Space", GLFW_KEY_SPACE}, {"Enter", GLFW_KEY_ENTER},    {"Escape", GLFW_KEY_ESCAPE},
      {"F5", GLFW_KEY_F5},       {"F6", GLFW_KEY_F6},          {"F12", GLFW_KEY_F12}};
  for (const auto& [name, code] : kNames)
    if (text == name) press.key = code;
  if (press.key == 0 && text.size() == 1) press.key = text[0];
  return press;
}

void runKey(WindowModel& model, const KeyPress& pressed) {
  const bool functionKey = pressed.key >= GLFW_KEY_F1 && pressed.key <= GLFW_KEY_F25;
  if (ImGui::GetIO().WantTextInput && !functionKey && !(pressed.control && (pressed.key == 'Q' || pressed.key == 'F'))) return;
  if (model.flying && !pressed.control) return;
  if (model.walked != 0 && pressed.key == GLFW_KEY_ESCAPE) return void(model.walked = 0);
  if (model.walked != 0 && !pressed.control && !pressed.alt && !functionKey) return;
  if (pressed.key == GLFW_KEY_F1) return runKey(model, {'?'});
  for (const Action& one : allActions()) {
    const KeyPress press = pressOf(one.key);
    if (press.key == 0 || press.key != pressed.key || press.control != pressed.control || press.alt != pressed.alt) continue;
    // Signs are typed with Shift on some keyboards; elsewhere it tells two actions apart.
    if (pressed.control && (press.key == GLFW_KEY_TAB || std::isalpha(press.key)) && press.shift != pressed.shift) continue;
    const std::string why = whyNot(model, one);
    if (why.empty())
      one.run(model);
    else
      model.showMessage(std::string(one.name) + ": " + why);
    return;
  }
}

}  // namespace gridscope
