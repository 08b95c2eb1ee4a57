// The parts of the overlays over the viewport (drawOverlays, window_panels.h).
#pragma once

#include "app/window_overlay_parts.h"

namespace gridscope {

// The selected pixel's ray: cells it visited, segments by outcome, glyphs at its steps, the current step's triangles and callout.
void drawRayOverlay(const WindowModel& model, const OverlayPainter& painter);

}  // namespace gridscope
