// See picture.h.
#include "app/ui/widgets/picture.h"

#include "app/frame/view_paint.h"
#include "app/ui/widgets/images.h"

namespace gridscope {

namespace {

// What was painted last into a texture.
struct Painted {
  std::shared_ptr<const Pipeline::ViewImage> image;
  ValueRange range{0, 0};
  uint32_t map = 0;
};

}  // namespace

WindowImages*& windowImages() {
  static WindowImages* images = nullptr;
  return images;
}

std::shared_ptr<const Pipeline::ViewImage> imageOf(const PanePicture& picture) {
  if (!picture.frame) return nullptr;
  const auto found = picture.frame->views.find(picture.view);
  return found == picture.frame->views.end() ? nullptr : found->second;
}

ValueRange shownRange(const PanePicture& picture) {
  // Fitted ranges are found once for an image.
  static std::map<std::string, std::pair<std::shared_ptr<const Pipeline::ViewImage>, ValueRange>> fitted;
  const View* view = findView(picture.view);
  const auto image = imageOf(picture);
  if (picture.range) return *picture.range;
  if (!view || !image) return {0.0f, 1.0f};
  auto& [known, range] = fitted[picture.key + picture.view];
  if (known != image) {
    known = image;
    range = viewRange(*view, image->elements, uint32_t(picture.frame->parameters.grid.capacity));
  }
  return range;
}

bool paintPicture(const PanePicture& picture, uint32_t map) {
  static std::map<std::string, Painted> paintedViews;
  const auto image = imageOf(picture);
  if (!image) return false;
  Painted& painted = paintedViews[picture.key];
  const ValueRange range = shownRange(picture);
  if (painted.image == image && painted.range == range && painted.map == map) return true;
  windowImages()->set(picture.key, image->width, image->height, paintView(*image, range, map));
  painted = {image, range, map};
  return true;
}

void drawPicture(ImDrawList& list, const PaneRect& rect, const PanePicture& picture, const Pipeline::ViewImage& image) {
  const ImVec2 high{rect.origin.x + float(image.width) * rect.scale, rect.origin.y + float(image.height) * rect.scale};
  windowImages()->draw(list, picture.key, rect.origin, high, {0, 0}, {1, 1});
}

}  // namespace gridscope
