// See window_pane.h. window_legend.cpp draws the legend, window_gizmo.cpp the axes.
#include "app/window_pane.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/camera_moves.h"
#include "app/text.h"
#include "app/view_paint.h"
#include "app/window_images.h"
#include "app/window_legend.h"
#include "app/window_widgets.h"

namespace gridscope {

namespace {

constexpr float kMostZoom = 64.0f;            // screen pixels a frame pixel
constexpr float kClickSlack = 4.0f;           // pixels that a click may move
constexpr float kTurnPerPixel = 0.005f;       // radians

// What was painted last into a texture.
struct Painted {
  std::shared_ptr<const Pipeline::ViewImage> image;
  ValueRange range{0, 0};
  uint32_t map = 0;
};

std::map<std::string, Painted>& paintedViews() {
  static std::map<std::string, Painted> painted;
  return painted;
}

std::shared_ptr<const Pipeline::ViewImage> imageOf(const PanePicture& picture) {
  if (!picture.frame) return nullptr;
  const auto found = picture.frame->views.find(picture.view);
  return found == picture.frame->views.end() ? nullptr : found->second;
}

// Brings the texture up to date; false when there is nothing to show.
bool paint(const PanePicture& picture, uint32_t map) {
  const auto image = imageOf(picture);
  if (!image) return false;
  Painted& painted = paintedViews()[picture.key];
  const ValueRange range = shownRange(picture);
  if (painted.image == image && painted.range == range && painted.map == map) return true;
  windowImages()->set(picture.key, image->width, image->height, paintView(*image, range, map));
  painted = {image, range, map};
  return true;
}

float fitScale(const Pipeline::ViewImage& image, ImVec2 size) { return std::min(size.x / float(image.width), size.y / float(image.height)); }

ViewportPlace& placeOf(WindowModel& model, int pane) { return model.places[model.linkedPanes ? 0 : size_t(pane)]; }

PaneRect paneRect(WindowModel& model, int pane, ImVec2 low, ImVec2 high, const PanePicture& picture, const Pipeline::ViewImage& image) {
  const ViewportPlace& place = placeOf(model, pane);
  PaneRect rect{.min = low, .max = high, .camera = picture.frame->parameters.camera, .pane = pane};
  const ImVec2 size{high.x - low.x, high.y - low.y};
  rect.scale = place.zoom > 0.0f ? place.zoom : fitScale(image, size);
  const vec2 centre = place.zoom > 0.0f ? place.centre : vec2(0.5f);
  rect.origin = {std::round(low.x + 0.5f * size.x - centre.x * float(image.width) * rect.scale),
                 std::round(low.y + 0.5f * size.y - centre.y * float(image.height) * rect.scale)};
  return rect;
}

void drawImage(ImDrawList& list, const PaneRect& rect, const PanePicture& picture, const Pipeline::ViewImage& image) {
  const ImVec2 high{rect.origin.x + float(image.width) * rect.scale, rect.origin.y + float(image.height) * rect.scale};
  windowImages()->draw(list, picture.key, rect.origin, high, {0, 0}, {1, 1});
}

void zoomAt(WindowModel& model, int pane, const PaneRect& rect, const Pipeline::ViewImage& image, float steps) {
  ViewportPlace& place = placeOf(model, pane);
  const float fit = fitScale(image, {rect.max.x - rect.min.x, rect.max.y - rect.min.y});
  const float zoom = std::clamp(rect.scale * std::pow(1.25f, steps), fit, kMostZoom);
  if (zoom <= fit * 1.001f) {
    place = {};
    return;
  }
  // What is under the mouse stays there.
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const vec2 pixel = rect.toPixel(mouse);
  const vec2 middle{0.5f * (rect.min.x + rect.max.x), 0.5f * (rect.min.y + rect.max.y)};
  const vec2 centre = pixel + (middle - vec2(mouse.x, mouse.y)) / zoom;
  place.zoom = zoom;
  place.centre = glm::clamp(centre / vec2(image.width, image.height), vec2(0.0f), vec2(1.0f));
}

void panBy(WindowModel& model, int pane, const PaneRect& rect, const Pipeline::ViewImage& image, ImVec2 way) {
  ViewportPlace& place = placeOf(model, pane);
  if (place.zoom <= 0.0f) return;
  place.centre -= vec2(way.x, way.y) / rect.scale / vec2(image.width, image.height);
  place.centre = glm::clamp(place.centre, vec2(0.0f), vec2(1.0f));
}

std::optional<uvec2> pixelUnder(const PaneRect& rect, const Pipeline::ViewImage& image, ImVec2 place) {
  const vec2 pixel = glm::floor(rect.toPixel(place));
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= float(image.width) || pixel.y >= float(image.height)) return std::nullopt;
  return uvec2(pixel);
}

// A click selects a pixel, or a cell of the slice.
void click(WindowModel& model, int pane, const PanePicture& picture, const View& view, uvec2 pixel, uint32_t width) {
  model.activePane = pane;
  if (view.scope != ViewScope::slice) return model.selection.selectPixel(pixel.y * width + pixel.x);
  const SliceSettings& slice = picture.frame->request.slice;
  const ivec3 cells = picture.frame->parameters.grid.cellCount;
  model.selection.selectCell(sliceCell(cells, slice.axis, slice.index < 0 ? cells[slice.axis] / 2 : slice.index, pixel.y * width + pixel.x));
}

void dragArea(WindowModel& model, const PaneRect& rect, const Pipeline::ViewImage& image) {
  const vec2 a = rect.toPixel(ImGui::GetIO().MouseClickedPos[0]), b = rect.toPixel(ImGui::GetIO().MousePos);
  const vec2 most(image.width, image.height);
  const vec2 low = glm::clamp(glm::floor(glm::min(a, b)), vec2(0.0f), most), high = glm::clamp(glm::ceil(glm::max(a, b)), vec2(0.0f), most);
  model.area = PixelArea{ivec2(low), ivec2(high)};
  if (!ImGui::IsMouseReleased(0)) return;
  model.selectingArea = false;
  if (low.x >= high.x || low.y >= high.y) model.area.reset();
}

// Right button: looks around and flies, keys move. Middle button, or Alt and left: orbits; with Shift it moves aside.
void moveByMouse(WindowModel& model, bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  static int steering = -1;   // button that began over a pane
  if (hovered && steering < 0)
    for (int button : {1, 2})
      if (ImGui::IsMouseClicked(button)) steering = button;
  if (hovered && steering < 0 && io.KeyAlt && ImGui::IsMouseClicked(0)) steering = 0;
  if (steering < 0) return;
  if (steering != 1 && ImGui::IsMouseClicked(steering) && model.frame) aimCamera(model.camera, *model.frame);
  if (!ImGui::IsMouseDown(steering)) {
    steering = -1;
    model.flying = false;
    return;
  }
  CameraState& camera = model.camera;
  const ImVec2 way = io.MouseDelta;
  if (steering != 1) {
    if (io.KeyShift) {
      const float perPixel = 2.0f * std::tan(0.5f * glm::radians(camera.pose.verticalFovDegrees)) * glm::distance(camera.pose.eye, camera.pose.target) / 800.0f;
      moveCamera(camera, {-way.x * perPixel, way.y * perPixel, 0.0f});
    } else {
      orbitCamera(camera, -way.x * kTurnPerPixel, -way.y * kTurnPerPixel);
    }
    return;
  }
  model.flying = true;
  if (way.x != 0.0f || way.y != 0.0f) turnCamera(camera, -way.x * kTurnPerPixel, -way.y * kTurnPerPixel);
  if (io.MouseWheel != 0.0f) camera.speed *= std::pow(1.2f, io.MouseWheel);
  const auto axis = [](int more, int less) { return float(ImGui::IsKeyDown(more)) - float(ImGui::IsKeyDown(less)); };
  const vec3 keys(axis('D', 'A'), axis('E', 'Q'), axis('W', 'S'));
  if (keys != vec3(0.0f)) moveCamera(camera, keys * (camera.speed * io.DeltaTime * (io.KeyShift ? 4.0f : 1.0f)));
}

void drawSelectedPixel(const WindowModel& model, const PaneRect& rect, const Pipeline::ViewImage& image) {
  const std::optional<uint32_t> pixel = model.selected().pixel;
  if (!pixel || *pixel >= image.width * image.height || !model.overlays.selection) return;
  const vec2 corner(*pixel % image.width, *pixel / image.width);
  const ImVec2 low = rect.toScreen(corner), high = rect.toScreen(corner + 1.0f);
  const float grow = std::max(0.0f, unit(4) - 0.5f * rect.scale);
  const ImVec2 a{low.x - grow, low.y - grow}, b{high.x + grow, high.y + grow}, middle{0.5f * (a.x + b.x), 0.5f * (a.y + b.y)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const auto& [colour, width] : {std::pair{IM_COL32(0, 0, 0, 160), unit(3)}, std::pair{IM_COL32(255, 255, 255, 255), unit(1)}}) {
    list.AddRect(a, b, colour, 0.0f, 0, width);
    list.AddLine({a.x - unit(5), middle.y}, {a.x, middle.y}, colour, width);
    list.AddLine({b.x, middle.y}, {b.x + unit(5), middle.y}, colour, width);
    list.AddLine({middle.x, a.y - unit(5)}, {middle.x, a.y}, colour, width);
    list.AddLine({middle.x, b.y}, {middle.x, b.y + unit(5)}, colour, width);
  }
}

void drawArea(const WindowModel& model, const PaneRect& rect) {
  if (!model.area) return;
  const ImVec2 a = rect.toScreen(vec2(model.area->begin)), b = rect.toScreen(vec2(model.area->end));
  ImGui::GetWindowDrawList()->AddRect(a, b, IM_COL32(0, 0, 0, 160), 0.0f, 0, unit(3));
  ImGui::GetWindowDrawList()->AddRect(a, b, IM_COL32(255, 255, 255, 255), 0.0f, 0, unit(1));
}

// What lies under the mouse, in words: pixel, value, cell, triangle, depth.
std::string readOut(const FrameSnapshot& frame, const View& view, const Pipeline::ViewImage& image, uvec2 pixel) {
  const uint32_t index = pixel.y * image.width + pixel.x;
  const std::string value = elementText(image.elements[index], view.unit);
  if (view.scope == ViewScope::slice) {
    const ivec3 cells = frame.parameters.grid.cellCount;
    const SliceSettings& slice = frame.request.slice;
    const ivec3 cell = sliceCell(cells, slice.axis, slice.index < 0 ? cells[slice.axis] / 2 : slice.index, index);
    return printed("cell %d, %d, %d  |  %s", cell.x, cell.y, cell.z, value.c_str());
  }
  std::string text = printed("pixel %u, %u", pixel.x, pixel.y);
  if (view.range != ViewRange::none) text += "  |  " + value;
  if (!frame.gather || index >= frame.gather->size()) return text;
  const GatherPixel& seen = (*frame.gather)[index];
  if (seen.reference == kBlank) return text + "  |  nothing seen";
  const ivec3 cell = gridCell(frame.parameters.grid, seen.position);
  text += printed("  |  cell %d, %d, %d", cell.x, cell.y, cell.z);
  if (frame.scene && referenceInstance(seen.reference) < frame.scene->numbered.sources.size()) {
    const TriangleName name = nameTriangle(frame.scene->numbered, seen.reference);
    const std::string mesh = name.mesh < frame.scene->names.meshes.size() ? frame.scene->names.meshes[name.mesh] : "mesh";
    text += printed("  |  %s, triangle %s", mesh.c_str(), grouped(name.triangle).c_str());
  }
  return text + printed("  |  depth %.3g", double(seen.depth));
}

void drawReadOut(const std::string& text, ImVec2 low, ImVec2 high, ImVec2 legend) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* font = windowFonts().mono;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.c_str());
  ImVec2 corner{low.x + unit(8), high.y - unit(8) - size.y - unit(10)};
  if (corner.x + size.x + unit(24) > high.x - legend.x) corner.y -= legend.y;
  list.AddRectFilled(corner, {corner.x + size.x + unit(14), corner.y + size.y + unit(10)}, IM_COL32(20, 23, 27, 225), unit(3));
  list.AddText(font, font->FontSize, {corner.x + unit(7), corner.y + unit(5)}, IM_COL32(217, 223, 229, 255), text.c_str());
}

void drawNothing(const WindowModel& model, const PanePicture& picture, ImVec2 low, ImVec2 high) {
  const View* view = findView(picture.view);
  std::string text = "Nothing to show yet";
  if (picture.frame && picture.frame != model.frame.get()) text = "The kept frame does not hold this view: choose another, or keep it again with K";
  else if (view && model.frame) text = std::string(view->title) + " is being made";
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::GetWindowDrawList()->AddText({0.5f * (low.x + high.x - size.x), 0.5f * (low.y + high.y - size.y)}, packed(uiColour(UiColour::dim)), text.c_str());
}

// The split of a comparison, which can be dragged.
void dragSplit(WindowModel& model, ImVec2 low, ImVec2 high) {
  CompareState& compare = model.comparison;
  const float x = low.x + compare.split * (high.x - low.x);
  ImGui::SetCursorScreenPos({x - unit(6), low.y});
  ImGui::InvisibleButton("split", {unit(12), high.y - low.y});
  ImGui::SetItemAllowOverlap();
  if (ImGui::IsItemActive()) compare.split = std::clamp((ImGui::GetIO().MousePos.x - low.x) / std::max(high.x - low.x, 1.0f), 0.0f, 1.0f);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({x, low.y}, {x, high.y}, IM_COL32(0, 0, 0, 180), unit(3));
  list.AddLine({x, low.y}, {x, high.y}, IM_COL32(255, 255, 255, 255), unit(1));
}

void drawLetter(const char* letter, ImVec2 place) {
  ImFont* font = windowFonts().sansBold;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(place, {place.x + unit(22), place.y + unit(22)}, IM_COL32(20, 23, 27, 225), unit(3));
  list.AddText(font, font->FontSize, {place.x + unit(6), place.y + unit(3)}, IM_COL32(255, 255, 255, 255), letter);
}

}  // namespace

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

void drawPane(WindowModel& model, int pane, ImVec2 low, ImVec2 high, const PanePicture& first, const PanePicture* second, ImVec2 legend) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushID(pane);
  list.PushClipRect(low, high, true);
  list.AddRectFilled(low, high, IM_COL32(20, 23, 27, 255));
  const bool flipped = second && model.comparison.flip && !model.comparison.wipes;
  const PanePicture& front = flipped ? *second : first;
  const auto image = imageOf(front);
  const View* view = findView(front.view);
  if (!image || !view || !paint(front, model.colourMap)) {
    drawNothing(model, front, low, high);
    ImGui::SetCursorScreenPos(low);
    if (ImGui::InvisibleButton("pane", {std::max(high.x - low.x, 1.0f), std::max(high.y - low.y, 1.0f)})) model.activePane = pane;
  } else {
    const PaneRect rect = paneRect(model, pane, low, high, front, *image);
    model.shownScale = rect.scale;
    drawImage(list, rect, front, *image);
    const bool wipes = second && model.comparison.wipes;
    if (wipes) {
      const float x = low.x + model.comparison.split * (high.x - low.x);
      list.PushClipRect({x, low.y}, high, true);
      list.AddRectFilled({x, low.y}, high, IM_COL32(20, 23, 27, 255));
      if (const auto other = imageOf(*second); other && paint(*second, model.colourMap)) drawImage(list, paneRect(model, pane, low, high, *second, *other), *second, *other);
      else drawNothing(model, *second, {x, low.y}, high);
      list.PopClipRect();
    }
    if (view->scope != ViewScope::slice) {
      drawOverlays(model, rect);
      drawSelectedPixel(model, rect, *image);
      drawArea(model, rect);
    }

    ImGui::SetCursorScreenPos(low);
    ImGui::InvisibleButton("pane", {std::max(high.x - low.x, 1.0f), std::max(high.y - low.y, 1.0f)});
    ImGui::SetItemAllowOverlap();
    const bool hovered = ImGui::IsItemHovered();
    const ImGuiIO& io = ImGui::GetIO();
    const bool still = std::hypot(io.MousePos.x - io.MouseClickedPos[0].x, io.MousePos.y - io.MouseClickedPos[0].y) < kClickSlack;
    const std::optional<uvec2> under = hovered ? pixelUnder(rect, *image, io.MousePos) : std::nullopt;
    if (hovered && io.MouseWheel != 0.0f && !model.flying) {
      if (io.KeyAlt) dollyCamera(model.camera, std::pow(0.9f, io.MouseWheel));
      else zoomAt(model, pane, rect, *image, io.MouseWheel);
    }
    if (model.selectingArea && (ImGui::IsItemActive() || ImGui::IsItemDeactivated())) dragArea(model, rect, *image);
    else if (ImGui::IsItemDeactivated() && still && under && !io.KeyAlt) click(model, pane, front, *view, *under, image->width);
    else if (ImGui::IsItemActive() && !io.KeyAlt && !still) panBy(model, pane, rect, *image, io.MouseDelta);
    moveByMouse(model, hovered);
    if (under) model.hoveredPixel = view->scope == ViewScope::slice ? std::nullopt : std::optional(under->y * image->width + under->x);
    if (under) drawReadOut(readOut(*front.frame, *view, *image, *under), low, high, legend);
    if (wipes) {
      dragSplit(model, low, high);
      drawLetter("A", {low.x + unit(8), low.y + unit(8)});
      drawLetter("B", {high.x - unit(30), low.y + unit(8)});
    } else if (second) {
      drawLetter(flipped ? "B" : "A", {low.x + unit(8), low.y + unit(8)});
    }
  }
  list.PopClipRect();
  ImGui::PopID();
}

}  // namespace gridscope
