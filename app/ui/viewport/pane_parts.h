// What stands over a pane's picture: the selected pixel, the area, the read-out, the letters and the split of a comparison.
#pragma once

#include <string>
#include <vector>

#include "app/ui/widgets/picture.h"

namespace gridscope {

struct WindowModel;

// The mark stays whole where the pixel lies at the pane's edge.
void drawSelectedPixel(const WindowModel& model, const PaneRect& rect, uvec2 size);
void drawArea(const WindowModel& model, const PaneRect& rect);

// Lower left corner; `raised`: something stands there already.
void drawReadOut(const std::vector<std::string>& parts, const PaneRect& rect, bool raised);

// Why there is no picture.
void drawNothing(const WindowModel& model, const PanePicture& picture, ImVec2 low, ImVec2 high);

// A or B with a few words, in the upper left corner of its part or, `right`, in the upper right one below the axes.
void drawLetter(const char* letter, const std::string& words, const PaneRect& rect, bool right);

// The split of a comparison, which can be dragged.
void dragSplit(WindowModel& model, ImVec2 low, ImVec2 high);

// Where a box of a size goes in the lower left corner: above the legend where they would meet.
ImVec2 lowerLeft(const PaneRect& rect, ImVec2 size);

}  // namespace gridscope
