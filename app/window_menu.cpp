// The menu bar: menus made from the table of actions, and the lights at its right end.
#include <cstring>

#include "app/model_flow.h"
#include "app/window_actions.h"
#include "app/window_panels.h"
#include "app/window_widgets.h"
#include "core/built_in_scenes.h"
#include "views/view.h"

namespace gridscope {

namespace {

constexpr const char* kMenus[] = {"File", "Edit", "View", "Frame", "Ray", "Cells", "Tools", "Window", "Help"};

void drawScenes(WindowModel& model) {
  if (ImGui::BeginMenu("Built-in scenes")) {
    for (const BuiltInScene& scene : builtInScenes()) {
      if (ImGui::MenuItem(std::string(scene.name).c_str())) openSource(model, std::string(scene.name));
      whyTooltip(std::string(scene.lesson).c_str());
    }
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Recent", !model.recentFiles.empty())) {
    for (const std::string& file : std::vector<std::string>(model.recentFiles))
      if (ImGui::MenuItem(file.c_str())) openSource(model, file);
    ImGui::EndMenu();
  }
}

void drawViews(WindowModel& model) {
  if (!ImGui::BeginMenu("Show")) return;
  for (const View& view : allViews()) {
    const std::string name(view.name);
    if (ImGui::MenuItem(name.c_str(), nullptr, model.panes[size_t(model.activePane)].view == name)) showView(model, name);
    whyTooltip(std::string(view.about).c_str());
  }
  ImGui::EndMenu();
}

void light(uint32_t colour, const char* words) {
  const float height = ImGui::GetTextLineHeight();
  const ImVec2 place = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddCircleFilled({place.x + unit(4), place.y + 0.5f * height + ImGui::GetStyle().FramePadding.y}, unit(4),
                                              packed(meaningColour(colour)));
  ImGui::Dummy({unit(10), height});
  ImGui::SameLine(0.0f, unit(4));
  ImGui::TextUnformatted(words);
  ImGui::SameLine(0.0f, unit(16));
}

void drawLights(WindowModel& model) {
  const bool tested = model.frame && model.frame->brokenInvariants;
  const bool holds = tested && model.frame->brokenInvariants->empty();
  const char* invariants = !tested ? "Invariants not checked yet" : holds ? "Invariants hold" : "An invariant is broken";
  const char* shaders = model.shaderFault.empty() ? "Shaders current" : "Shader fault, see Log";
  const float width = ImGui::CalcTextSize(invariants).x + ImGui::CalcTextSize(shaders).x + unit(80);
  if (ImGui::GetCursorPosX() + width > ImGui::GetWindowWidth()) return;
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - width);
  light(!tested ? kColourEmpty : holds ? kColourTriangleHit : kColourHole, invariants);
  if (tested && !holds) whyTooltip(model.frame->brokenInvariants->front().c_str());
  light(model.shaderFault.empty() ? kColourTriangleHit : kColourHole, shaders);
}

}  // namespace

void drawMenuBar(WindowModel& model) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(unit(8), unit(6)));
  if (ImGui::BeginMenuBar()) {
    for (const char* menu : kMenus) {
      if (!ImGui::BeginMenu(menu)) continue;
      if (!std::strcmp(menu, "View")) drawViews(model), ImGui::Separator();
      for (const Action& one : allActions()) {
        if (std::strcmp(one.menu, menu) != 0) continue;
        actionEntry(model, one);
        if (!std::strcmp(one.name, "Open")) drawScenes(model);
      }
      ImGui::EndMenu();
    }
    drawLights(model);
    ImGui::EndMenuBar();
  }
  ImGui::PopStyleVar();
}

}  // namespace gridscope
