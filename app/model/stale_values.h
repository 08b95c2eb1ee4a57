// Which values on show are of a request before, because their stages run again. No ImGui here.
#pragma once

#include "app/model/window_model.h"

namespace gridscope {

// As the model and the frame stand.
StaleValues staleValues(const WindowModel& model);

// Once a display frame: into WindowModel::stale, what has been stale for a moment already. While time plays every value is the shown frame's.
void noteStale(WindowModel& model);

}  // namespace gridscope
