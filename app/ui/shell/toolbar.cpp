// The tool bar: workspaces, time, the jumps, capture, and the search box; and the status line at the window's foot.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>
#include <vector>

#include "app/base/text.h"
#include "app/frame/search.h"
#include "app/frame/table_rows.h"
#include "app/model/flow.h"
#include "app/ui/shell/layout.h"
#include "app/ui/viewport/stale.h"
#include "app/ui/widgets/action_button.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

void drawWorkspaces(WindowModel& model) {
  static constexpr const char* kNames[] = {"Grid", "Ray", "Verdict", "Tune"};
  for (int i = 0; i < 4; ++i) {
    const bool chosen = int(model.workspace) == i;
    ImGui::PushStyleColor(ImGuiCol_Button, uiColour(chosen ? UiColour::selectedRow : UiColour::panel));
    if (ImGui::Button(kNames[i], {unit(66), unit(24)})) showIn(model, Workspace(i));
    actionTooltip(model, action(kNames[i]));
    ImGui::PopStyleColor();
    ImGui::SameLine(0.0f, unit(2));
  }
}

enum class Glyph { first, back, play, pause, forward };

bool glyphButton(const char* id, Glyph glyph, bool enabled) {
  const float side = unit(24);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::BeginDisabled(!enabled);
  const bool clicked = ImGui::Button(id, {side, side});
  ImGui::EndDisabled();
  const ImVec2 middle{low.x + 0.5f * side, low.y + 0.5f * side};
  const float a = unit(4);
  const ImU32 colour = packed(uiColour(enabled ? UiColour::text : UiColour::disabled));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto triangle = [&](float x, float direction) {
    list.AddTriangleFilled({x - direction * a, middle.y - a}, {x - direction * a, middle.y + a}, {x + direction * a, middle.y}, colour);
  };
  const auto bar = [&](float x) { list.AddRectFilled({x - unit(1), middle.y - a}, {x + unit(1), middle.y + a}, colour); };
  switch (glyph) {
    case Glyph::first: bar(middle.x - a), triangle(middle.x + unit(1), -1.0f); break;
    case Glyph::back: triangle(middle.x - unit(1), -1.0f), bar(middle.x + a + unit(1)); break;
    case Glyph::play: triangle(middle.x, 1.0f); break;
    case Glyph::pause: bar(middle.x - unit(3)), bar(middle.x + unit(3)); break;
    case Glyph::forward: bar(middle.x - a - unit(1)), triangle(middle.x + unit(1), 1.0f); break;
  }
  return clicked && enabled;
}

// The time of the animations, or the frame of a captured sequence.
void drawScrub(WindowModel& model) {
  const SceneFacts* facts = model.frame ? model.frame->scene.get() : nullptr;
  ImGui::SetNextItemWidth(unit(140));
  ImGui::PushFont(windowFonts().mono);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(unit(6), 0.5f * (unit(24) - windowFonts().mono->FontSize)));
  if (facts && facts->captureFrames > 0) {
    int frame = int(model.request.frame);
    ImGui::BeginDisabled(facts->captureFrames == 1);
    if (ImGui::SliderInt("##scrub", &frame, 0, std::max(int(facts->captureFrames) - 1, 1),
                         printed("%%d / %u", facts->captureFrames).c_str(), ImGuiSliderFlags_AlwaysClamp))
      showCapturedFrame(model, uint32_t(frame));
    ImGui::EndDisabled();
    whyTooltip(facts->captureFrames == 1 ? "The capture holds one frame alone" : "Frame of the captured sequence");
  } else {
    float seconds = float(model.request.timeSeconds);
    const float most = facts && facts->duration > 0.0 ? float(facts->duration) : 10.0f;
    if (ImGui::SliderFloat("##scrub", &seconds, 0.0f, std::max(most, seconds), printed("%u: %%.3f s", model.request.frame).c_str()))
      setTime(model, double(seconds));
    whyTooltip("Frame, and its time in the animations");
  }
  ImGui::SameLine();
  if (facts && facts->captureFrames > 0) {  // a sequence's times are its own
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return;
  }
  float stepMs = float(1000.0 * model.timeStep);
  ImGui::SetNextItemWidth(unit(76));
  if (ImGui::DragFloat("##step", &stepMs, 0.1f, 0.01f, 10000.0f, "%.2f ms", ImGuiSliderFlags_AlwaysClamp))
    model.timeStep = double(stepMs) / 1000.0;
  ImGui::PopStyleVar();
  ImGui::PopFont();
  whyTooltip("Time step: what one frame moves the animations on");
}

void drawTime(WindowModel& model) {
  const bool enabled = whyNoTime(model).empty();
  const auto button = [&](const char* name, Glyph glyph) {
    const Action& one = action(name);
    if (glyphButton((std::string("##") + name).c_str(), glyph, enabled)) one.run(model);
    actionTooltip(model, one);
    ImGui::SameLine(0.0f, unit(3));
  };
  const ImVec2 place = ImGui::GetCursorPos();
  ImGui::SetCursorPosY(place.y + unit(3));
  textDim("Frame");
  ImGui::SameLine();
  ImGui::SetCursorPosY(place.y);
  button("First frame", Glyph::first);
  button("Previous frame", Glyph::back);
  button("Play", model.playing ? Glyph::pause : Glyph::play);
  button("Next frame", Glyph::forward);
  drawScrub(model);
}

// Selects what the search box names, and ends the search where it was found: it would filter the tables.
void goToTarget(WindowModel& model) {
  const std::optional<SearchTarget> target = findTarget(*model.frame, model.search);
  if (!target) return model.showMessage("Nothing here is called \"" + model.search + "\"");
  const GridParameters& grid = model.frame->parameters.grid;
  if (target->pixel) model.selection.selectPixel(*target->pixel);
  if (target->cell) model.selection.selectCell(*target->cell), model.focusWanted = cellBox(grid, *target->cell);
  if (target->reference)
    model.selection.selectTriangle(*target->reference), model.focusWanted = boundsOfTriangle(*model.frame, *target->reference);
  if (target->instance)
    model.selection.selectInstance(*target->instance), model.focusWanted = boundsOfInstance(*model.frame, *target->instance);
  model.search.clear();
}

void drawSearch(WindowModel& model, float right) {
  const float width = std::min(unit(370), right - ImGui::GetCursorScreenPos().x - unit(8));
  if (width < unit(80)) return;
  ImGui::SetCursorScreenPos({right - width, ImGui::GetWindowPos().y + unit(10)});
  ImGui::SetNextItemWidth(width);
  if (model.searchWanted) ImGui::SetKeyboardFocusHere();
  model.searchWanted = false;
  const bool entered = ImGui::InputTextWithHint("##search", "Pixel, cell, triangle, instance, mesh...   Ctrl+F", &model.search,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  whyTooltip(
      "Filters the tables as it is typed: words, \"cell 72,4,47\", \"refused>5\". Enter goes to the pixel, cell, triangle or instance");
  if (entered && model.frame) goToTarget(model);
}

void divider() {
  ImGui::SameLine(0.0f, unit(10));
  const ImVec2 place = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine(place, {place.x, place.y + unit(24)}, packed(uiColour(UiColour::line)));
  ImGui::Dummy({unit(1), unit(24)});
  ImGui::SameLine(0.0f, unit(10));
}

// A figure of the status line. In a narrow window those of the highest rank go first.
struct StatusFigure {
  const char* words;
  std::string number;
  int rank = 0;
  bool saturated = false;  // a hatched square before it
  bool ofGrid = false;     // dim while the grid is made again
};

float widthOf(const StatusFigure& figure) {
  ImFont* mono = windowFonts().mono;
  return ImGui::CalcTextSize(figure.words).x + unit(5 + 12) + mono->CalcTextSizeA(mono->FontSize, FLT_MAX, 0.0f, figure.number.c_str()).x +
         (figure.saturated ? unit(16) : 0.0f);
}

void drawFigure(const StatusFigure& figure, bool gridIsStale) {
  const StaleDim dim(figure.ofGrid && gridIsStale);
  if (figure.saturated) swatch(kColourSaturated, true);
  textDim(figure.words);
  ImGui::SameLine(0.0f, unit(5));
  textMono(figure.number);
  ImGui::SameLine(0.0f, unit(12));
}

std::vector<StatusFigure> statusFigures(const WindowModel& model) {
  const FrameSnapshot& frame = *model.frame;
  const GridStatistics& totals = frame.totals.statistics;
  const auto time = [](double ms) { return printed(ms < 10.0 ? "%.1f ms" : "%.0f ms", ms); };
  return {{"ui", printed("%.1f ms", model.interfaceMs), 3},
          {"build", time(frame.times.build), 2},
          {"update", time(frame.times.clear + frame.times.add), 2},
          {"gather", time(frame.times.gather), 5},
          {"bounce", time(frame.times.bounce), 5},
          {"trace", time(frame.times.trace), 1},
          {"views", time(frame.times.views), 5},
          {"stored", grouped(frame.totals.stored()), 3, false, true},
          {"refused", grouped(frame.totals.refused()) + " (" + percentOf(frame.totals.refused(), std::max<uint64_t>(frame.tried, 1)) + ")",
           0, false, true},
          {"saturated", grouped(totals.saturated), 0, true, true},
          {"of", grouped(totals.occupied) + " cells", 4, false, true}};
}

}  // namespace

void drawToolbar(WindowModel& model) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - unit(8);
  drawWorkspaces(model);
  divider();
  drawTime(model);
  divider();
  // What does not fit is in the menus.
  for (const char* name : {"Next hole", "Next voxel wrong", "Fullest cell", "Capture frame", "Report..."}) {
    if (ImGui::GetCursorScreenPos().x + unit(160) > right - unit(170)) break;
    actionButton(model, name);
    ImGui::SameLine(0.0f, unit(6));
  }
  drawSearch(model, right);
}

void drawStatusLine(WindowModel& model) {
  ImGui::PushFont(windowFonts().sansSmall);
  if (!model.frame) {
    textDim("Starting the device...");
    ImGui::PopFont();
    return;
  }
  const FrameSnapshot& frame = *model.frame;
  std::string right;
  if (frame.request.settings) {
    right = printed("%u x %u", frame.request.settings->width, frame.request.settings->height);
    if (frame.stale || frame.traced < 1.0f) right += printed("  traced %.0f %%", 100.0 * double(frame.traced));
  }
  ImFont* mono = windowFonts().mono;
  const float rightWidth = mono->CalcTextSizeA(mono->FontSize, FLT_MAX, 0.0f, right.c_str()).x + unit(10);

  std::vector<StatusFigure> figures = statusFigures(model);
  const float free = ImGui::GetWindowWidth() - rightWidth - unit(24 + 14) - ImGui::CalcTextSize(frame.device.c_str()).x;
  const auto sum = [&] {
    return std::accumulate(figures.begin(), figures.end(), 0.0f,
                           [](float width, const StatusFigure& figure) { return width + widthOf(figure); });
  };
  for (int rank = 5; rank > 0 && sum() > free; --rank)
    std::erase_if(figures, [rank](const StatusFigure& figure) { return figure.rank == rank; });

  swatch(kColourTriangleHit);
  textDim(frame.device);
  whyTooltip("The device that runs build, update and trace; --device chooses another when the program starts");
  ImGui::SameLine(0.0f, unit(14));
  for (const StatusFigure& figure : figures) drawFigure(figure, model.stale.grid);
  const float x = ImGui::GetWindowWidth() - rightWidth;
  if (x > ImGui::GetCursorPosX()) ImGui::SetCursorPosX(x), textMono(right);
  ImGui::PopFont();
}

}  // namespace gridscope
