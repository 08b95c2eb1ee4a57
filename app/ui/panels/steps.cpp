// The tab "Ray steps": the recorded ray as a row of steps, with the controls that go through it and one sentence on the selected step.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/base/text.h"
#include "app/model/held_ray.h"
#include "app/model/ray_stepping.h"
#include "app/ui/panels/panels.h"
#include "app/ui/panels/step_timeline.h"
#include "app/ui/widgets/step_parts.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

enum class Icon { first, back, play, pause, forward, last };

void drawIcon(ImDrawList* list, ImVec2 centre, Icon icon, ImU32 colour) {
  const float s = unit(5);
  const auto arrow = [&](float x, float direction) {
    list->AddTriangleFilled(ImVec2(x - direction * 0.6f * s, centre.y - 0.8f * s), ImVec2(x + direction * 0.7f * s, centre.y),
                            ImVec2(x - direction * 0.6f * s, centre.y + 0.8f * s), colour);
  };
  const auto bar = [&](float x) {
    list->AddRectFilled(ImVec2(x - unit(1), centre.y - 0.8f * s), ImVec2(x + unit(1), centre.y + 0.8f * s), colour);
  };
  switch (icon) {
    case Icon::first: bar(centre.x - s), arrow(centre.x + 0.2f * s, -1.0f); break;
    case Icon::back: arrow(centre.x - 0.2f * s, -1.0f), bar(centre.x + s); break;
    case Icon::play: arrow(centre.x, 1.3f); break;
    case Icon::pause: bar(centre.x - 0.45f * s), bar(centre.x + 0.45f * s); break;
    case Icon::forward: bar(centre.x - s), arrow(centre.x + 0.2f * s, 1.0f); break;
    case Icon::last: arrow(centre.x - 0.2f * s, 1.0f), bar(centre.x + s); break;
  }
}

// True when pressed. `tip` names what it does and its key.
bool iconButton(Icon icon, const char* tip, bool enabled, const char* whyNot) {
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float side = unit(24);
  ImGui::PushID(tip);
  if (!enabled) ImGui::BeginDisabled();
  const bool pressed = ImGui::Button("##icon", ImVec2(side, side));
  if (!enabled) ImGui::EndDisabled();
  ImGui::PopID();
  whyTooltip(enabled ? tip : whyNot);
  drawIcon(ImGui::GetWindowDrawList(), ImVec2(place.x + 0.5f * side, place.y + 0.5f * side), icon,
           packed(uiColour(enabled ? UiColour::text : UiColour::disabled)));
  ImGui::SameLine(0.0f, unit(4));
  return pressed && enabled;
}

void drawTransport(WindowModel& model, uint32_t step, uint32_t count) {
  const bool before = step > 0, after = step + 1 < count;
  if (iconButton(Icon::first, "First step   Home", before, "This is the first step")) stepFirst(model);
  if (iconButton(Icon::back, "Step back   Left", before, "This is the first step")) stepBack(model);
  if (iconButton(model.stepsPlaying ? Icon::pause : Icon::play, "Play the steps   P", count > 1, "The ray has one step")) togglePlay(model);
  if (iconButton(Icon::forward, "Step forward   Right", after, "This is the last step")) stepForward(model);
  if (iconButton(Icon::last, "Last step   End", after, "This is the last step")) stepLast(model);
  ImGui::SameLine(0.0f, unit(10));
  ImGui::AlignTextToFramePadding();
  textMono(printed("%2u / %u", step, count - 1));
  whyTooltip("The selected step, counted from 0, and the last one");
  ImGui::SameLine(0.0f, unit(14));
}

void drawSpeed(WindowModel& model) {
  ImGui::AlignTextToFramePadding();
  textDim("Speed");
  ImGui::SameLine(0.0f, unit(6));
  ImGui::SetNextItemWidth(unit(56));
  ImGui::PushFont(windowFonts().mono);
  ImGui::SliderFloat("##speed", &model.stepsPerSecond, 1.0f, 60.0f, "%.0f / s",
                     ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopFont();
  whyTooltip("Steps a second while playing");
  ImGui::SameLine(0.0f, unit(14));
}

struct SearchButton {
  const char* label;
  const char* key;
  StepSearch search;
};
constexpr std::array<SearchButton, 5> kSearchButtons{{{"non-empty", "E", StepSearch::nonEmpty},
                                                      {"tested", "T", StepSearch::tested},
                                                      {"saturated", "S", StepSearch::saturated},
                                                      {"revisit", "V", StepSearch::revisit},
                                                      {"voxel hit", "X", StepSearch::voxelHit}}};

void drawSearches(WindowModel& model, const RayRecord& record, uint32_t step) {
  ImGui::AlignTextToFramePadding();
  textDim("Next");
  for (const SearchButton& button : kSearchButtons) {
    ImGui::SameLine(0.0f, unit(6));
    const std::optional<uint32_t> found = nextStep(record, step, button.search);
    if (keyButton(button.label, button.key, found.has_value(), noSuchStep(button.search))) selectStepAt(model, *found);
  }
}

// Room, pixels at UI scale 1, from which the light's words stand beside it, with the neighbouring rays behind.
constexpr float kWideLight = 380.0f;

constexpr float kNeighbours = 170.0f;  // room that the two buttons take, pixels at UI scale 1

void drawNeighbours(WindowModel& model) {
  if (ImGui::GetContentRegionAvail().x < unit(kNeighbours)) return ImGui::NewLine();  // the keys and the menu remain
  if (keyButton("Previous", "[")) nextRay(model, -1);
  whyTooltip(("The ray before in the order of " + model.rayOrder.name).c_str());
  ImGui::SameLine(0.0f, unit(4));
  if (keyButton("Next ray", "]")) nextRay(model, 1);
  whyTooltip(("The ray behind in the order of " + model.rayOrder.name).c_str());
}

// The light, and the neighbouring rays, at the right where there is room.
void drawRayLine(WindowModel& model, const RecordedRay& ray) {
  ImGui::SameLine(0.0f, unit(12));
  const bool wide = ImGui::GetContentRegionAvail().x > unit(kWideLight);
  if (rayIsHeld(model)) {
    ImGui::AlignTextToFramePadding();
    textDim(wide ? "Held while the camera moves" : "held");
    whyTooltip("The camera has moved on; the ray stays as it was recorded. A click on a pixel takes a ray of the present camera");
    ImGui::SameLine(0.0f, unit(12));
    return drawNeighbours(model);
  }
  const char* said =
      ray.equalsFrame ? (wide ? "Record equals the frame's hit" : "equal") : (wide ? "Record differs from the frame's hit" : "differs");
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const ImU32 colour = packed(meaningColour(ray.equalsFrame ? kColourTriangleHit : kColourHole));
  ImGui::GetWindowDrawList()->AddCircleFilled(ImVec2(place.x + unit(4), place.y + unit(12)), unit(4), colour, 12);
  ImGui::Dummy(ImVec2(unit(8), unit(24)));
  ImGui::SameLine(0.0f, unit(6));
  ImGui::AlignTextToFramePadding();
  textDim(said);
  whyTooltip((std::string(ray.equalsFrame ? "Record equals the frame's hit" : "Record differs from the frame's hit") +
              "\nThe recording trace ended with: " + hitWords(ray.record.hit) + "\nThe frame's trace ended with: " + hitWords(ray.frameHit))
                 .c_str());

  ImGui::SameLine(0.0f, unit(12));
  drawNeighbours(model);
}

void drawNothing(const WindowModel& model) {
  ImGui::SetCursorPosX(unit(10));
  if (!model.frame) return emptyState("No frame yet: its rays can be stepped as soon as the first one is done.");
  if (!model.selected().pixel) return emptyState("No ray selected. Click a pixel, or press N for the next hole.");
  const std::shared_ptr<const RecordedRay> ray = shownRay(model);
  if (!ray) return emptyState("Recording the ray...");
  if (ray->ray.valid == 0) return emptyState("This pixel sees no surface, so it has no ray. Click one that does.");
  emptyState("The ray never meets the grid: it has no steps.");
}

}  // namespace

void drawRaySteps(WindowModel& model) {
  const ShownStep* shown = shownStepFacts(model);
  if (!shown) return drawNothing(model);
  const std::shared_ptr<const RecordedRay> ray = shown->ray;
  const uint32_t step = shown->facts.index;

  ImGui::Dummy(ImVec2(0.0f, unit(2)));
  ImGui::Indent(unit(8));
  drawTransport(model, step, static_cast<uint32_t>(ray->record.steps.size()));
  drawSpeed(model);
  drawSearches(model, ray->record, step);
  drawRayLine(model, *ray);
  ImGui::Unindent(unit(8));

  const float sentence = sentenceBoxHeight(shown->sentence, ImGui::GetContentRegionAvail().x);
  const float height = ImGui::GetContentRegionAvail().y - sentence - ImGui::GetStyle().ItemSpacing.y;
  drawStepTimeline(model, *ray, step, height);
  shown = shownStepFacts(model);
  if (shown) drawSentenceBox(model, shown->sentence, stepLook(shown->facts.kind).colour, "explanation");
}

}  // namespace gridscope
