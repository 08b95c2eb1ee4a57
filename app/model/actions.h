// Everything that a person can do with a key or from a menu, in one table: name, key, when it can be done, what it does. Menus, buttons,
// tooltips and the help window read from it.
#pragma once

#include <span>
#include <string>

#include "app/model/window_model.h"

namespace gridscope {

struct Action {
  const char* menu;                                 // "File": where it stands
  const char* name;                                 // "Capture frame"
  const char* key;                                  // "Ctrl+Right", "N"; empty: none
  const char* about;                                // one sentence
  std::string (*whyNot)(const WindowModel& model);  // why it can't be done now; empty: it can. nullptr: always
  void (*run)(WindowModel& model);
};

std::span<const Action> allActions();
const Action& action(const char* name);  // by name; our own mistake when there is none

// Why it can't be done now; empty: it can.
std::string whyNot(const WindowModel& model, const Action& action);

}  // namespace gridscope
