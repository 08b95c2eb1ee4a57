// The selected ray stays while the camera goes on: what was recorded from one place can be looked at from any other. When the grid or the
// trace's settings change, the same ray is recorded again, in C++, with the same bits as on the device. No ImGui here.
#pragma once

#include "app/model/window_model.h"

namespace gridscope {

// Once a display frame: notes the selected ray, and keeps what was noted up to date with the grid.
void holdRay(WindowModel& model);

// Is the shown ray that of another camera than the present one?
bool rayIsHeld(const WindowModel& model);

// The record of the selected pixel's ray: held, or the frame's, or the one before while its stages run; null: none is selected, or it is on
// its way.
std::shared_ptr<const RecordedRay> shownRay(const WindowModel& model);

// The camera goes back to where the held ray was recorded from.
void returnToRay(WindowModel& model);

}  // namespace gridscope
