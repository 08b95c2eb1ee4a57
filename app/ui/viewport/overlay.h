// The overlays over the viewport, and their parts.
#pragma once

#include "app/frame/cell_boxes.h"
#include "app/ui/viewport/overlay_parts.h"
#include "app/ui/widgets/picture.h"
#include "app/ui/widgets/step_parts.h"

namespace gridscope {

struct WindowModel;

inline constexpr float kLeastCallout = 480.0f;  // width of a pane that has room for the ray's legend and callouts, pixels at UI scale 1

// Over the picture of a view, clipped to the pane.
void drawOverlays(const WindowModel& model, const PaneRect& pane);

// The selected pixel's ray: cells it visited, segments by outcome, glyphs at its steps, the current step's triangles and callout.
void drawRayOverlay(const WindowModel& model, const OverlayPainter& painter);

// The same without callouts and legend, for the lens.
void drawRayInLens(const WindowModel& model, const OverlayPainter& painter);

// What the ray's parts share. Where a step ends along the ray: where the ray does, in its last step.
float shownEnd(const FrameSnapshot& frame, const RecordedRay& ray, uint32_t step);
void drawCallouts(const WindowModel& model, const OverlayPainter& painter, const ShownStep& shown);

// Of what is selected: its name, and a line in the colour of saturated cells where `marked`.
void drawSelectionCallout(const WindowModel& model, const OverlayPainter& painter, const vec3& at, const std::string& name,
                          const std::string& note, bool marked);

// Where the lens on the step's cell stands, and what it magnifies; nothing where it is off, or the cell is large in the picture.
std::optional<PaneRect> lensPlace(const WindowModel& model, const PaneRect& pane);
void drawLens(const WindowModel& model, const PaneRect& pane, const PanePicture& picture, const Pipeline::ViewImage& image);

// Stands the legend of the ray in the pane's lower left corner?
bool rayLegendShown(const WindowModel& model, const PaneRect& pane);

// The cells whose boxes are drawn in a pane.
std::span<const BoxCell> drawnBoxes(const WindowModel& model, const PaneRect& pane);

}  // namespace gridscope
