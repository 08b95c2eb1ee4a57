// Where what is selected lies in the world.
#pragma once

#include <optional>

#include "app/model/window_model.h"

namespace gridscope {

// What is selected, as a box in the world; empty: nothing.
Bounds selectedBounds(const WindowModel& model);
// What one orbits around: the middle of what is selected, where it is in the picture; else nothing.
std::optional<vec3> selectedPivot(const WindowModel& model);

}  // namespace gridscope
