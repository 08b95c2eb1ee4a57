// Where the window's regions are: menu, tool bar, left, centre, right, bottom and status, with splitters between them that can be dragged.
#pragma once

#include "app/model/window_model.h"

namespace gridscope {

// Draws every region. `width` and `height`: of the window, in pixels.
void drawLayout(WindowModel& model, float width, float height);

// What it draws besides the viewport and the panels, each in the region that it gave it.
void drawMenuBar(WindowModel& model);
void drawToolbar(WindowModel& model);
void drawSettingsPanel(WindowModel& model);  // left: Scene, Grid, Trace, and the next
void drawViewSettings(WindowModel& model);   // Overlays, Camera, Bookmarks
void drawBottomTabs(WindowModel& model);     // the tab bar and the tab
void drawLog(WindowModel& model);            // one of the tabs
void drawStatusLine(WindowModel& model);
void drawHelp(WindowModel& model);     // all keys
void drawDialogs(WindowModel& model);  // open, capture, cancel, faults

}  // namespace gridscope
