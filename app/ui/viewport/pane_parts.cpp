// See pane_parts.h.
#include "app/ui/viewport/pane_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/frame/read_out.h"
#include "app/model/held_ray.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

constexpr ImU32 kBack = IM_COL32(20, 23, 27, 225), kText = IM_COL32(217, 223, 229, 255), kDim = IM_COL32(143, 154, 166, 255);
constexpr size_t kMostLines = 2;  // of a read-out
constexpr float kRaised = 30.0f;  // by a row at the foot, pixels at UI scale 1
constexpr float kAxes = 92.0f;    // room of the axes in the upper right corner

ImVec2 textSize(ImFont* font, const std::string& text) { return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.c_str()); }

}  // namespace

void drawSelectedPixel(const WindowModel& model, const PaneRect& rect, uvec2 size) {
  const std::optional<uint32_t> pixel = model.selected().pixel;
  if (!pixel || *pixel >= size.x * size.y || !model.overlays.selection || rayIsHeld(model)) return;
  const vec2 corner(*pixel % size.x, *pixel / size.x);
  const ImVec2 low = rect.toScreen(corner), high = rect.toScreen(corner + 1.0f);
  if (high.x < rect.min.x || high.y < rect.min.y || low.x > rect.max.x || low.y > rect.max.y) return;
  const float grow = std::max(0.0f, unit(4) - 0.5f * rect.scale), edge = unit(2), tick = unit(5);
  const ImVec2 a{std::max(low.x - grow, rect.min.x + edge), std::max(low.y - grow, rect.min.y + edge)};
  const ImVec2 b{std::min(high.x + grow, rect.max.x - edge), std::min(high.y + grow, rect.max.y - edge)},
      middle{0.5f * (a.x + b.x), 0.5f * (a.y + b.y)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const auto& [colour, width] : {std::pair{IM_COL32(0, 0, 0, 160), unit(3)}, std::pair{IM_COL32(255, 255, 255, 255), unit(1)}}) {
    list.AddRect(a, b, colour, 0.0f, 0, width);
    list.AddLine({a.x - tick, middle.y}, {a.x, middle.y}, colour, width);
    list.AddLine({b.x, middle.y}, {b.x + tick, middle.y}, colour, width);
    list.AddLine({middle.x, a.y - tick}, {middle.x, a.y}, colour, width);
    list.AddLine({middle.x, b.y}, {middle.x, b.y + tick}, colour, width);
  }
}

void drawArea(const WindowModel& model, const PaneRect& rect) {
  if (!model.area) return;
  const ImVec2 a = rect.toScreen(vec2(model.area->begin)), b = rect.toScreen(vec2(model.area->end));
  ImGui::GetWindowDrawList()->AddRect(a, b, IM_COL32(0, 0, 0, 160), 0.0f, 0, unit(3));
  ImGui::GetWindowDrawList()->AddRect(a, b, IM_COL32(255, 255, 255, 255), 0.0f, 0, unit(1));
}

ImVec2 lowerLeft(const PaneRect& rect, ImVec2 size) {
  ImVec2 corner{rect.min.x + unit(10), rect.max.y - unit(10) - size.y};
  if (rect.legend.x > 0.0f && corner.x + size.x + unit(20) > rect.max.x - rect.legend.x) corner.y -= rect.legend.y + unit(6);
  return corner;
}

void drawReadOut(const std::vector<std::string>& parts, const PaneRect& rect, bool raised) {
  ImFont* font = windowFonts().mono;
  const float letter = std::max(textSize(font, "0").x, 1.0f), room = rect.max.x - rect.min.x - unit(20 + 14);
  const std::vector<std::string> lines = readOutLines(parts, size_t(std::max(room / letter, 1.0f)), kMostLines);
  ImVec2 size(0.0f, unit(10));
  for (const std::string& line : lines) size = {std::max(size.x, textSize(font, line).x + unit(14)), size.y + font->FontSize + unit(2)};
  ImVec2 corner = lowerLeft(rect, size);
  if (raised) corner.y -= unit(kRaised);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(rect.min, rect.max, true);
  list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, kBack, unit(3));
  float y = corner.y + unit(6);
  for (const std::string& line : lines) {
    list.AddText(font, font->FontSize, {corner.x + unit(7), y}, kText, line.c_str());
    y += font->FontSize + unit(2);
  }
  list.PopClipRect();
}

// Why a view is not there, and what brings it.
static std::string whyMissing(const WindowModel& model, const View& view) {
  const std::string title(view.title);
  const bool ofTruth = view.need == ViewNeed::truth || view.need == ViewNeed::triangleCosts;
  if (ofTruth && !model.request.truth && model.truthDeclined) return title + " needs the truth, which was cancelled: Ctrl+T tells it";
  if (view.need == ViewNeed::cellUpdates && model.frame->scene && model.frame->scene->foreign)
    return title + ": what another engine's update changed is not known";
  if (view.need == ViewNeed::cellUpdates && model.frame->scene && model.frame->scene->captureFrames > 0)
    return title + ": step time once, Ctrl+Right, to see what the next update changes";
  return title + " is being made";
}

void drawNothing(const WindowModel& model, const PanePicture& picture, ImVec2 low, ImVec2 high) {
  const View* view = findView(picture.view);
  std::string text = "Nothing to show yet";
  if (!picture.frame && model.frame)
    text = "No frame is kept: K keeps the present one as B";
  else if (picture.frame != model.frame.get())
    text = model.comparison.completing ? "This view of the kept frame is on its way"
                                       : "The kept frame does not hold this view: choose another, or keep it again with K";
  else if (view && model.frame)
    text = whyMissing(model, *view);
  const float most = std::max(high.x - low.x - unit(20), unit(40));
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, most);
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                                      {0.5f * (low.x + high.x - size.x), 0.5f * (low.y + high.y - size.y)}, kDim, text.c_str(), nullptr,
                                      most);
}

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

void drawLetter(const char* letter, const std::string& words, const PaneRect& rect, bool right) {
  ImFont *bold = windowFonts().sansBold, *small = windowFonts().sansSmall;
  const float wordsWidth = words.empty() ? 0.0f : textSize(small, words).x + unit(10);
  const ImVec2 size{unit(22) + wordsWidth, unit(22)};
  float x = rect.min.x + unit(8);
  if (right) x = std::max(x, rect.max.x - size.x - unit(kAxes));
  const ImVec2 place{x, rect.min.y + unit(8)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(rect.min, rect.max, true);
  list.AddRectFilled(place, {place.x + size.x, place.y + size.y}, kBack, unit(3));
  list.AddText(bold, bold->FontSize, {place.x + unit(6), place.y + 0.5f * (size.y - bold->FontSize)}, IM_COL32_WHITE, letter);
  if (!words.empty())
    list.AddText(small, small->FontSize, {place.x + unit(22), place.y + 0.5f * (size.y - small->FontSize)}, kText, words.c_str());
  list.PopClipRect();
}

}  // namespace gridscope
