// Buttons and menu entries of actions (app/model/actions.h): each prints its key, and says why it can't be done.
#pragma once

#include "app/model/actions.h"

namespace gridscope {

// A button that runs an action. `label`: instead of its name.
void actionButton(WindowModel& model, const char* name, const char* label = nullptr);
// The same as a menu's entry.
void actionEntry(WindowModel& model, const Action& action);
// Tooltip of the item before: what the action does, its key, and why not.
void actionTooltip(const WindowModel& model, const Action& action);

}  // namespace gridscope
