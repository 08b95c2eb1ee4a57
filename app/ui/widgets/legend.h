// How to read a view: its colour bar or its swatches, with ends, ticks and what is counted. And the axes of the world.
#pragma once

#include "app/ui/widgets/picture.h"

namespace gridscope {

struct WindowModel;

// In a box whose lower right corner is `corner`.
void drawLegendBox(const WindowModel& model, const View& view, ValueRange range, ImVec2 corner);
ImVec2 legendBoxSize(const View& view);

// In one line that ends at `right`, for the head of a small pane; nothing where it would reach left of `left`.
void drawLegendLine(const WindowModel& model, const View& view, ValueRange range, ImVec2 right, float left);

// A disc with the axes as the camera sees them; a click on an end looks from there, a click on the end that one looks from already from the other.
void drawGizmo(WindowModel& model, ImVec2 centre, float radius);

}  // namespace gridscope
