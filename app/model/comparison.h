// A beside B: what each of them is, how the kept frame comes to hold every view, and how the two are called. No ImGui here.
#pragma once

#include <set>
#include <string>

#include "app/model/window_model.h"

namespace gridscope {

// Keeps the frame that is shown as B and shows it beside A. Views that it lacks are asked for and join it when they come.
void keepFrame(WindowModel& model);

// Views that are asked for so that the kept frame holds them; empty when it does.
std::set<std::string> viewsToKeep(const WindowModel& model);

// A new frame: the kept one takes its views when it is the same frame, and waits no longer when it is another.
void completeKept(WindowModel& model, const std::shared_ptr<const FrameSnapshot>& frame);

// Is B another frame than A's?
bool comparesFrames(const WindowModel& model);

// What a frame has that another has not: its scene where that differs, its time, and each setting that differs, at most `most` of them.
std::string frameLabel(const FrameSnapshot& frame, const FrameSnapshot& beside, size_t most = 3);

// The pixel of a frame of one size that lies where a pixel of another does.
uint32_t pixelInSize(uvec2 pixel, uvec2 size, uvec2 other);

}  // namespace gridscope
