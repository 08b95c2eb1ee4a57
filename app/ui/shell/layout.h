// Where the window's regions are: menu, tool bar, left, centre, right, bottom and status, with splitters between them that can be dragged.
#pragma once

#include "app/model/window_model.h"

namespace gridscope {

// Draws every region. `width` and `height`: of the window, in pixels.
void drawLayout(WindowModel& model, float width, float height);

}  // namespace gridscope
