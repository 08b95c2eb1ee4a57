// The panels: each draws itself with ImGui from the model, inside the region that window_layout.cpp gave it.
#pragma once

#include "app/window_model.h"

namespace gridscope {

void drawMenuBar(WindowModel& model);
void drawToolbar(WindowModel& model);
void drawSettingsPanel(WindowModel& model);      // left: Scene, Grid, Trace, Overlays, Camera, Bookmarks
void drawViewport(WindowModel& model);           // centre: view bar, panes, overlays
void drawInspector(WindowModel& model);          // right: Inspector, Pixel, Bookmarks
void drawBottomTabs(WindowModel& model);         // the tab bar and the tab
void drawStatusLine(WindowModel& model);
void drawHelp(WindowModel& model);               // all keys
void drawDialogs(WindowModel& model);            // open, capture, cancel, faults

// The bottom tabs.
void drawRaySteps(WindowModel& model);
void drawCellsTable(WindowModel& model);
void drawInstancesTable(WindowModel& model);
void drawTrianglesTable(WindowModel& model);
void drawRaysTable(WindowModel& model);
void drawCauses(WindowModel& model);
void drawPlots(WindowModel& model);
void drawTuner(WindowModel& model);
void drawLog(WindowModel& model);

}  // namespace gridscope
