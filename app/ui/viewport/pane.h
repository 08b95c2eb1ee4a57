// One pane of the viewport: a view's picture, or A beside B, zoomed and moved, with what is read out of it and what the mouse does in it.
#pragma once

#include "app/ui/widgets/picture.h"

namespace gridscope {

struct WindowModel;

struct PaneContent {
  PanePicture first;
  std::optional<PanePicture> second;  // B of a comparison
  bool legends = true;                // in the lower right corners; else they stand elsewhere
};

// Draws a pane into the rectangle and lets the mouse act in it. True: the mouse is over its picture.
bool drawPane(WindowModel& model, int pane, ImVec2 low, ImVec2 high, const PaneContent& content);

}  // namespace gridscope
