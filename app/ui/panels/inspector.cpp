// The right column: tabs Inspector, Pixel and Bookmarks, and back and forward through what was selected.
#include "app/ui/panels/inspector.h"

#include <algorithm>

#include "app/base/text.h"
#include "app/frame/table_rows.h"
#include "app/model/held_ray.h"
#include "app/ui/panels/panels.h"
#include "app/ui/viewport/stale.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

enum class InspectorTab { inspector, pixel, bookmarks };

constexpr float kFactColumn = 104.0f;  // where values stand, pixels at UI scale 1

// A new selection opens the tab that shows it.
std::optional<InspectorTab> wantedTab(const WindowModel& model) {
  static Selection before;
  const Selection& now = model.selected();
  if (now == before) return std::nullopt;
  before = now;
  if (now.last == Selected::nothing) return std::nullopt;
  const bool stepping = model.workspace == Workspace::ray;
  return now.last == Selected::pixel && !stepping ? InspectorTab::pixel : InspectorTab::inspector;
}

bool arrowButton(const char* id, float direction, bool enabled, const char* tip) {
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float side = unit(22);
  if (!enabled) ImGui::BeginDisabled();
  const bool pressed = ImGui::Button(id, ImVec2(side, side));
  if (!enabled) ImGui::EndDisabled();
  whyTooltip(tip);
  const ImVec2 centre(place.x + 0.5f * side, place.y + 0.5f * side);
  const float s = unit(4);
  ImGui::GetWindowDrawList()->AddTriangleFilled(
      ImVec2(centre.x - direction * 0.6f * s, centre.y - s), ImVec2(centre.x + direction * s, centre.y),
      ImVec2(centre.x - direction * 0.6f * s, centre.y + s), packed(uiColour(enabled ? UiColour::text : UiColour::disabled)));
  return pressed && enabled;
}

void drawHistory(WindowModel& model) {
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - unit(48));
  if (arrowButton("##back", -1.0f, model.selection.canGoBack(), "Back to what was selected before")) model.selection.goBack();
  ImGui::SameLine(0.0f, unit(4));
  if (arrowButton("##forward", 1.0f, model.selection.canGoForward(), "Forward again")) model.selection.goForward();
}

void drawSelected(WindowModel& model) {
  const FrameSnapshot* frame = model.frame.get();
  if (!frame || !frame->scene) return emptyState("No frame yet.");
  const Selection selected = model.selected();
  const bool ofGrid = selected.last == Selected::cell || selected.last == Selected::triangle || selected.last == Selected::instance;
  const StaleDim dim(ofGrid ? model.stale.grid : model.stale.steps);
  switch (selected.last) {
    case Selected::cell:
      if (frame->grid && selected.cell && gridContains(frame->grid->parameters, *selected.cell))
        return drawCellInspector(model, *selected.cell);
      return emptyState("This cell lies outside the present grid.");
    case Selected::triangle:
      if (selected.reference && worldTriangle(*frame, *selected.reference)) return drawTriangleInspector(model, *selected.reference);
      return emptyState("This triangle is not in the present scene.");
    case Selected::instance:
      if (selected.instance) return drawInstanceInspector(model, *selected.instance);
      break;
    default: break;
  }
  if (const ShownStep* shown = shownStepFacts(model)) return drawStepInspector(model, *shown);
  if (!selected.pixel) return emptyState("Nothing selected. Click a pixel to see its ray, or a row of any table; N goes to the next hole.");
  if (!shownRay(model)) return emptyState("Recording the ray...");
  emptyState("This pixel has no ray, or its ray never meets the grid: there are no steps.");
}

bool beginTab(const char* title, bool wanted) { return ImGui::BeginTabItem(title, nullptr, wanted ? ImGuiTabItemFlags_SetSelected : 0); }

}  // namespace

void drawInspector(WindowModel& model) {
  const std::optional<InspectorTab> wanted = wantedTab(model);
  ImGui::Dummy(ImVec2(0.0f, unit(1)));
  const float line = ImGui::GetCursorPosY();
  ImGui::Dummy(ImVec2(1.0f, unit(22)));
  drawHistory(model);
  ImGui::SetCursorPosY(line);
  if (!ImGui::BeginTabBar("right tabs", ImGuiTabBarFlags_NoTooltip)) return;
  const auto tab = [&](const char* title, InspectorTab which, auto draw) {
    if (!beginTab(title, wanted == which)) return;
    draw();
    ImGui::EndTabItem();
  };
  tab("Inspector", InspectorTab::inspector, [&] { drawSelected(model); });
  tab("Pixel", InspectorTab::pixel, [&] { drawPixelTab(model); });
  tab("Bookmarks", InspectorTab::bookmarks, [&] { drawBookmarksTab(model); });
  ImGui::EndTabBar();
}

// --- What the bodies are made of --------------------------------------------------------------------------------------------------

void drawInspectorTitle(WindowModel& model, const InspectorTitle& title) {
  ImGui::Dummy(ImVec2(0.0f, unit(2)));
  ImGui::PushFont(windowFonts().sansLarge);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(title.name.c_str());
  ImGui::PopFont();
  if (!title.word.empty()) {
    ImGui::SameLine(0.0f, unit(8));
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + unit(3));
    title.glyph ? stepGlyphInline(*title.glyph) : swatch(title.colour, title.hatched);
    ImGui::PushStyleColor(ImGuiCol_Text, meaningColour(title.colour));
    ImGui::PushFont(windowFonts().sansBold);
    ImGui::TextUnformatted(title.word.c_str());
    ImGui::PopFont();
    ImGui::PopStyleColor();
  }

  ImGui::PushFont(windowFonts().sansSmall);
  const float width = ImGui::CalcTextSize("Focus").x + ImGui::CalcTextSize("Copy").x + unit(36);
  ImGui::SameLine();
  ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowContentRegionMax().x - width));
  if (!title.focus) ImGui::BeginDisabled();
  if (ImGui::Button("Focus") && title.focus) model.focusWanted = *title.focus;
  if (!title.focus) ImGui::EndDisabled();
  ImGui::PopFont();
  whyTooltip(title.focus ? "Looks there   F" : "There is no place to look at");
  ImGui::PushFont(windowFonts().sansSmall);
  ImGui::SameLine(0.0f, unit(4));
  if (ImGui::Button("Copy"))
    ImGui::SetClipboardText((title.name + (title.word.empty() ? "" : ", " + title.word) + "\n" + title.text).c_str());
  ImGui::PopFont();
  whyTooltip("Copies what is shown as text");
}

void factLabel(const char* label, bool changed) {
  if (changed) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float middle = place.y + 0.5f * ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddTriangleFilled(ImVec2(place.x - unit(7), middle - unit(3)), ImVec2(place.x - unit(7), middle + unit(3)),
                                                  ImVec2(place.x - unit(2), middle), packed(meaningColour(kColourVoxelHit)));
  }
  textDim(label);
  if (changed) whyTooltip("Changed by this step");
  ImGui::SameLine(unit(kFactColumn) + ImGui::GetStyle().WindowPadding.x);
}

void factValue(const char* label, const std::string& value, bool changed) {
  factLabel(label, changed);
  textMono(value);
}

std::string pointText(const vec3& point) { return printed("%.3f, %.3f, %.3f", point.x, point.y, point.z); }

std::string materialName(const SceneFacts& scene, uint32_t reference) {
  const uint32_t instance = referenceInstance(reference);
  if (instance >= scene.numbered.instances.size()) return "-";
  const uint32_t material = scene.numbered.instances[instance].material;
  return material < scene.names.materials.size() && !scene.names.materials[material].empty() ? scene.names.materials[material]
                                                                                             : printed("material %u", material);
}

}  // namespace gridscope
