// See range_slider.h.
#include "app/ui/panels/range_slider.h"

#include <algorithm>
#include <cmath>

#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

enum Grip { kNone, kLow, kHigh, kBoth };

// What a press at `x` takes hold of.
Grip gripAt(float x, float low, float high) {
  const float reach = unit(8);
  const float toLow = std::abs(x - low), toHigh = std::abs(x - high);
  if (toLow <= reach || toHigh <= reach) return toLow < toHigh || (toLow == toHigh && x < low) ? kLow : kHigh;
  if (x > low && x < high) return kBoth;
  return x < low ? kLow : kHigh;
}

// Where the press began.
struct Drag {
  ImGuiID id = 0;
  Grip grip = kNone;
  double offset = 0.0;  // of the low end's place from the mouse's
  double length = 0.0;  // of the bar, as a share of the slider
};

bool moveRange(const Drag& drag, double place, const PlotScale& scale, std::array<float, 2>& range) {
  const std::array<float, 2> before = range;
  const double least = 1e-3;  // of the slider's length between the ends
  if (drag.grip == kLow) {
    range[0] = float(scale.valueAt(std::clamp(place, 0.0, std::max(0.0, scale.placeOf(range[1]) - least))));
  } else if (drag.grip == kHigh) {
    range[1] = float(scale.valueAt(std::clamp(place, std::min(1.0, scale.placeOf(range[0]) + least), 1.0)));
  } else {
    const double low = std::clamp(place + drag.offset, 0.0, std::max(0.0, 1.0 - drag.length));
    range = {float(scale.valueAt(low)), float(scale.valueAt(std::min(1.0, low + drag.length)))};
  }
  return range != before && range[0] < range[1];
}

void drawHandle(ImDrawList* list, float x, float middle, ImU32 colour) {
  list->AddRectFilled(ImVec2(x - unit(3), middle - unit(6)), ImVec2(x + unit(3), middle + unit(6)), colour, unit(2));
}

}  // namespace

float rangeSliderHeight() { return unit(14); }

bool rangeSlider(const char* id, const std::array<float, 3>& placeAndWidth, const PlotScale& scale, std::array<float, 2>& range,
                 bool enabled) {
  static Drag drag;
  const auto [left, top, width] = placeAndWidth;
  const auto xOf = [&](float value) { return left + width * float(std::clamp(scale.placeOf(value), 0.0, 1.0)); };
  ImGui::SetCursorScreenPos(ImVec2(left - unit(4), top));
  const ImGuiID item = ImGui::GetID(id);
  ImGui::BeginDisabled(!enabled);
  ImGui::InvisibleButton(id, ImVec2(width + unit(8), rangeSliderHeight()));
  ImGui::EndDisabled();
  bool changed = false;
  const double place = double(ImGui::GetIO().MousePos.x - left) / double(width);
  if (enabled && ImGui::IsItemActivated()) {
    const double low = scale.placeOf(range[0]), high = scale.placeOf(range[1]);
    drag = {
        .id = item, .grip = gripAt(ImGui::GetIO().MousePos.x, xOf(range[0]), xOf(range[1])), .offset = low - place, .length = high - low};
  }
  if (enabled && ImGui::IsItemActive() && drag.id == item) changed = moveRange(drag, place, scale, range);

  const float middle = top + 0.5f * rangeSliderHeight();
  const bool held = ImGui::IsItemActive() || ImGui::IsItemHovered();
  const ImU32 colour = packed(uiColour(enabled ? UiColour::accent : UiColour::disabled));
  ImVec4 bar = uiColour(enabled ? UiColour::accent : UiColour::disabled);
  bar.w = held ? 0.75f : 0.5f;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(ImVec2(left, middle - unit(2)), ImVec2(left + width, middle + unit(2)), packed(uiColour(UiColour::control)), unit(2));
  list->AddRectFilled(ImVec2(xOf(range[0]), middle - unit(2)), ImVec2(xOf(range[1]), middle + unit(2)), packed(bar));
  drawHandle(list, xOf(range[0]), middle, colour);
  drawHandle(list, xOf(range[1]), middle, colour);
  return changed;
}

}  // namespace gridscope
