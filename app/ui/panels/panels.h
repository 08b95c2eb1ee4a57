// The panels: each draws itself with ImGui from the model, inside the region that the window's layout gave it.
#pragma once

#include "app/model/window_model.h"

namespace gridscope {

void drawInspector(WindowModel& model);  // right: Inspector, Pixel, Bookmarks
void drawTuner(WindowModel& model);      // below, and in the viewport's place

// The other tabs below.
void drawRaySteps(WindowModel& model);
void drawCellsTable(WindowModel& model);
void drawInstancesTable(WindowModel& model);
void drawTrianglesTable(WindowModel& model);
void drawRaysTable(WindowModel& model);
void drawCauses(WindowModel& model);
void drawPlots(WindowModel& model);

}  // namespace gridscope
