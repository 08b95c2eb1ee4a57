// Everything that a person can do with a key or from a menu, in one table: name, key, when it can be done, what it does. Menus, buttons,
// tooltips and the help window read from it.
#pragma once

#include <span>
#include <string>

#include "app/model/window_model.h"
#include "app/ui/shell/input.h"

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

// Runs the action of a key, unless that key belongs to what is being typed or to the flying camera.
void runKey(WindowModel& model, const KeyPress& key);

// A button that runs an action, prints its key, and says why it can't. `label`: instead of its name.
void actionButton(WindowModel& model, const char* name, const char* label = nullptr);
// The same as a menu's entry.
void actionEntry(WindowModel& model, const Action& action);
// Tooltip of the item before: what the action does, its key, and why not.
void actionTooltip(const WindowModel& model, const Action& action);

}  // namespace gridscope
