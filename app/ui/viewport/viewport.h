// The viewport: its bar, and one view, four linked views, or A beside B.
#pragma once

#include <imgui.h>

#include "app/model/window_model.h"

namespace gridscope {

// Fills ImGui's present window.
void drawViewport(WindowModel& model);

// What lies over the viewport, or over what stands in its place: long work with its bar and its end, and the last message for a moment.
// Drawn by drawViewport itself. `low` to `high`: on the screen.
void drawNotices(WindowModel& model, ImVec2 low, ImVec2 high);

}  // namespace gridscope
