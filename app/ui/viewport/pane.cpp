// See pane.h. pane_parts.h draws what stands over the picture.
#include "app/ui/viewport/pane.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/frame/camera_moves.h"
#include "app/frame/pick_cell.h"
#include "app/frame/read_out.h"
#include "app/frame/viewport_place.h"
#include "app/model/comparison.h"
#include "app/ui/viewport/drag.h"
#include "app/ui/viewport/overlay.h"
#include "app/ui/viewport/pane_parts.h"
#include "app/ui/widgets/legend.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/grid/slice.h"

namespace gridscope {

namespace {

constexpr float kClickSlack = 4.0f;  // pixels that a click may move

// One picture's part of the pane.
struct PaneSide {
  PanePicture picture;
  const char* letter = nullptr;  // of a comparison
  PaneRect rect;                 // min, max: its part
  ImVec2 corner;                 // of the whole pane, in which the picture lies
  vec2 area{0.0f};
  const View* view = nullptr;
  std::shared_ptr<const Pipeline::ViewImage> image;  // null: nothing to show
  bool live = true;                                  // of the frame that is shown, not of a kept one
};

vec2 sizeOf(const Pipeline::ViewImage& image) { return {float(image.width), float(image.height)}; }

// Slices lie in the pane as frames do, though their places are of cells.
uvec2 frameSize(const FrameSnapshot& frame, const Pipeline::ViewImage& image, const View& view) {
  if (view.scope == ViewScope::slice || !frame.request.settings) return {image.width, image.height};
  return {frame.request.settings->width, frame.request.settings->height};
}

ViewportPlace& placeOf(WindowModel& model, int pane) { return model.places[model.linkedPanes ? 0 : size_t(pane)]; }

PaneSide makeSide(WindowModel& model, int pane, ImVec2 low, ImVec2 high, const PanePicture& picture) {
  PaneSide side{.picture = picture,
                .rect = {.min = low, .max = high, .pane = pane},
                .corner = low,
                .area = {high.x - low.x, high.y - low.y},
                .view = findView(picture.view),
                .image = imageOf(picture)};
  side.live = picture.frame == model.frame.get();
  if (!side.image || !side.view || !paintPicture(picture, model.colourMap)) {
    side.image.reset();
    return side;
  }
  const vec2 size = sizeOf(*side.image);
  ViewportPlace place = placeOf(model, pane);
  // Zoom counts pixels of the live frame: another's pixels may be larger.
  if (!side.live && model.frame && model.frame->request.settings && side.view->scope != ViewScope::slice)
    place = placeForSize(place, vec2(model.frame->request.settings->width, model.frame->request.settings->height), size);
  const PlacedFrame placed = placeFrame(place, size, side.area);
  side.rect.scale = placed.scale;
  side.rect.origin = {std::round(low.x + placed.origin.x), std::round(low.y + placed.origin.y)};
  side.rect.camera = picture.frame->parameters.camera;
  return side;
}

// A alone, A left of B, or, flipped, B where A was.
std::vector<PaneSide> sidesOf(WindowModel& model, int pane, ImVec2 low, ImVec2 high, const PaneContent& content) {
  const CompareState& compare = model.comparison;
  std::vector<PaneSide> sides{makeSide(model, pane, low, high, content.first)};
  if (content.second) {
    sides[0].letter = "A";
    sides.push_back(makeSide(model, pane, low, high, *content.second));
    sides[1].letter = "B";
    if (compare.flip) std::swap(sides[0], sides[1]);
    if (compare.wipes)
      sides[0].rect.max.x = sides[1].rect.min.x = std::round(low.x + compare.split * (high.x - low.x));
    else
      sides.pop_back();
  }
  const bool oneLegend = sides.size() == 2 && sides[0].view == sides[1].view;
  for (size_t i = 0; i < sides.size(); ++i)
    if (sides[i].view && content.legends && !(oneLegend && i == 0)) sides[i].rect.legend = legendBoxSize(*sides[i].view);
  return sides;
}

std::optional<uvec2> pixelUnder(const PaneSide& side, ImVec2 place) {
  if (!side.image) return std::nullopt;
  const vec2 pixel = glm::floor(side.rect.toPixel(place));
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= float(side.image->width) || pixel.y >= float(side.image->height)) return std::nullopt;
  return uvec2(pixel);
}

// The pixel of the live frame that lies where a pixel of this side does; nothing over a slice.
std::optional<uint32_t> livePixel(const WindowModel& model, const PaneSide& side, uvec2 pixel) {
  if (side.view->scope == ViewScope::slice || !model.frame->request.settings) return std::nullopt;
  const FrameSettings& live = *model.frame->request.settings;
  return pixelInSize(pixel, frameSize(*side.picture.frame, *side.image, *side.view), uvec2(live.width, live.height));
}

// A click selects a pixel, or a cell of the slice.
void click(WindowModel& model, const PaneSide& side, uvec2 pixel) {
  model.activePane = side.rect.pane;
  if (const auto live = livePixel(model, side, pixel)) return model.selection.selectPixel(*live);
  const SliceSettings& slice = side.picture.frame->request.slice;
  const ivec3 cells = side.picture.frame->parameters.grid.cellCount;
  if (model.frame->parameters.grid.cellCount != cells) return model.showMessage("This cell is of another grid than the live frame's");
  model.selection.selectCell(
      sliceCell(cells, slice.axis, slice.index < 0 ? cells[slice.axis] / 2 : slice.index, pixel.y * side.image->width + pixel.x));
}

// The cell whose drawn box, or whose surface, lies under the mouse.
void clickCell(WindowModel& model, const PaneSide& side, ImVec2 place) {
  if (!side.live || side.view->scope == ViewScope::slice || !model.frame->grid) return;
  model.activePane = side.rect.pane;
  const auto cell = pickCell(*model.frame, side.rect.camera, side.rect.toPixel(place), drawnBoxes(model, side.rect));
  if (cell)
    model.selection.selectCell(*cell);
  else
    model.showMessage("No cell of the grid lies there");
}

void dragArea(WindowModel& model, const PaneSide& side) {
  const vec2 a = side.rect.toPixel(ImGui::GetIO().MouseClickedPos[0]), b = side.rect.toPixel(ImGui::GetIO().MousePos);
  const vec2 most = sizeOf(*side.image);
  const vec2 low = glm::clamp(glm::floor(glm::min(a, b)), vec2(0.0f), most), high = glm::clamp(glm::ceil(glm::max(a, b)), vec2(0.0f), most);
  model.area = PixelArea{ivec2(low), ivec2(high)};
  if (!ImGui::IsMouseReleased(0)) return;
  model.selectingArea = false;
  if (low.x >= high.x || low.y >= high.y) model.area.reset();
}

// A pixel that was selected elsewhere, or that something asked for, comes into a zoomed pane.
void bringIntoView(WindowModel& model, const PaneSide& side) {
  static std::optional<uint32_t> seen;
  const std::optional<uint32_t> selected = model.selected().pixel;
  if (!side.live || side.view->scope == ViewScope::slice || side.rect.pane != model.activePane) return;
  if (selected && selected != seen) model.pixelWanted = vec2(*selected % side.image->width, *selected / side.image->width) + 0.5f;
  seen = selected;
  if (!model.pixelWanted) return;
  ViewportPlace& place = placeOf(model, side.rect.pane);
  place = showingPixel(place, sizeOf(*side.image), side.area, *model.pixelWanted);
  model.pixelWanted.reset();
}

void drawSide(WindowModel& model, const PaneSide& side) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(side.rect.min, side.rect.max, true);
  list.AddRectFilled(side.rect.min, side.rect.max, IM_COL32(20, 23, 27, 255));
  if (side.image)
    drawPicture(list, side.rect, side.picture, *side.image);
  else
    drawNothing(model, side.picture, side.rect.min, side.rect.max);
  list.PopClipRect();
}

// What stands over the pictures of the live frame: over both, where both are.
void drawOver(WindowModel& model, std::span<const PaneSide> sides) {
  const auto isShown = [](const PaneSide& side) { return side.live && side.image && side.view->scope != ViewScope::slice; };
  const auto first = std::ranges::find_if(sides, isShown);
  if (first == sides.end()) return;
  PaneRect rect = first->rect;
  for (const PaneSide& side : sides)
    if (isShown(side))
      rect.min.x = std::min(rect.min.x, side.rect.min.x), rect.max.x = std::max(rect.max.x, side.rect.max.x),
      rect.legend = side.rect.legend;
  ImGui::GetWindowDrawList()->PushClipRect(rect.min, rect.max, true);
  if (model.overlays.dimmed && rayLegendShown(model, rect))
    ImGui::GetWindowDrawList()->AddRectFilled(rect.min, rect.max, IM_COL32(20, 23, 27, 120));
  drawOverlays(model, rect);
  if (sides.size() == 1) drawLens(model, rect, first->picture, *first->image);
  drawSelectedPixel(model, rect, uvec2(first->image->width, first->image->height));
  drawArea(model, rect);
  ImGui::GetWindowDrawList()->PopClipRect();
}

void actByMouse(WindowModel& model, const PaneSide& side, bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  const int pane = side.rect.pane;
  const bool still = std::hypot(io.MousePos.x - io.MouseClickedPos[0].x, io.MousePos.y - io.MouseClickedPos[0].y) < kClickSlack;
  const std::optional<uvec2> under = hovered ? pixelUnder(side, io.MousePos) : std::nullopt;
  const vec2 size = sizeOf(*side.image), mouse(io.MousePos.x - side.corner.x, io.MousePos.y - side.corner.y);
  if (hovered && io.MouseWheel != 0.0f && !model.flying) {
    if (io.KeyAlt)
      dollyCamera(model.camera, std::pow(0.9f, io.MouseWheel));
    else
      placeOf(model, pane) = zoomedAt(placeOf(model, pane), size, side.area, mouse, io.MouseWheel);
  }
  if (model.selectingArea && (ImGui::IsItemActive() || ImGui::IsItemDeactivated()))
    dragArea(model, side);
  else if (ImGui::IsItemDeactivated() && still && under)
    io.KeyAlt ? clickCell(model, side, io.MousePos) : click(model, side, *under);
  else if (ImGui::IsItemActive() && !io.KeyAlt && !still)
    placeOf(model, pane) = movedBy(placeOf(model, pane), size, side.area, {io.MouseDelta.x, io.MouseDelta.y});
  if (!under) return;
  model.hoveredPixel = livePixel(model, side, *under);
  drawReadOut(readOutParts(*side.picture.frame, *side.view, *side.image, *under), side.rect, rayLegendShown(model, side.rect) && side.live);
}

void drawLetters(WindowModel& model, std::span<const PaneSide> sides) {
  const bool frames = comparesFrames(model);
  for (const PaneSide& side : sides) {
    if (!side.letter) continue;
    std::string words = side.view ? std::string(side.view->title) : "";
    const FrameSnapshot *kept = model.comparison.kept.get(), *own = side.picture.frame, *other = side.live ? kept : model.frame.get();
    if (frames && own && other) words = frameLabel(*own, *other);
    if (frames && words.empty()) words = side.live ? "live frame" : "kept frame";
    drawLetter(side.letter, words, side.rect, sides.size() == 2 && side.rect.min.x > sides[0].rect.min.x);
  }
}

}  // namespace

bool drawPane(WindowModel& model, int pane, ImVec2 low, ImVec2 high, const PaneContent& content) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushID(pane);
  list.PushClipRect(low, high, true);
  const std::vector<PaneSide> sides = sidesOf(model, pane, low, high, content);
  for (const PaneSide& side : sides) drawSide(model, side);
  drawOver(model, sides);

  ImGui::SetCursorScreenPos(low);
  ImGui::InvisibleButton("pane", {std::max(high.x - low.x, 1.0f), std::max(high.y - low.y, 1.0f)});
  ImGui::SetItemAllowOverlap();
  const bool hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemActivated()) model.activePane = pane;
  const bool right = sides.size() == 2 && ImGui::GetIO().MousePos.x >= sides[1].rect.min.x;
  const PaneSide& acting = sides[right ? 1 : 0];
  if (acting.image) {
    model.shownScale = acting.rect.scale;
    bringIntoView(model, acting);
    actByMouse(model, acting, hovered);
    if (acting.live && acting.view->scope != ViewScope::slice) dragInstance(model, acting.rect);
  }
  if (sides.size() == 2) dragSplit(model, low, high);
  drawLetters(model, sides);
  for (const PaneSide& side : sides) {
    if (side.rect.legend.x <= 0.0f || !side.view) continue;
    list.PushClipRect(side.rect.min, side.rect.max, true);
    drawLegendBox(model, *side.view, shownRange(side.picture), {side.rect.max.x - unit(10), side.rect.max.y - unit(10)});
    list.PopClipRect();
  }
  list.PopClipRect();
  ImGui::PopID();
  return hovered && acting.image;
}

}  // namespace gridscope
