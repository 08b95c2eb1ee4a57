// See plot_frame.h.
#include "app/ui/panels/plot_frame.h"

#include <algorithm>

#include "app/ui/widgets/widgets.h"

namespace gridscope {

static ImFont* plotFont(bool number) { return number ? windowFonts().mono : windowFonts().sansSmall; }

float plotTextWidth(const std::string& text, bool number) {
  ImGui::PushFont(plotFont(number));
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::PopFont();
  return width;
}

float plotText(const ImVec2& place, const std::string& text, const ImVec4& colour, bool number) {
  ImGui::PushFont(plotFont(number));
  ImGui::GetWindowDrawList()->AddText(place, packed(colour), text.c_str());
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::PopFont();
  return width;
}

void dashedLine(float x, float top, float bottom, ImU32 colour) {
  for (float y = top; y < bottom; y += unit(7))
    ImGui::GetWindowDrawList()->AddLine(ImVec2(x, y), ImVec2(x, std::min(bottom, y + unit(4))), colour, unit(1));
}

static float lineHeight() { return unit(15); }

PlotFrame::PlotFrame(const PlotLook& look, const ImVec2& low, const ImVec2& high) : scaleX_(look.x), scaleY_(look.y) {
  float labels = 0.0f;
  for (const PlotTick& tick : plotTicks(look.y, 6)) labels = std::max(labels, plotTextWidth(tick.text + look.yUnit, true));
  low_ = ImVec2(low.x + labels + unit(8), low.y + unit(24));
  high_ = ImVec2(high.x - unit(look.legendWidth) - unit(6), high.y - unit(look.footHeight) - (look.ticksX ? lineHeight() + unit(2) : 0.0f) -
                                                                (look.xTitle.empty() ? 0.0f : lineHeight()));

  ImGui::PushFont(windowFonts().sansBold);
  if (!look.title.empty())
    ImGui::GetWindowDrawList()->AddText(ImVec2(low.x, low.y + unit(2)), packed(uiColour(UiColour::text)), look.title.c_str());
  const float titleWidth = ImGui::CalcTextSize(look.title.c_str()).x;
  ImGui::PopFont();
  const float noteWidth = plotTextWidth(look.note, false);
  if (!look.title.empty() && titleWidth + noteWidth + unit(12) < high.x - low.x)
    plotText(ImVec2(high.x - noteWidth - unit(6), low.y + unit(3)), look.note, uiColour(UiColour::dim), false);
  if (!drawn()) return;
  drawYTicks(look);
  drawXTicks(look);
  if (!look.xTitle.empty())
    plotText(ImVec2(0.5f * (low_.x + high_.x - plotTextWidth(look.xTitle, false)), high_.y + lineHeight() + unit(2)), look.xTitle,
             uiColour(UiColour::dim), false);
}

void PlotFrame::drawYTicks(const PlotLook& look) const {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const int most = std::clamp(int((high_.y - low_.y) / unit(18)), 2, 8);
  for (const PlotTick& tick : plotTicks(look.y, most)) {
    const float place = y(tick.value);
    const std::string label = tick.text + look.yUnit;
    list->AddLine(ImVec2(low_.x, place), ImVec2(high_.x, place), packed(uiColour(UiColour::line)), 1.0f);
    plotText(ImVec2(low_.x - unit(6) - plotTextWidth(label, true), place - 0.5f * unit(13)), label, uiColour(UiColour::dim), true);
  }
}

void PlotFrame::drawXTicks(const PlotLook& look) const {
  if (!look.ticksX) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const int most = std::clamp(int((high_.x - low_.x) / unit(46)), 2, 10);
  float free = low_.x - unit(20);
  for (const PlotTick& tick : plotTicks(look.x, most)) {
    const float place = x(tick.value), width = plotTextWidth(tick.text, true);
    list->AddLine(ImVec2(place, look.gridX ? low_.y : high_.y), ImVec2(place, high_.y + unit(3)), packed(uiColour(UiColour::line)), 1.0f);
    const float left = std::min(place - 0.5f * width, high_.x + unit(6) - width);
    if (left < free) continue;
    plotText(ImVec2(left, high_.y + unit(3)), tick.text, uiColour(UiColour::dim), true);
    free = left + width + unit(8);
  }
}

float PlotFrame::x(double value) const { return low_.x + (high_.x - low_.x) * float(std::clamp(scaleX_.placeOf(value), -0.1, 1.1)); }
float PlotFrame::y(double value) const { return high_.y - (high_.y - low_.y) * float(std::clamp(scaleY_.placeOf(value), -0.1, 1.1)); }

bool PlotFrame::hovered() const { return drawn() && ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low_, high_); }

double PlotFrame::mouseX() const { return scaleX_.valueAt(double(ImGui::GetIO().MousePos.x - low_.x) / double(high_.x - low_.x)); }

}  // namespace gridscope
