// See step_timeline.h.
#include "app/ui/panels/step_timeline.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/model/ray_stepping.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/widgets/step_parts.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

constexpr float kLabels = 92.0f;  // pixels at UI scale 1
constexpr float kLeastColumn = 22.0f, kMostColumn = 58.0f;
constexpr float kNumberRow = 18.0f, kGlyphRow = 24.0f;

// Where the rows are, pixels of the screen; x of step 0's left edge.
struct Rows {
  float left, column;
  float top, glyphs, testsTop, testsBottom, gateTop, gateBottom;
  float x(uint32_t step) const { return left + (float(step) + 0.5f) * column; }
};

Rows rowsOf(ImVec2 corner, float column, float height) {
  Rows rows{.left = corner.x, .column = column, .top = corner.y};
  rows.glyphs = rows.top + unit(kNumberRow);
  rows.testsTop = rows.glyphs + unit(kGlyphRow);
  const float rest = std::max(corner.y + height - rows.testsTop, unit(20));
  rows.testsBottom = rows.testsTop + std::floor(0.56f * rest);
  rows.gateTop = rows.testsBottom + unit(6);
  rows.gateBottom = corner.y + height - unit(4);
  return rows;
}

void drawLabels(const Rows& rows) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  ImFont* font = windowFonts().sansSmall;
  const float x = ImGui::GetWindowPos().x + unit(10);
  const auto label = [&](float y, const char* text) {
    list->AddText(font, font->FontSize, ImVec2(x, y - 0.5f * font->FontSize), packed(uiColour(UiColour::dim)), text);
  };
  label(rows.top + unit(0.5f * kNumberRow), "step");
  label(rows.glyphs + unit(0.5f * kGlyphRow), "outcome");
  label(0.5f * (rows.testsTop + rows.testsBottom), "tests");
  label(0.5f * (rows.gateTop + rows.gateBottom), "gate, cells");
}

void centredText(ImDrawList* list, ImVec2 middle, const std::string& text, const ImVec4& colour) {
  ImFont* font = windowFonts().mono;
  const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.c_str()).x;
  list->AddText(font, font->FontSize, ImVec2(std::floor(middle.x - 0.5f * width), std::floor(middle.y - 0.5f * font->FontSize)),
                packed(colour), text.c_str());
}

void drawTestBar(const Rows& rows, const RayRecord& record, uint32_t step, size_t most) {
  const size_t tests = record.steps[step].tests.size();
  if (tests == 0) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const StepLook& look = stepLook(stepOutcome(record, step));
  const float room = std::max(rows.testsBottom - rows.testsTop - unit(15), unit(2));
  const float top = rows.testsBottom - std::max(room * float(tests) / float(most), unit(2));
  const float half = std::min(0.36f * rows.column, unit(14));
  const ImVec2 low(rows.x(step) - half, top), high(rows.x(step) + half, rows.testsBottom);
  list->AddRectFilled(low, high, packed(meaningColour(look.colour)));
  if (look.shape == StepShape::hatchedSquare) hatch(list, low, high, packed(uiColour(UiColour::panel)));
  if (rows.column >= unit(26)) centredText(list, ImVec2(rows.x(step), top - unit(7)), std::to_string(tests), uiColour(UiColour::text));
}

// The gate's value over the steps; the threshold dashed.
struct GateScale {
  float low = 0.0f, high = 1.0f;
  float y(const Rows& rows, float value) const { return rows.gateBottom - (value - low) / (high - low) * (rows.gateBottom - rows.gateTop); }
};

GateScale gateScale(const FrameSnapshot& frame, const RecordedRay& ray) {
  const uint32_t last = static_cast<uint32_t>(ray.record.steps.size()) - 1;
  const float threshold = frame.parameters.trace.gate / frame.parameters.grid.cellEdge;
  const float first = stepTravel(frame, ray, 0), end = stepTravel(frame, ray, last);
  GateScale scale;
  scale.low = std::min({0.0f, first, end});
  scale.high = std::max({first, end, threshold * 1.15f, scale.low + 1e-3f});
  return scale;
}

void dashedLine(ImDrawList* list, ImVec2 a, ImVec2 b, ImU32 colour) {
  for (float x = a.x; x < b.x; x += unit(8)) list->AddLine(ImVec2(x, a.y), ImVec2(std::min(x + unit(4), b.x), a.y), colour, unit(1));
}

void drawGate(const FrameSnapshot& frame, const RecordedRay& ray, const Rows& rows, uint32_t begin, uint32_t end) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const GateScale scale = gateScale(frame, ray);
  const bool dot = rows.column >= unit(10);
  for (uint32_t step = begin; step < end; ++step) {
    const ImVec2 here(rows.x(step), scale.y(rows, stepTravel(frame, ray, step)));
    if (step + 1 < ray.record.steps.size())
      list->AddLine(here, ImVec2(rows.x(step + 1), scale.y(rows, stepTravel(frame, ray, step + 1))), packed(uiColour(UiColour::text)),
                    unit(1.3f));
    if (dot) list->AddCircleFilled(here, unit(2), packed(uiColour(UiColour::text)), 8);
  }

  // The threshold, with its value where the line is out of the way.
  const ImVec4 gate = meaningColour(kColourGate);
  const bool filled = frame.parameters.trace.gapFill != 0;
  const float threshold = frame.parameters.trace.gate / frame.parameters.grid.cellEdge;
  const float y = scale.y(rows, threshold), right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - unit(10);
  dashedLine(list, ImVec2(rows.left, y), ImVec2(std::max(right, rows.left), y), packed(gate));
  const std::string text = filled ? printed("gap-filling opens at %.2f", threshold) : "gap-filling is off";
  ImFont* font = windowFonts().sansSmall;
  const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.c_str()).x;
  const float textY = y - unit(15) > rows.gateTop - unit(4) ? y - unit(15) : y + unit(2);
  list->AddText(font, font->FontSize, ImVec2(right - width, textY), packed(gate), text.c_str());
}

void drawSelected(const Rows& rows, uint32_t step, float bottom) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 low(rows.x(step) - 0.5f * rows.column, rows.top), high(rows.x(step) + 0.5f * rows.column, bottom);
  list->AddRectFilled(low, high, packed(uiColour(UiColour::selectedRow)));
  list->AddRectFilled(low, ImVec2(high.x, low.y + unit(2)), packed(uiColour(UiColour::accent)));
}

void drawTooltip(const FrameSnapshot& frame, const RecordedRay& ray, uint32_t step) {
  const StepRecord& at = ray.record.steps[step];
  ImGui::BeginTooltip();
  ImGui::Text("Step %u, %s", step, stepLook(stepOutcome(ray.record, step)).word.data());
  ImGui::PushFont(windowFonts().mono);
  ImGui::Text("cell %s   t %.4g", cellNumbers(at.cell).c_str(), at.start);
  ImGui::Text("%zu tests%s   gate %.2f", at.tests.size(), at.saturated ? ", saturated" : "", stepTravel(frame, ray, step));
  ImGui::PopFont();
  ImGui::EndTooltip();
}

// What the mouse does over the steps.
void takeMouse(WindowModel& model, const RecordedRay& ray, const Rows& rows, uint32_t step) {
  const auto last = static_cast<float>(ray.record.steps.size() - 1);
  const auto under = static_cast<uint32_t>(std::clamp((ImGui::GetIO().MousePos.x - rows.left) / rows.column, 0.0f, last));
  if (ImGui::IsItemActive() && under != step) selectStepAt(model, under);
  if (!ImGui::IsItemHovered()) return;
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel < 0.0f) stepForward(model);
  if (wheel > 0.0f) stepBack(model);
  if (!ImGui::IsItemActive()) drawTooltip(*model.frame, ray, under);
}

// Keeps the selected step in sight when it is another one than before.
void scrollToStep(const RecordedRay& ray, uint32_t step, float column) {
  static const RecordedRay* lastRay = nullptr;
  static uint32_t lastStep = 0;
  if (lastRay == &ray && lastStep == step) return;
  lastRay = &ray, lastStep = step;
  const float left = float(step) * column, room = ImGui::GetWindowWidth() - unit(kLabels), margin = 2.0f * column;
  const float scroll = ImGui::GetScrollX();
  if (left - margin < scroll)
    ImGui::SetScrollX(std::max(0.0f, left - margin));
  else if (left + column + margin > scroll + room)
    ImGui::SetScrollX(left + column + margin - room);
}

}  // namespace

void drawStepTimeline(WindowModel& model, const RecordedRay& ray, uint32_t step, float height) {
  if (height < unit(40)) return;
  const RayRecord& record = ray.record;
  const auto count = static_cast<uint32_t>(record.steps.size());
  const float room = ImGui::GetContentRegionAvail().x - unit(kLabels + 10);
  const float column = std::clamp(room / float(count), unit(kLeastColumn), unit(kMostColumn));
  const bool scrolls = column * float(count) > room;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("steps", ImVec2(0.0f, height), false,
                    ImGuiWindowFlags_NoScrollWithMouse | (scrolls ? ImGuiWindowFlags_HorizontalScrollbar : 0));
  ImGui::PopStyleVar();
  scrollToStep(ray, step, column);
  const float inner = height - (scrolls ? ImGui::GetStyle().ScrollbarSize : 0.0f);
  const ImVec2 window = ImGui::GetWindowPos();
  const Rows rows = rowsOf(ImVec2(window.x + unit(kLabels) - ImGui::GetScrollX(), window.y), column, inner);

  // Only what is in sight.
  const float left = window.x + unit(kLabels), right = window.x + ImGui::GetWindowWidth();
  const auto begin = static_cast<uint32_t>(std::clamp((left - rows.left) / column, 0.0f, float(count)));
  const auto end = static_cast<uint32_t>(std::clamp((right - rows.left) / column + 1.0f, float(begin), float(count)));
  size_t most = 1;
  for (const StepRecord& at : record.steps) most = std::max(most, at.tests.size());

  ImDrawList* list = ImGui::GetWindowDrawList();
  drawLabels(rows);
  list->PushClipRect(ImVec2(left, window.y), ImVec2(right, window.y + height), true);
  drawSelected(rows, step, window.y + inner);
  const uint32_t every = column >= unit(22) ? 1 : 5;
  list->AddLine(ImVec2(left, rows.testsBottom), ImVec2(right, rows.testsBottom), packed(uiColour(UiColour::line)));
  for (uint32_t i = begin; i < end; ++i) {
    if (i % every == 0 || i == step)
      centredText(list, ImVec2(rows.x(i), rows.top + unit(0.5f * kNumberRow)), std::to_string(i),
                  uiColour(i == step ? UiColour::text : UiColour::dim));
    drawStepGlyph(list, ImVec2(rows.x(i), rows.glyphs + unit(0.5f * kGlyphRow)), std::min(unit(13), 0.7f * column), stepOutcome(record, i));
    drawTestBar(rows, record, i, most);
  }
  drawGate(*model.frame, ray, rows, begin, end);
  list->PopClipRect();

  // One item over all steps takes the mouse.
  ImGui::SetCursorPos(ImVec2(unit(kLabels), 0.0f));
  ImGui::InvisibleButton("take", ImVec2(std::max(column * float(count), 1.0f), std::max(inner - 1.0f, 1.0f)));
  takeMouse(model, ray, rows, step);
  ImGui::EndChild();
}

}  // namespace gridscope
