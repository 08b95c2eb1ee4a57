// The tool bar: workspaces, time, the jumps, capture, and the search box; and the status line at the window's foot.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/model_flow.h"
#include "app/search.h"
#include "app/table_rows.h"
#include "app/text.h"
#include "app/window_actions.h"
#include "app/window_panels.h"
#include "app/window_stale.h"
#include "app/window_widgets.h"

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
  ImGui::SameLine(0.0f, unit(3));
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
    if (ImGui::SliderInt("##scrub", &frame, 0, int(facts->captureFrames) - 1, "%d", ImGuiSliderFlags_AlwaysClamp)) model.request.frame = uint32_t(frame);
  } else {
    float seconds = float(model.request.timeSeconds);
    const float most = facts && facts->duration > 0.0 ? float(facts->duration) : 10.0f;
    if (ImGui::SliderFloat("##scrub", &seconds, 0.0f, std::max(most, seconds), printed("%u: %%.3f s", model.request.frame).c_str())) setTime(model, double(seconds));
  }
  ImGui::SameLine();
  float stepMs = float(1000.0 * model.timeStep);
  ImGui::SetNextItemWidth(unit(76));
  if (ImGui::DragFloat("##step", &stepMs, 0.1f, 0.01f, 10000.0f, "%.2f ms", ImGuiSliderFlags_AlwaysClamp)) model.timeStep = double(stepMs) / 1000.0;
  ImGui::PopStyleVar();
  ImGui::PopFont();
  whyTooltip("Time step: what one frame moves the animations on");
}

void drawTime(WindowModel& model) {
  const bool enabled = model.frame && model.frame->scene;
  const auto button = [&](const char* name, Glyph glyph) {
    if (glyphButton((std::string("##") + name).c_str(), glyph, enabled)) action(name).run(model);
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
  if (target->cell) model.selection.selectCell(*target->cell), model.focusWanted = boundsOfCell(grid, *target->cell);
  if (target->reference) model.selection.selectTriangle(*target->reference), model.focusWanted = boundsOfTriangle(*model.frame, *target->reference);
  if (target->instance) model.selection.selectInstance(*target->instance), model.focusWanted = boundsOfInstance(*model.frame, *target->instance);
  model.search.clear();
}

void drawSearch(WindowModel& model, float right) {
  const float width = std::min(unit(370), right - ImGui::GetCursorScreenPos().x - unit(8));
  if (width < unit(80)) return;
  ImGui::SetCursorScreenPos({right - width, ImGui::GetWindowPos().y + unit(10)});
  ImGui::SetNextItemWidth(width);
  if (model.searchWanted) ImGui::SetKeyboardFocusHere();
  model.searchWanted = false;
  const bool entered = ImGui::InputTextWithHint("##search", "Pixel, cell, triangle, instance, mesh...   Ctrl+F", &model.search, ImGuiInputTextFlags_EnterReturnsTrue);
  whyTooltip("Filters the tables as it is typed: words, \"cell 72,4,47\", \"refused>5\". Enter goes to the pixel, cell, triangle or instance");
  if (entered && model.frame) goToTarget(model);
}

void divider() {
  ImGui::SameLine(0.0f, unit(10));
  const ImVec2 place = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine(place, {place.x, place.y + unit(24)}, packed(uiColour(UiColour::line)));
  ImGui::Dummy({unit(1), unit(24)});
  ImGui::SameLine(0.0f, unit(10));
}

void statusPair(const char* words, const std::string& number) {
  textDim(words);
  ImGui::SameLine(0.0f, unit(5));
  textMono(number);
  ImGui::SameLine(0.0f, unit(12));
}

}  // namespace

void drawToolbar(WindowModel& model) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - unit(8);
  drawWorkspaces(model);
  divider();
  drawTime(model);
  divider();
  // What does not fit is in the menus.
  for (const char* name : {"Next hole", "Next voxel wrong", "Fullest cell", "Capture frame"}) {
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
  swatch(kColourTriangleHit);
  textDim(frame.device);
  ImGui::SameLine(0.0f, unit(14));
  statusPair("ui", printed("%.1f ms", model.interfaceMs));
  // Narrow windows leave out the stages that a grid's settings do not change.
  const bool roomy = ImGui::GetWindowWidth() > unit(1450);
  struct StageTime {
    const char* name;
    double ms;
    bool always;
  };
  const StageTime times[] = {{"build", frame.times.build, true},    {"update", frame.times.clear + frame.times.add, true},
                             {"gather", frame.times.gather, false}, {"bounce", frame.times.bounce, false},
                             {"trace", frame.times.trace, true},    {"views", frame.times.views, false}};
  for (const StageTime& time : times)
    if (roomy || time.always) statusPair(time.name, printed(time.ms < 10.0 ? "%.1f ms" : "%.0f ms", time.ms));
  const GridStatistics& totals = frame.totals.statistics;
  {
    const StaleDim dim(staleValues(model).grid);
    statusPair("stored", grouped(frame.totals.stored()));
    statusPair("refused", grouped(frame.totals.refused()) + " (" + percentOf(frame.totals.refused(), std::max<uint64_t>(frame.tried, 1)) + ")");
    swatch(kColourSaturated, true);
    statusPair("saturated", grouped(totals.saturated) + (roomy ? " of " + grouped(totals.occupied) + " cells" : ""));
  }
  if (frame.request.settings) {
    const std::string size = printed("%u x %u", frame.request.settings->width, frame.request.settings->height);
    const std::string progress = frame.stale || frame.traced < 1.0f ? printed("  traced %.0f %%", 100.0 * double(frame.traced)) : "";
    const std::string text = size + progress;
    ImFont* mono = windowFonts().mono;
    const float width = mono->CalcTextSizeA(mono->FontSize, FLT_MAX, 0.0f, text.c_str()).x;
    const float x = ImGui::GetWindowWidth() - width - unit(10);
    if (x > ImGui::GetCursorPosX()) {
      ImGui::SetCursorPosX(x);
      textMono(text);
    }
  }
  ImGui::PopFont();
}

}  // namespace gridscope
