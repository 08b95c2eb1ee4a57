// The rows of the left panel: a label, and a control that changes one setting of the frame, remembers it for undo, and says why where it can't
// be used.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/model/window_model.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

// Controls that follow are disabled while it lives and `why` is not empty; their tooltips say why.
class Locked {
 public:
  explicit Locked(const char* why);
  ~Locked();
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  const char* before_;
};

// The label; the control that follows takes the rest of the row.
void rowLabel(const char* words, const char* about = "");

// Where a slider's fill ends, and between which values dragging moves it; more can be typed (Ctrl and click).
struct SliderRange {
  float low, high;
  bool logarithmic = false;
};

// The control alone, its value at the right over a fill of the accent colour; true while it changes `value`.
bool fillSlider(const char* id, float& value, const SliderRange& range, const char* format);
bool fillSlider(const char* id, int& value, const SliderRange& range, const char* format = "%d");

// Call after the control: one entry of the undo list for one drag.
template <typename Change>
void applyChange(WindowModel& model, bool changed, const Change& change) {
  static FrameSettings before;
  static bool kept = false;
  if (ImGui::IsItemActivated()) before = *model.request.settings, kept = true;
  if (!changed) return;
  if (kept || !ImGui::IsItemActive()) {
    model.rememberForUndo(kept ? before : *model.request.settings);
    kept = false;
  }
  change(*model.request.settings);
}

void whyLocked();  // tooltip of the item before, where it is locked

// A number that is dragged along a range and may be typed from `least` to `most`.
template <typename Change>
void sliderRow(WindowModel& model, const char* id, float now, const SliderRange& range, const std::array<float, 2>& typed,
               const char* format, const Change& change) {
  const bool changed = fillSlider(id, now, range, format);
  whyLocked();
  applyChange(model, changed && std::isfinite(now),
              [&](FrameSettings& settings) { change(settings, std::clamp(now, typed[0], typed[1])); });
}

template <typename Change>
void sliderRow(WindowModel& model, const char* id, int now, const SliderRange& range, const std::array<int, 2>& typed,
               const Change& change) {
  const bool changed = fillSlider(id, now, range);
  whyLocked();
  applyChange(model, changed, [&](FrameSettings& settings) { change(settings, std::clamp(now, typed[0], typed[1])); });
}

// A number without a range that a slider could show.
template <typename Change>
void numberRow(WindowModel& model, const char* id, float now, float speed, const std::array<float, 2>& typed, const char* format,
               const Change& change) {
  ImGui::PushFont(windowFonts().mono);
  const bool changed = ImGui::DragFloat(id, &now, speed, typed[0], typed[1], format, ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopFont();
  whyLocked();
  applyChange(model, changed && std::isfinite(now),
              [&](FrameSettings& settings) { change(settings, std::clamp(now, typed[0], typed[1])); });
}

template <typename Change>
void numberRow(WindowModel& model, const char* id, int now, float speed, const std::array<int, 2>& typed, const char* format,
               const Change& change) {
  ImGui::PushFont(windowFonts().mono);
  const bool changed = ImGui::DragInt(id, &now, speed, typed[0], typed[1], format, ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopFont();
  whyLocked();
  applyChange(model, changed, [&](FrameSettings& settings) { change(settings, std::clamp(now, typed[0], typed[1])); });
}

template <typename Value>
struct Choice {
  const char* name;
  Value value;
};

template <typename Value, size_t kCount, typename Change>
void choiceRow(WindowModel& model, const char* id, Value now, const Choice<Value> (&choices)[kCount], const Change& change) {
  std::string shown;
  for (const auto& choice : choices)
    if (choice.value == now) shown = choice.name;
  const bool open = ImGui::BeginCombo(id, shown.c_str());
  whyLocked();
  if (!open) return;
  for (const auto& choice : choices)
    if (ImGui::Selectable(choice.name, choice.value == now) && choice.value != now) {
      const Value value = choice.value;
      model.changeSettings([&](FrameSettings& settings) { change(settings, value); });
    }
  ImGui::EndCombo();
}

}  // namespace gridscope
