// The menu bar: menus made from the table of actions, and the lights at its right end.
#include <algorithm>
#include <cstring>

#include "app/base/text.h"
#include "app/model/flow.h"
#include "app/ui/shell/layout.h"
#include "app/ui/widgets/action_button.h"
#include "app/ui/widgets/widgets.h"
#include "core/scene/built_in_scenes.h"
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
    if (ImGui::MenuItem(viewLabel(name).c_str(), nullptr, model.panes[size_t(model.activePane)].view == name)) showView(model, name);
    whyTooltip(std::string(view.about).c_str());
  }
  ImGui::EndMenu();
}

// A light and what it says. Where there is no room for words the light alone stays: a circle, or a triangle where something is wrong.
struct Light {
  uint32_t colour;
  bool fault;
  const char* words;
  std::string about;  // when the mouse rests on it
};

constexpr float kLightWidth = 12, kLightGap = 14;  // pixels at UI scale 1

Light invariantsLight(const WindowModel& model) {
  if (!model.frame || !model.frame->brokenInvariants)
    return {kColourEmpty, false, "Invariants not checked yet", "They are checked once the grid is built"};
  const std::vector<std::string>& broken = *model.frame->brokenInvariants;
  if (broken.empty())
    return {kColourTriangleHit, false, "Invariants hold", "The grid's slots and counts agree with each other and with the scene"};
  return {kColourHole, true, "An invariant is broken", joined(broken, "\n")};
}

Light shadersLight(const WindowModel& model) {
  if (model.shaderFault.empty()) return {kColourTriangleHit, false, "Shaders current", "What runs is what was compiled last"};
  return {kColourHole, true, "Shader fault, see Log", "The last good shaders go on\n" + model.shaderFault};
}

float widthOf(const Light& light, bool words) {
  return unit(kLightWidth + kLightGap) + (words ? ImGui::CalcTextSize(light.words).x : 0.0f);
}

void drawLight(const Light& light, bool words) {
  const float radius = unit(4);
  const ImVec2 low = ImGui::GetCursorScreenPos(), middle{low.x + radius, low.y + 0.5f * ImGui::GetFrameHeight()};
  const ImU32 colour = packed(meaningColour(light.colour));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (light.fault)
    list.AddTriangleFilled({middle.x - 1.3f * radius, middle.y + radius}, {middle.x + 1.3f * radius, middle.y + radius},
                           {middle.x, middle.y - 1.2f * radius}, colour);
  else
    list.AddCircleFilled(middle, radius, colour);
  if (words)
    list.AddText({low.x + unit(kLightWidth), low.y + ImGui::GetStyle().FramePadding.y}, packed(uiColour(UiColour::text)), light.words);
  ImGui::Dummy({widthOf(light, words) - unit(kLightGap), ImGui::GetFrameHeight()});
  whyTooltip((std::string(light.words) + "\n" + light.about).c_str());
  ImGui::SameLine(0.0f, unit(kLightGap));
}

// "F5 reload": the key of an action, which is a button too.
struct KeyWord {
  const char* action;
  const char* word;
  float width;  // pixels at UI scale 1
};
constexpr KeyWord kKeyWords[] = {{"Reload shaders", "reload", 72}, {"All keys", "keys", 52}};

void drawKeyWord(WindowModel& model, const KeyWord& keyWord) {
  const Action& one = action(keyWord.action);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float y = low.y + ImGui::GetStyle().FramePadding.y;
  if (ImGui::InvisibleButton(one.name, {unit(keyWord.width), ImGui::GetFrameHeight()})) one.run(model);
  const UiColour ink = ImGui::IsItemHovered() ? UiColour::text : UiColour::dim;
  actionTooltip(model, one);
  const float cap = drawKeyCap({low.x, y}, one.key);
  ImGui::GetWindowDrawList()->AddText({low.x + cap + unit(5), y}, packed(uiColour(ink)), keyWord.word);
  ImGui::SameLine(0.0f, 0.0f);
}

// What there is no room for goes: first the keys, then the words. The lights stay.
void drawLights(WindowModel& model) {
  const Light lights[] = {invariantsLight(model), shadersLight(model)};
  const float free = ImGui::GetWindowWidth() - ImGui::GetCursorPosX() - unit(8);
  const float words = widthOf(lights[0], true) + widthOf(lights[1], true), dots = widthOf(lights[0], false) + widthOf(lights[1], false);
  const float keys = unit(kKeyWords[0].width + kKeyWords[1].width);
  const bool withWords = words <= free, withKeys = words + keys <= free;
  const float width = withKeys ? words + keys : withWords ? words : dots;
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - std::min(width, free) - unit(8));
  for (const Light& light : lights) drawLight(light, withWords);
  if (withKeys)
    for (const KeyWord& keyWord : kKeyWords) drawKeyWord(model, keyWord);
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
