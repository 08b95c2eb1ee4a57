// The panels: each draws itself with ImGui from the model, inside the region that app/ui/shell/layout.cpp gave it.
#pragma once

#include <imgui.h>

#include "app/model/window_model.h"

namespace gridscope {

void drawMenuBar(WindowModel& model);
void drawToolbar(WindowModel& model);
void drawSettingsPanel(WindowModel& model);  // left: Scene, Grid, Trace, and the next
void drawViewSettings(WindowModel& model);   // Overlays, Camera, Bookmarks
void drawViewport(WindowModel& model);       // centre: view bar, panes, overlays
void drawInspector(WindowModel& model);      // right: Inspector, Pixel, Bookmarks
void drawBottomTabs(WindowModel& model);     // the tab bar and the tab
void drawStatusLine(WindowModel& model);
void drawHelp(WindowModel& model);     // all keys
void drawDialogs(WindowModel& model);  // open, capture, cancel, faults

// What one pane of the viewport shows of the frame, for what is drawn over it.
struct PaneRect {
  ImVec2 min, max;            // of the pane on the screen, pixels
  ImVec2 origin;              // screen place of the frame's upper left corner; may lie outside the pane
  float scale = 1.0f;         // screen pixels a frame pixel
  CameraParameters camera{};  // that the frame was gathered from
  int pane = 0;               // 0..3
  ImVec2 legend{0, 0};        // size of the view's legend in the lower right corner; 0: none
  ImVec2 toScreen(vec2 pixel) const {
    return {origin.x + pixel.x * scale, origin.y + pixel.y * scale};
  }  // (0, 0): the first pixel's corner
  vec2 toPixel(ImVec2 place) const { return {(place.x - origin.x) / scale, (place.y - origin.y) / scale}; }
};
void drawOverlays(const WindowModel& model, const PaneRect& pane);  // over the picture of a view, clipped to the pane

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
