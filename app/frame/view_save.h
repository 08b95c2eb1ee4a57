// A view of the window as a PNG file, with its legend, beside where the program was started.
#pragma once

#include <string>

#include "app/model/window_model.h"

namespace gridscope {

// SCENE_VIEW.png, or the first free name like it, as the view is shown now; painted and written on a thread of model.files, which says what
// became of it.
void saveView(WindowModel& model, const std::string& name);

}  // namespace gridscope
