// Writing a view of the shown frame as a PNG file, with its legend, as `gridscope render` writes it.
#pragma once

#include "app/window_model.h"

namespace gridscope {

// Into the folder where the program was started, SCENE_VIEW.png; returns the file's name. Throws Error.
std::string saveView(const WindowModel& model, const std::string& view);

}  // namespace gridscope
