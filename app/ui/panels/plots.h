// The parts of the tab Plots.
#pragma once

#include <imgui.h>

#include "app/model/window_model.h"

namespace gridscope {

// A plot in the rectangle from `low` to `high`, screen pixels. `place`: which of the two histograms this is; each remembers what it counts.
void drawHistogram(WindowModel& model, int place, const ImVec2& low, const ImVec2& high);
void drawStageTimes(WindowModel& model, const ImVec2& low, const ImVec2& high);

}  // namespace gridscope
