// The lens over the viewport (overlay.h): the selected step's cell, magnified, with the ray through it.
#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/model/ray_stepping.h"
#include "app/ui/viewport/overlay.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

constexpr float kLensWidth = 264, kLensHeight = 180;    // pixels at UI scale 1
constexpr float kLeastWidth = 620, kLeastHeight = 380;  // of a pane that has room for it
constexpr float kLargeCell = 90;                        // a cell that is as large in the picture needs no lens
constexpr float kCellShare = 0.45f;                     // of the lens's height that the cell takes
constexpr float kMostTimes = 20;

struct PixelBox {
  vec2 low{1e9f}, high{-1e9f};
};

// Where a cell lies in the picture, pixels of the frame; nothing when a corner is behind the eye.
std::optional<PixelBox> projectedCell(const CameraParameters& camera, const Bounds& bounds) {
  PixelBox box;
  for (int corner = 0; corner < 8; ++corner) {
    const vec3 at(corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                  corner & 4 ? bounds.high.z : bounds.low.z);
    const auto point = projectPoint(camera, at);
    if (!point) return std::nullopt;
    box.low = glm::min(box.low, point->pixel), box.high = glm::max(box.high, point->pixel);
  }
  return box;
}

}  // namespace

std::optional<PaneRect> lensPlace(const WindowModel& model, const PaneRect& pane) {
  const ShownStep* shown = model.overlays.lens && model.overlays.raySegments ? shownStepFacts(model) : nullptr;
  if (!shown || !shown->facts.inGrid) return std::nullopt;
  if (pane.max.x - pane.min.x < unit(kLeastWidth) || pane.max.y - pane.min.y < unit(kLeastHeight)) return std::nullopt;
  const auto cell = projectedCell(pane.camera, cellBounds(model.frame->grid->parameters, shown->facts.cell));
  if (!cell) return std::nullopt;
  const vec2 size = cell->high - cell->low;
  const float extent = std::max({size.x * kLensHeight / kLensWidth, size.y, 1e-3f}) * pane.scale;
  if (extent > unit(kLargeCell)) return std::nullopt;

  PaneRect lens = pane;
  lens.legend = {0, 0};
  const float foot = pane.legend.x > 0.0f ? pane.legend.y + unit(16) : unit(10);
  lens.max = {pane.max.x - unit(10), pane.max.y - foot};
  lens.min = {lens.max.x - unit(kLensWidth), lens.max.y - unit(kLensHeight)};
  lens.scale = pane.scale * std::clamp(kCellShare * unit(kLensHeight) / extent, 2.0f, kMostTimes);
  const vec2 middle = 0.5f * (cell->low + cell->high);
  lens.origin = {0.5f * (lens.min.x + lens.max.x) - middle.x * lens.scale, 0.5f * (lens.min.y + lens.max.y) - middle.y * lens.scale};
  return lens;
}

void drawLens(const WindowModel& model, const PaneRect& pane, const PanePicture& picture, const Pipeline::ViewImage& image) {
  const std::optional<PaneRect> lens = lensPlace(model, pane);
  if (!lens) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(lens->min, lens->max, true);
  list.AddRectFilled(lens->min, lens->max, IM_COL32(20, 23, 27, 255));
  drawPicture(list, *lens, picture, image);
  list.AddRectFilled(lens->min, lens->max, IM_COL32(20, 23, 27, 90));  // the ray stands out
  OverlayPainter painter{.list = &list, .pane = *lens, .bias = 0.12f * model.frame->grid->parameters.cellEdge};
  if (model.frame->gather && model.frame->gather->size() == size_t(pane.camera.width) * pane.camera.height)
    painter.gather = *model.frame->gather;
  drawRayInLens(model, painter);
  const std::string words = printed("Lens on the step's cell  %.0fx", double(lens->scale / pane.scale));
  ImFont* font = windowFonts().sansSmall;
  const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, words.c_str()).x;
  list.AddRectFilled(lens->min, {lens->min.x + width + unit(16), lens->min.y + unit(20)}, IM_COL32(20, 23, 27, 225));
  list.AddText(font, font->FontSize, {lens->min.x + unit(8), lens->min.y + unit(3)}, IM_COL32(217, 223, 229, 255), words.c_str());
  list.PopClipRect();
  list.AddRect(lens->min, lens->max, IM_COL32(70, 78, 88, 255), 0.0f, 0, unit(1));
}

}  // namespace gridscope
