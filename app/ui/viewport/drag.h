// Handles at the centre of the selected instance that was made dynamic: dragged along an axis, or across the view from the middle.
#pragma once

#include "app/model/window_model.h"
#include "app/ui/widgets/pane_rect.h"

namespace gridscope {

// Draws them over a pane and moves the instance with the mouse.
void dragInstance(WindowModel& model, const PaneRect& pane);

}  // namespace gridscope
