// The picture of a view as a texture, painted anew when its values, its range or the colour map changed.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/frame/snapshot.h"
#include "app/ui/widgets/pane_rect.h"
#include "views/picture.h"

namespace gridscope {

// What a pane shows.
struct PanePicture {
  const FrameSnapshot* frame = nullptr;
  std::string view;
  std::string key;                  // of its texture
  std::optional<ValueRange> range;  // as the person set it
};

// Its elements; null: the frame does not hold this view.
std::shared_ptr<const Pipeline::ViewImage> imageOf(const PanePicture& picture);

// The range that the view's colours span now.
ValueRange shownRange(const PanePicture& picture);

// Brings the texture up to date; false when there is nothing to show.
bool paintPicture(const PanePicture& picture, uint32_t colourMap);

// Draws the texture where the rectangle has the frame, cut by the clip rectangle.
void drawPicture(ImDrawList& list, const PaneRect& rect, const PanePicture& picture, const Pipeline::ViewImage& image);

}  // namespace gridscope
