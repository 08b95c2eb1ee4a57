// One pane of the viewport: a view's picture, zoomed and moved, with what is read out of it and what the mouse does in it.
#pragma once

#include "app/window_panels.h"
#include "views/view.h"

namespace gridscope {

// What a pane shows. Two panes of a comparison share one rectangle and are cut.
struct PanePicture {
  const FrameSnapshot* frame = nullptr;
  std::string view;
  std::string key;                     // of its texture
  std::optional<ValueRange> range;     // as the person set it
};

// Draws a pane into the rectangle and lets the mouse act in it. `second`: B of a comparison, or nothing to show.
// `legend`: size of what stands in the lower right corner; long read-outs go above it.
void drawPane(WindowModel& model, int pane, ImVec2 low, ImVec2 high, const PanePicture& first, const PanePicture* second, ImVec2 legend = {0, 0});

// The range that the view's colours span now.
ValueRange shownRange(const PanePicture& picture);

}  // namespace gridscope
