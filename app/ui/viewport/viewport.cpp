// See viewport.h; pane.h draws each view.
#include "app/ui/viewport/viewport.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/frame/changes.h"
#include "app/model/flow.h"
#include "app/model/held_ray.h"
#include "app/model/ray_stepping.h"
#include "app/ui/viewport/pane.h"
#include "app/ui/viewport/steering.h"
#include "app/ui/widgets/action_button.h"
#include "app/ui/widgets/legend.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

constexpr float kBarHeight = 30, kPaneHead = 24, kPaneGap = 3;  // pixels at UI scale 1
constexpr const char* kMapNames[] = {"Viridis", "Cividis", "Magma", "Grey"};

// Small pictures of the layouts.
bool layoutButton(const char* id, ViewportLayout layout, bool chosen) {
  const float side = unit(22);
  const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + side, low.y + side};
  const bool clicked = ImGui::InvisibleButton(id, {side, side});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (chosen || ImGui::IsItemHovered())
    list.AddRectFilled(low, high, packed(uiColour(chosen ? UiColour::selectedRow : UiColour::control)), unit(3));
  const ImU32 colour = packed(uiColour(chosen ? UiColour::link : UiColour::dim));
  const float a = unit(6), b = side - a, middle = 0.5f * side, gap = unit(1);
  const auto box = [&](float x0, float y0, float x1, float y1) {
    list.AddRectFilled({low.x + x0, low.y + y0}, {low.x + x1, low.y + y1}, colour);
  };
  if (layout == ViewportLayout::one) box(a, a, b, b);
  if (layout == ViewportLayout::four)
    box(a, a, middle - gap, middle - gap), box(middle + gap, a, b, middle - gap), box(a, middle + gap, middle - gap, b),
        box(middle + gap, middle + gap, b, b);
  if (layout == ViewportLayout::compare) {
    box(a, a, middle - gap, b);
    list.AddRect({low.x + middle + gap, low.y + a}, {low.x + b, low.y + b}, colour);
  }
  ImGui::SameLine(0.0f, unit(2));
  return clicked;
}

void chooseView(const char* id, std::string& chosen, float width) {
  const View* view = findView(chosen);
  const std::string shown = viewLabel(view ? view->name : std::string_view(chosen));
  ImGui::SetNextItemWidth(width);
  if (!ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLargest)) return;
  for (const View& one : allViews()) {
    const std::string name(one.name);
    if (ImGui::Selectable(viewLabel(name).c_str(), name == chosen)) chosen = name;
    whyTooltip(std::string(one.about).c_str());
  }
  ImGui::EndCombo();
}

PanePicture pictureOf(const WindowModel& model, int pane) {
  const Pane& shown = model.panes[size_t(pane)];
  return {.frame = model.frame.get(), .view = shown.view, .key = "pane " + std::to_string(pane), .range = shown.range};
}

// B: another view of this frame, or the same view of the kept one, in the same colours.
PanePicture secondPicture(const WindowModel& model) {
  PanePicture second = pictureOf(model, model.activePane);
  if (model.comparison.with == CompareState::With::frame) {
    second.range = shownRange(second);
    second.frame = model.comparison.kept.get();
  } else {
    const Pane& other = model.panes[size_t(model.activePane) ^ 1u];
    second.view = other.view;
    second.range = other.range;
  }
  second.key = "second";
  return second;
}

void barRange(WindowModel& model) {
  Pane& pane = model.panes[size_t(model.activePane)];
  const View* view = findView(pane.view);
  if (!view || view->range == ViewRange::none) return;
  ImGui::SameLine(0.0f, unit(12));
  ImGui::AlignTextToFramePadding();
  textDim("Range");
  ImGui::SameLine();
  ValueRange range = shownRange(pictureOf(model, model.activePane));
  ImGui::PushFont(windowFonts().mono);
  bool changed = false;
  for (int end = 0; end < 2; ++end) {
    ImGui::SetNextItemWidth(unit(58));
    ImGui::PushID(end);
    changed |= ImGui::DragFloat("##range", &range[size_t(end)], 0.005f * std::max(range[1] - range[0], 1e-3f), 0, 0, "%.4g");
    ImGui::PopID();
    ImGui::SameLine(0.0f, unit(4));
  }
  ImGui::PopFont();
  if (changed && range[0] < range[1]) pane.range = range;
  actionButton(model, "Fit range", "Fit");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(unit(90));
  if (ImGui::BeginCombo("##map", kMapNames[model.colourMap])) {
    for (uint32_t map = 0; map < kColourMapCount; ++map)
      if (ImGui::Selectable(kMapNames[map], map == model.colourMap)) model.colourMap = map;
    ImGui::EndCombo();
  }
}

void barSlice(WindowModel& model) {
  if (model.panes[size_t(model.activePane)].view != "slice" || !model.frame) return;
  SliceSettings& slice = model.request.slice;
  const ivec3 cells = model.frame->parameters.grid.cellCount;
  ImGui::SameLine(0.0f, unit(12));
  ImGui::SetNextItemWidth(unit(50));
  if (ImGui::Combo("##axis", &slice.axis, "x\0y\0z\0")) slice.index = -1;
  ImGui::SameLine(0.0f, unit(4));
  int index = slice.index < 0 ? cells[slice.axis] / 2 : std::min(slice.index, cells[slice.axis] - 1);
  ImGui::SetNextItemWidth(unit(140));
  if (ImGui::SliderInt("##layer", &index, 0, cells[slice.axis] - 1, "layer %d", ImGuiSliderFlags_AlwaysClamp)) slice.index = index;
}

void barCompare(WindowModel& model) {
  if (model.layout != ViewportLayout::compare) return;
  CompareState& compare = model.comparison;
  ImGui::SameLine(0.0f, unit(12));
  ImGui::AlignTextToFramePadding();
  textDim("B");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(unit(110));
  int with = compare.with == CompareState::With::frame ? 1 : 0;
  if (ImGui::Combo("##with", &with, "view\0kept frame\0")) compare.with = with == 1 ? CompareState::With::frame : CompareState::With::view;
  ImGui::SameLine();
  if (compare.with == CompareState::With::view)
    chooseView("##second", model.panes[size_t(model.activePane) ^ 1u].view, unit(120));
  else
    actionButton(model, "Keep frame as B", "Keep");
  ImGui::SameLine();
  if (ImGui::RadioButton("wipe", compare.wipes)) compare.wipes = true;
  whyTooltip("Both, with a split between them that can be dragged");
  ImGui::SameLine();
  if (ImGui::RadioButton("whole", !compare.wipes)) compare.wipes = false;
  whyTooltip("One of them at a time");
  ImGui::SameLine();
  actionButton(model, "Flip A/B", compare.wipes ? "Flip" : compare.flip ? "B" : "A");
  if (compare.with != CompareState::With::frame || !compare.kept || !compare.kept->request.settings || !model.request.settings) return;
  const CameraPose& kept = compare.kept->request.settings->camera;
  ImGui::SameLine();
  if (keyButton("Its camera", "", !sameCamera(kept, model.camera.pose), "The camera stands where the kept frame's does"))
    model.camera.pose = kept;
  whyTooltip("Moves the live frame's camera to the kept frame's");
}

void barCamera(WindowModel& model, float right, float zoom) {
  const float width = unit(285);
  ImGui::SameLine();
  if (ImGui::GetCursorScreenPos().x + width > right) return;
  ImGui::SetCursorScreenPos({right - width, ImGui::GetCursorScreenPos().y});
  actionButton(model, "Reset camera", "Home##camera");
  ImGui::SameLine(0.0f, unit(4));
  actionButton(model, "Focus", "Focus");
  ImGui::SameLine();
  textMono(printed("%.0f %%", 100.0 * double(zoom)));
}

// With a ray: follow its steps, and go back to where it was recorded from.
void barRay(WindowModel& model) {
  if (!shownStep(model) || !model.overlays.raySegments || model.layout == ViewportLayout::compare) return;
  ImGui::SameLine(0.0f, unit(12));
  ImGui::Checkbox("Follow step", &model.followStep);
  whyTooltip("The camera goes along with the selected step; the ray stays as it was recorded");
  if (!rayIsHeld(model)) return;
  ImGui::SameLine(0.0f, unit(8));
  if (keyButton("Ray's camera", "")) returnToRay(model), model.followStep = false;
  whyTooltip("Goes back to where the shown ray was recorded from");
}

// Returns its height.
float drawBar(WindowModel& model, ImVec2 low, float width) {
  const float height = unit(kBarHeight);
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + height}, packed(uiColour(UiColour::panel)));
  ImGui::SetCursorScreenPos({low.x + unit(8), low.y + unit(4)});
  ImGui::PushClipRect(low, {low.x + width, low.y + height}, true);
  chooseView("##view", model.panes[size_t(model.activePane)].view, unit(140));
  ImGui::SameLine();
  if (layoutButton("one", ViewportLayout::one, model.layout == ViewportLayout::one)) model.layout = ViewportLayout::one;
  if (layoutButton("four", ViewportLayout::four, model.layout == ViewportLayout::four)) model.layout = ViewportLayout::four;
  if (layoutButton("compare", ViewportLayout::compare, model.layout == ViewportLayout::compare)) model.layout = ViewportLayout::compare;
  if (model.layout == ViewportLayout::four) {
    ImGui::SameLine(0.0f, unit(12));
    ImGui::Checkbox("Link zoom", &model.linkedPanes);
  }
  barCompare(model);
  barRange(model);
  barSlice(model);
  barRay(model);
  if (model.selectingArea || model.area) {
    ImGui::SameLine();
    actionButton(model, "Select area", model.area ? "Leave area" : "Draw an area");
  }
  barCamera(model, low.x + width - unit(6), model.shownScale);
  ImGui::PopClipRect();
  return height;
}

// True: the mouse is over a picture.
bool drawFour(WindowModel& model, ImVec2 low, ImVec2 high) {
  bool overPane = false;
  const float gap = unit(kPaneGap), head = unit(kPaneHead);
  const float width = std::floor(0.5f * (high.x - low.x - gap)), height = std::floor(0.5f * (high.y - low.y - gap));
  for (int pane = 0; pane < 4; ++pane) {
    const ImVec2 a{low.x + float(pane % 2) * (width + gap), low.y + float(pane / 2) * (height + gap)}, b{a.x + width, a.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(a, {b.x, a.y + head}, packed(uiColour(UiColour::panel)));
    ImGui::PushID(pane);
    ImGui::SetCursorScreenPos({a.x + unit(4), a.y + unit(1)});
    chooseView("##view", model.panes[size_t(pane)].view, unit(120));
    ImGui::PopID();
    const PaneContent content{.first = pictureOf(model, pane), .legends = false};
    if (const View* view = findView(content.first.view))
      drawLegendLine(model, *view, shownRange(content.first), {b.x - unit(6), a.y + unit(4)}, a.x + unit(130));
    overPane |= drawPane(model, pane, {a.x, a.y + head}, b, content);
    if (pane == model.activePane) list.AddRect({a.x, a.y + head}, b, packed(uiColour(UiColour::accent)), 0.0f, 0, unit(1.5f));
  }
  return overPane;
}

// Of flying, while it lasts.
void drawSpeed(const WindowModel& model, ImVec2 low, ImVec2 high) {
  if (!model.flying) return;
  const std::string words = printed("Fly  %.3g /s   wheel or + - speed, Shift faster", double(model.camera.speed));
  ImFont* font = windowFonts().sansSmall;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, words.c_str());
  const ImVec2 corner{0.5f * (low.x + high.x - size.x), high.y - size.y - unit(64)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({corner.x - unit(10), corner.y - unit(5)}, {corner.x + size.x + unit(10), corner.y + size.y + unit(5)},
                     IM_COL32(20, 23, 27, 225), unit(3));
  list.AddText(font, font->FontSize, corner, IM_COL32(217, 223, 229, 255), words.c_str());
}

// Long work, with its bar and its end, where its result will be.
void drawWork(WindowModel& model, ImVec2 low, ImVec2 high) {
  if (!model.work) return;
  const LongWork& work = *model.work;
  const bool loads = work.kind == LongWork::Kind::source || work.kind == LongWork::Kind::grid;  // there may be no picture under it
  const ImVec2 size{unit(320), unit(84)},
      corner{0.5f * (low.x + high.x - size.x), loads ? 0.5f * (low.y + high.y - size.y) : high.y - size.y - unit(60)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, packed(uiColour(UiColour::head)), unit(3));
  list.AddRect(corner, {corner.x + size.x, corner.y + size.y}, packed(uiColour(UiColour::line)), unit(3));
  ImGui::SetCursorScreenPos({corner.x + unit(12), corner.y + unit(8)});
  const double left = work.share > 0.02f ? work.seconds * double(1.0f / work.share - 1.0f) : -1.0;
  ImGui::Text("%s, %.1f s%s", work.what.c_str(), work.seconds, left >= 0.0 ? printed(", %.0f s left", std::ceil(left)).c_str() : "");
  const ImVec2 bar{corner.x + unit(12), corner.y + unit(32)}, barEnd{corner.x + size.x - unit(12), corner.y + unit(38)};
  list.AddRectFilled(bar, barEnd, packed(uiColour(UiColour::control)), unit(3));
  const float sweep = work.share >= 0.0f ? work.share : 0.3f, width = barEnd.x - bar.x;
  const float begin = work.share >= 0.0f ? 0.0f : float(std::fmod(model.now * 0.6, 1.0)) * 0.7f;
  list.AddRectFilled({bar.x + begin * width, bar.y}, {bar.x + (begin + sweep) * width, barEnd.y}, packed(uiColour(UiColour::accent)),
                     unit(3));
  ImGui::SetCursorScreenPos({corner.x + unit(12), corner.y + unit(48)});
  if (!ImGui::Button("Cancel", {unit(80), unit(24)})) return;
  if (work.kind == LongWork::Kind::truth)
    declineTruth(model);
  else
    model.cancelWork = true;
}

void drawToast(const WindowModel& model, ImVec2 low, ImVec2 high) {
  if (model.now >= model.toastUntil || model.toast.empty()) return;
  const float most = std::min(unit(640), high.x - low.x - unit(40));
  const ImVec2 size = ImGui::CalcTextSize(model.toast.c_str(), nullptr, false, most);
  const ImVec2 corner{0.5f * (low.x + high.x - size.x), low.y + unit(14)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({corner.x - unit(12), corner.y - unit(6)}, {corner.x + size.x + unit(12), corner.y + size.y + unit(6)},
                     IM_COL32(20, 23, 27, 235), unit(3));
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), corner, IM_COL32(235, 239, 243, 255), model.toast.c_str(), nullptr, most);
}

}  // namespace

void drawViewport(WindowModel& model) {
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize(), high{low.x + size.x, low.y + size.y};
  model.hoveredPixel.reset();
  const float bar = drawBar(model, low, size.x);
  const ImVec2 top{low.x, low.y + bar};
  bool overPane = false;
  if (model.layout == ViewportLayout::four) {
    overPane = drawFour(model, top, high);
  } else {
    PaneContent content{.first = pictureOf(model, model.activePane), .second = std::nullopt};
    if (model.layout == ViewportLayout::compare) content.second = secondPicture(model);
    overPane = drawPane(model, model.activePane, top, high, content);
    drawGizmo(model, {high.x - unit(46), top.y + unit(46)}, unit(34));
  }
  steerCamera(model, overPane);
  drawSpeed(model, top, high);
  drawNotices(model, top, high);
}

void drawNotices(WindowModel& model, ImVec2 low, ImVec2 high) {
  drawWork(model, low, high);
  drawToast(model, low, high);
}

}  // namespace gridscope
