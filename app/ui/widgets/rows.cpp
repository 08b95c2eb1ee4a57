// See rows.h.
#include "app/ui/widgets/rows.h"

#include <imgui_internal.h>

#include "app/base/text.h"

namespace gridscope {

namespace {

constexpr float kLabelWidth = 134;  // pixels at UI scale 1

const char* lockedWhy = "";

float placeIn(const SliderRange& range, float value) {
  const float share = range.logarithmic ? std::log(std::max(value, range.low) / range.low) / std::log(range.high / range.low)
                                        : (value - range.low) / (range.high - range.low);
  return std::clamp(share, 0.0f, 1.0f);
}

// The fill under the control that comes next, and the line where it ends.
void drawFill(const ImVec2& low, const ImVec2& high, float share) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float alpha = ImGui::GetStyle().Alpha, rounding = ImGui::GetStyle().FrameRounding, x = std::floor(low.x + share * (high.x - low.x));
  const auto faded = [&](ImVec4 colour) { return colour.w *= alpha, packed(colour); };
  list.AddRectFilled(low, high, faded(uiColour(UiColour::control)), rounding);
  if (share > 0.0f)
    list.AddRectFilled(low, {std::max(x, low.x + rounding), high.y}, faded(uiColour(UiColour::selectedRow)), rounding,
                       ImDrawFlags_RoundCornersLeft);
  list.AddRectFilled({std::clamp(x - unit(1), low.x, high.x - unit(2)), low.y}, {std::clamp(x + unit(1), low.x + unit(2), high.x), high.y},
                     faded(uiColour(*lockedWhy ? UiColour::disabled : UiColour::accent)));
}

// `control` is ImGui's slider without its looks; `text`: what the value then reads.
template <typename Control, typename Text>
bool slide(const char* id, float share, const Control& control, const Text& text) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight()};
  const bool typing = ImGui::TempInputIsActive(ImGui::GetID(id));
  const ImVec4 clear{0, 0, 0, 0};
  if (!typing) drawFill(low, high, share);
  ImGui::PushFont(windowFonts().mono);
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, clear), ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, clear);
  for (const ImGuiCol colour : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive})
    ImGui::PushStyleColor(colour, typing ? ImGui::GetStyleColorVec4(colour) : clear);
  ImGui::PushStyleColor(ImGuiCol_Text, typing ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : clear);
  const bool changed = control();
  ImGui::PopStyleColor(6);
  if (!typing) {
    const std::string value = text();
    const ImVec2 size = ImGui::CalcTextSize(value.c_str());
    ImGui::GetWindowDrawList()->AddText({high.x - size.x - unit(6), low.y + 0.5f * (high.y - low.y - size.y)},
                                        ImGui::GetColorU32(ImGuiCol_Text), value.c_str());
  }
  ImGui::PopFont();
  return changed;
}

ImGuiSliderFlags flagsOf(const SliderRange& range) { return range.logarithmic ? ImGuiSliderFlags_Logarithmic : 0; }

}  // namespace

Locked::Locked(const char* why) : before_(lockedWhy) {
  if (*why) lockedWhy = why;
  ImGui::BeginDisabled(*why != '\0');
}

Locked::~Locked() {
  ImGui::EndDisabled();
  lockedWhy = before_;
}

void whyLocked() { whyTooltip(lockedWhy); }

void rowLabel(const char* words, const char* about) {
  ImGui::AlignTextToFramePadding();
  textDim(words);
  whyTooltip((std::string(about) + (*about && *lockedWhy ? "\n" : "") + lockedWhy).c_str());
  ImGui::SameLine(unit(kLabelWidth));
  ImGui::SetNextItemWidth(-1);
}

bool fillSlider(const char* id, float& value, const SliderRange& range, const char* format) {
  return slide(
      id, placeIn(range, value), [&] { return ImGui::SliderFloat(id, &value, range.low, range.high, format, flagsOf(range)); },
      [&] { return printed(format, double(value)); });
}

bool fillSlider(const char* id, int& value, const SliderRange& range, const char* format) {
  return slide(
      id, placeIn(range, float(value)),
      [&] { return ImGui::SliderInt(id, &value, int(range.low), int(range.high), format, flagsOf(range)); },
      [&] { return printed(format, value); });
}

}  // namespace gridscope
