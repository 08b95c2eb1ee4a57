// The mouse and the keys that steer the camera from a pane: fly with the right button; orbit, around the selection
// where it is in the picture, with the middle one or Alt and the left one.
#pragma once

#include "app/model/window_model.h"

namespace gridscope {

// Once a display frame. `overPane`: the mouse is over a pane's picture, where steering may begin.
void steerCamera(WindowModel& model, bool overPane);

}  // namespace gridscope
