// From a pressed key to its action.
#pragma once

#include "app/model/window_model.h"
#include "app/ui/shell/input.h"

namespace gridscope {

// Runs the action of a key, unless that key belongs to what is being typed or to the flying camera.
void runKey(WindowModel& model, const KeyPress& key);

}  // namespace gridscope
