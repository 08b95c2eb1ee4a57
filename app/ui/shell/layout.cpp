// See layout.h.
#include "app/ui/shell/layout.h"

#include <imgui_internal.h>

#include <algorithm>

#include "app/ui/panels/panels.h"
#include "app/ui/viewport/viewport.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

constexpr float kMenuHeight = 28, kToolbarHeight = 40, kStatusHeight = 26, kSplitter = 4;  // pixels at UI scale 1
constexpr float kLeastSide = 180, kLeastBottom = 80, kLeastCentreWidth = 320, kLeastCentreHeight = 160;

struct Region {
  ImVec2 low, high;
  ImVec2 size() const { return {std::max(high.x - low.x, 1.0f), std::max(high.y - low.y, 1.0f)}; }
};

struct Regions {
  Region menu, toolbar, left, leftSplitter, centre, bottomSplitter, bottom, rightSplitter, right, status;
};

// Sides give way when the window is small; the centre keeps its least size first.
Regions regionsOf(const Splits& splits, float width, float height) {
  const float splitter = unit(kSplitter), top = unit(kMenuHeight + kToolbarHeight),
              statusTop = std::max(height - unit(kStatusHeight), top + 1.0f);
  const float sides = std::max(width - unit(kLeastCentreWidth) - 2.0f * splitter, 2.0f);
  float left = unit(splits.left), right = unit(splits.right);
  if (left + right > sides) {
    const float shrink = sides / (left + right);
    left = std::floor(left * shrink), right = std::floor(right * shrink);
  }
  const float bottomMost = std::max(statusTop - top - splitter - unit(kLeastCentreHeight), 1.0f);
  const float bottomTop = statusTop - std::min(unit(splits.bottom), bottomMost);
  const float centreLeft = left + splitter, centreRight = width - right - splitter;
  return {.menu = {{0, 0}, {width, unit(kMenuHeight)}},
          .toolbar = {{0, unit(kMenuHeight)}, {width, top}},
          .left = {{0, top}, {left, statusTop}},
          .leftSplitter = {{left, top}, {centreLeft, statusTop}},
          .centre = {{centreLeft, top}, {centreRight, bottomTop - splitter}},
          .bottomSplitter = {{centreLeft, bottomTop - splitter}, {centreRight, bottomTop}},
          .bottom = {{centreLeft, bottomTop}, {centreRight, statusTop}},
          .rightSplitter = {{centreRight, top}, {centreRight + splitter, statusTop}},
          .right = {{centreRight + splitter, top}, {width, statusTop}},
          .status = {{0, statusTop}, {width, height}}};
}

using DrawPanel = void (*)(WindowModel&);

void drawRegion(const char* name, const Region& region, UiColour colour, ImVec2 padding, ImGuiWindowFlags flags, WindowModel& model,
                DrawPanel draw) {
  ImGui::SetNextWindowPos(region.low);
  ImGui::SetNextWindowSize(region.size());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, uiColour(colour));
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus;
  const bool open = ImGui::Begin(name, nullptr, kFixed | flags);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  if (open) draw(model);
  ImGui::End();
}

// The viewport, or the tuner in its place.
void drawCentre(WindowModel& model) {
  if (model.workspace != Workspace::tune) return drawViewport(model);
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  model.hoveredPixel.reset();
  ImGui::SetCursorScreenPos({low.x + unit(10), low.y + unit(4)});
  if (ImGui::BeginChild("tuner", {size.x - unit(20), size.y - unit(8)})) drawTuner(model);
  ImGui::EndChild();
  drawNotices(model, low, {low.x + size.x, low.y + size.y});
}

// Dragging changes `size` by the mouse's way along the axis, times `sign`; a double click brings back `usual`.
void drawSplitter(const char* name, const Region& region, bool vertical, float& size, float sign, float usual) {
  ImGui::SetNextWindowPos(region.low);
  ImGui::SetNextWindowSize(region.size());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, uiColour(UiColour::window));
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus);
  ImGui::InvisibleButton("drag", region.size());
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddRectFilled(region.low, region.high, packed(uiColour(UiColour::accent)));
  }
  if (ImGui::IsItemActive()) size += sign * (vertical ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y) / unit(1);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) size = usual;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

// --- The keyboard's walk ----------------------------------------------------------------------------------------------------------

constexpr const char* kWalkedRegions[] = {"settings", "toolbar", "inspector", "bottom"};

// F6 goes from region to region; ImGui's own navigation does the rest. A click of the mouse ends it.
void walk(WindowModel& model) {
  ImGuiIO& io = ImGui::GetIO();
  if (model.walked != 0 && (ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1))) model.walked = 0;
  if (model.walkWanted) {
    model.walked = model.walked % int(std::size(kWalkedRegions)) + 1;
    ImGuiWindow* window = ImGui::FindWindowByName(kWalkedRegions[model.walked - 1]);
    if (window) ImGui::FocusWindow(window), ImGui::NavInitWindow(window, true);
    model.showMessage(std::string("Keys walk the controls of the ") +
                      (model.walked == 1   ? "left panel"
                       : model.walked == 2 ? "tool bar"
                       : model.walked == 3 ? "right panel"
                                           : "bottom") +
                      "; F6: on, Escape: back to the picture");
  }
  model.walkWanted = false;
  if (model.walked != 0)
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  else
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
}

// Where the walk stands: controls drawn by hand have no mark of ImGui's.
void drawWalk(const WindowModel& model) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const ImGuiWindow* window = context.NavWindow;
  if (model.walked == 0 || !window || context.NavId == 0 || window->NavLastIds[context.NavLayer] != context.NavId) return;
  const ImRect place = ImGui::WindowRectRelToAbs(const_cast<ImGuiWindow*>(window), window->NavRectRel[context.NavLayer]);
  ImDrawList* list = ImGui::GetForegroundDrawList();
  list->PushClipRect(window->InnerRect.Min, window->InnerRect.Max);
  list->AddRect({place.Min.x - unit(1), place.Min.y - unit(1)}, {place.Max.x + unit(1), place.Max.y + unit(1)},
                packed(uiColour(UiColour::accent)), unit(3), 0, unit(2));
  list->PopClipRect();
}

}  // namespace

void drawLayout(WindowModel& model, float width, float height) {
  Splits& splits = model.splits;
  const Regions regions = regionsOf(splits, width, height);
  walk(model);
  const ImVec2 none{0, 0}, sides{unit(10), 0};
  const ImGuiWindowFlags still = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  drawRegion("menu", regions.menu, UiColour::head, none, still | ImGuiWindowFlags_MenuBar, model, drawMenuBar);
  drawRegion("toolbar", regions.toolbar, UiColour::panel, {unit(8), unit(8)}, still, model, drawToolbar);
  drawRegion("settings", regions.left, UiColour::panel, sides, 0, model, drawSettingsPanel);
  drawRegion("viewport", regions.centre, UiColour::window, none, still, model, drawCentre);
  drawRegion("bottom", regions.bottom, UiColour::panel, none, still, model, drawBottomTabs);
  drawRegion("inspector", regions.right, UiColour::panel, sides, 0, model, drawInspector);
  drawRegion("status", regions.status, UiColour::head, {unit(10), unit(3)}, still, model, drawStatusLine);

  const Splits usual;
  drawSplitter("split left", regions.leftSplitter, true, splits.left, 1.0f, usual.left);
  drawSplitter("split right", regions.rightSplitter, true, splits.right, -1.0f, usual.right);
  drawSplitter("split bottom", regions.bottomSplitter, false, splits.bottom, -1.0f, usual.bottom);
  splits.left = std::clamp(splits.left, kLeastSide, 800.0f);
  splits.right = std::clamp(splits.right, kLeastSide, 1000.0f);
  splits.bottom = std::clamp(splits.bottom, kLeastBottom, 1200.0f);

  drawWalk(model);
  drawHelp(model);
  drawDialogs(model);
}

}  // namespace gridscope
