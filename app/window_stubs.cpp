// Panels that are drawn elsewhere.
#include "app/window_panels.h"

namespace gridscope {

void drawInspector(WindowModel&) {}
void drawRaySteps(WindowModel&) {}
void drawCellsTable(WindowModel&) {}
void drawInstancesTable(WindowModel&) {}
void drawTrianglesTable(WindowModel&) {}
void drawRaysTable(WindowModel&) {}
void drawCauses(WindowModel&) {}
void drawPlots(WindowModel&) {}
void drawTuner(WindowModel&) {}
void drawOverlays(const WindowModel&, const PaneRect&) {}

}  // namespace gridscope
