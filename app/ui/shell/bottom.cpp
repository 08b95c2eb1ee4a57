// The bottom region: its tabs, and the log.
#include <imgui_internal.h>

#include <algorithm>
#include <iterator>

#include "app/base/text.h"
#include "app/frame/table_exports.h"
#include "app/model/exports.h"
#include "app/model/ray_stepping.h"
#include "app/ui/panels/panels.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/shell/layout.h"
#include "app/ui/viewport/stale.h"
#include "app/ui/widgets/action_button.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

struct Tab {
  BottomTab tab;
  const char* name;
  void (*draw)(WindowModel&);
  bool StaleValues::*stale = nullptr;  // when what it shows is of a request before
};

constexpr Tab kTabs[] = {
    {BottomTab::steps, "Ray steps", drawRaySteps, &StaleValues::steps},
    {BottomTab::cells, "Cells", drawCellsTable, &StaleValues::grid},
    {BottomTab::instances, "Instances", drawInstancesTable, &StaleValues::grid},
    {BottomTab::triangles, "Triangles", drawTrianglesTable, &StaleValues::grid},
    {BottomTab::rays, "Rays", drawRaysTable, &StaleValues::rays},
    {BottomTab::causes, "Causes", drawCauses, &StaleValues::rays},
    {BottomTab::plots, "Plots", drawPlots},
    {BottomTab::tune, "Tune", drawTuner},
    {BottomTab::log, "Log", drawLog},
};

// Tabs with a bar of the accent colour over the chosen one.
void drawTabBar(WindowModel& model) {
  const float height = unit(28);
  const ImVec2 low = ImGui::GetWindowPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + ImGui::GetWindowWidth(), low.y + height}, packed(uiColour(UiColour::head)));
  // Of the steps, whose own line is full; the other tables have their export above them.
  const RecordedRay* ray = model.bottomTab == BottomTab::steps ? shownRecord(model) : nullptr;
  const float exportWidth = smallButtonWidth("Export CSV");
  // Where they do not all fit they stand closer, and move so that the chosen one is in sight.
  const float room = ImGui::GetWindowWidth() - unit(8) - (ray ? exportWidth + unit(8) : 0.0f);
  float wordsWidth = 0.0f, chosenEnd = 0.0f;
  for (const Tab& tab : kTabs) wordsWidth += ImGui::CalcTextSize(tab.name).x;
  const float padding = std::clamp((room - wordsWidth) / (2.0f * float(std::size(kTabs))), unit(5), unit(11));
  for (const Tab& tab : kTabs) {
    chosenEnd += ImGui::CalcTextSize(tab.name).x + 2.0f * padding;
    if (tab.tab == model.bottomTab) break;
  }
  float x = low.x + unit(4) - std::max(0.0f, chosenEnd - room);
  for (const Tab& tab : kTabs) {
    const bool chosen = tab.tab == model.bottomTab;
    const ImVec2 words = ImGui::CalcTextSize(tab.name);
    const float width = words.x + 2.0f * padding;
    ImGui::SetCursorScreenPos({x, low.y});
    if (ImGui::InvisibleButton(tab.name, {width, height})) model.bottomTab = tab.tab;
    actionTooltip(model, action((std::string(tab.name) + " tab").c_str()));
    if (chosen) {
      list.AddRectFilled({x, low.y}, {x + width, low.y + height}, packed(uiColour(UiColour::panel)));
      list.AddRectFilled({x, low.y}, {x + width, low.y + unit(2)}, packed(uiColour(UiColour::accent)));
    }
    const UiColour colour = chosen || ImGui::IsItemHovered() ? UiColour::text : UiColour::dim;
    list.AddText({x + padding, low.y + 0.5f * (height - words.y)}, packed(uiColour(colour)), tab.name);
    x += width;
  }
  if (ray && x + exportWidth + unit(8) < low.x + ImGui::GetWindowWidth()) {
    ImGui::SetCursorScreenPos({low.x + ImGui::GetWindowWidth() - exportWidth - unit(8), low.y + unit(4)});
    const bool has = !ray->record.steps.empty();
    if (smallButton("Export CSV", "csv", "Writes the steps of this ray as a CSV file, in the folder where the program was started", has,
                    "The ray has no steps")) {
      const uint32_t width = model.frame->request.settings->width;
      exportCsv(model, printed("steps_%u_%u", ray->pixel % width, ray->pixel / width), stepRows(*model.frame, *ray));
    }
  }
  ImGui::SetCursorScreenPos({low.x, low.y + height});
}

}  // namespace

void drawBottomTabs(WindowModel& model) {
  drawTabBar(model);
  model.bottomTabWanted = false;
  for (const Tab& tab : kTabs) {
    if (tab.tab != model.bottomTab) continue;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(unit(10), unit(6)));
    if (ImGui::BeginChild(tab.name, {0, 0}, false, ImGuiWindowFlags_AlwaysUseWindowPadding)) {
      if (tab.tab == BottomTab::tune && model.workspace == Workspace::tune)
        emptyState("The tuner fills the viewport in this workspace.");
      else {
        const StaleDim dim(tab.stale && model.stale.*tab.stale);
        tab.draw(model);
      }
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
  }
  model.rowStep = 0;
}

void drawLog(WindowModel& model) {
  if (model.log.empty()) return emptyState("Nothing has happened yet.");
  ImGui::PushFont(windowFonts().mono);
  ImGuiListClipper clipper;
  clipper.Begin(int(model.log.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const LogLine& line = model.log[size_t(i)];
      textDim(printed("%8.2f s ", line.seconds));
      ImGui::SameLine();
      const ImVec4 colour = line.kind == LogLine::Kind::error     ? meaningColour(kColourHole)
                            : line.kind == LogLine::Kind::warning ? meaningColour(kColourVoxelHit)
                                                                  : uiColour(UiColour::text);
      ImGui::PushStyleColor(ImGuiCol_Text, colour);
      ImGui::TextUnformatted(line.text.c_str());
      ImGui::PopStyleColor();
    }
  // Follows the end unless the person looks at something older.
  if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - unit(20)) ImGui::SetScrollHereY(1.0f);
  ImGui::PopFont();
}

}  // namespace gridscope
