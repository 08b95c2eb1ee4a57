// What lies under the mouse, in words: pixel, value, cell, triangle, depth; and how the words fit into a pane. No ImGui here.
#pragma once

#include <string>
#include <vector>

#include "app/frame/snapshot.h"
#include "views/view.h"

namespace gridscope {

// The most important first.
std::vector<std::string> readOutParts(const FrameSnapshot& frame, const View& view, const Pipeline::ViewImage& image, uvec2 pixel);

// The parts in lines of at most `width` characters, with " | " between them. Parts that find no room in `most` lines are left out, the last first.
std::vector<std::string> readOutLines(const std::vector<std::string>& parts, size_t width, size_t most);

}  // namespace gridscope
