// The tuner's plot: wrong rays of every setting against memory or trace time, the front, the limits, and the settings that matter.
#include <algorithm>
#include <cmath>
#include <set>

#include "app/base/text.h"
#include "app/ui/panels/plot_frame.h"
#include "app/ui/panels/tuner.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

constexpr double kMiB = 1024.0 * 1024.0;

double amountOf(const TuneRow& row, bool againstTime) { return againstTime ? traceTimeOf(row) : memoryOf(row) / kMiB; }

PlotScale amountScale(const TunerPanel& tuner, bool againstTime) {
  double low = INFINITY, high = 0.0;
  for (const TuneRow& row : tuner.state.rows) {
    if (!row.measured()) continue;
    low = std::min(low, amountOf(row, againstTime)), high = std::max(high, amountOf(row, againstTime));
  }
  if (!(low <= high) || low <= 0.0) return {.low = 0.1, .high = 10.0, .logarithmic = true};
  return {.low = low / 1.25, .high = std::max(high * 1.25, low * 1.6), .logarithmic = true};
}

PlotScale wrongScale(const TunerPanel& tuner) {
  double high = 0.0;
  for (const TuneRow& row : tuner.state.rows)
    if (row.measured()) high = std::max(high, wrongShare(row));
  PlotScale scale = scaleFromZero(high);
  return scale;
}

// Square: exact; circle: plane. By area: with an edge.
void drawPoint(const TunerPanel& tuner, const TuneRow& row, const ImVec2& place, bool faint) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  ImVec4 colour = capacityColour(tuner, row.grid.capacity);
  if (faint) colour.w = 0.4f;
  const float radius = unit(3);
  ImVec4 edge = uiColour(UiColour::text);
  edge.w = faint ? 0.35f : 0.9f;
  const bool edged = row.grid.numberBy == NumberBy::area;
  if (row.grid.overlap == kOverlapExact) {
    const ImVec2 low(place.x - radius, place.y - radius), high(place.x + radius, place.y + radius);
    list->AddRectFilled(low, high, packed(colour));
    if (edged) list->AddRect(low, high, packed(edge), 0.0f, 0, 1.0f);
  } else {
    list->AddCircleFilled(place, radius + 0.5f, packed(colour), 12);
    if (edged) list->AddCircle(place, radius + 0.5f, packed(edge), 12, 1.0f);
  }
}

// Steps: each setting of the front holds until the next one.
void drawFront(const PlotFrame& plot, const TunerPanel& tuner, bool againstTime) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 colour = packed(uiColour(UiColour::text));
  const TuneRow* before = nullptr;
  for (const size_t index : frontAgainst(tuner.state.rows, againstTime ? traceTimeOf : memoryOf)) {
    const TuneRow& row = tuner.state.rows[index];
    const float x = plot.x(amountOf(row, againstTime)), y = plot.y(wrongShare(row));
    if (before) {
      const float beforeX = plot.x(amountOf(*before, againstTime)), beforeY = plot.y(wrongShare(*before));
      list->AddLine(ImVec2(beforeX, beforeY), ImVec2(x, beforeY), colour, 1.0f);
      list->AddLine(ImVec2(x, beforeY), ImVec2(x, y), colour, 1.0f);
    }
    before = &row;
  }
}

// A ring around a point, and its name in a box where there is room.
void drawCallout(const PlotFrame& plot, const ImVec2& place, const std::string& title, const std::string& text, const ImVec4& colour,
                 bool above) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddCircle(place, unit(7), packed(colour), 20, unit(2));
  if (plot.high().y - plot.low().y < unit(150)) return;
  const float width = std::max(plotTextWidth(title, false), plotTextWidth(text, true)) + unit(14), height = unit(34);
  const float x =
      std::clamp(place.x - 0.5f * width, plot.low().x + unit(2), std::max(plot.low().x + unit(2), plot.high().x - width - unit(2)));
  const float y = above ? std::max(plot.low().y + unit(2), place.y - height - unit(34))
                        : std::min(plot.high().y - height - unit(2), place.y + unit(34));
  list->AddLine(ImVec2(place.x, place.y + (above ? -unit(7) : unit(7))), ImVec2(place.x, above ? y + height : y), packed(colour), 1.0f);
  list->AddRectFilled(ImVec2(x, y), ImVec2(x + width, y + height), packed(uiColour(UiColour::window)));
  list->AddRect(ImVec2(x, y), ImVec2(x + width, y + height), packed(uiColour(UiColour::line)));
  list->AddRectFilled(ImVec2(x, y), ImVec2(x + unit(3), y + height), packed(colour));
  plotText(ImVec2(x + unit(8), y + unit(2)), title, uiColour(UiColour::text), false);
  plotText(ImVec2(x + unit(8), y + unit(17)), text, uiColour(UiColour::dim), true);
}

std::string shortText(const TuneRow& row) {
  return cellsText(row) + " \u00b7 " + std::to_string(row.grid.capacity) + " \u00b7 " + overlapWord(row.grid.overlap) +
         (row.grid.numberBy == NumberBy::area ? " \u00b7 area" : "");
}

// The limit as a line that can be dragged; what lies behind it is shaded.
void drawLimit(const PlotFrame& plot, const PlotScale& scale, TunerPanel& tuner, bool againstTime) {
  TuneLimits limits = tuner.shownLimits();
  double amount = againstTime ? limits.milliseconds : limits.bytes / kMiB;
  const float x = std::min(plot.x(amount), plot.high().x);
  ImGui::SetCursorScreenPos(ImVec2(x - unit(5), plot.low().y));
  ImGui::InvisibleButton(againstTime ? "limit time" : "limit memory", ImVec2(unit(10), plot.high().y - plot.low().y));
  const bool held = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 1.0f)) {
    amount = scale.valueAt(std::clamp(double(ImGui::GetIO().MousePos.x - plot.low().x) / double(plot.high().x - plot.low().x), 0.0, 1.0));
    (againstTime ? limits.milliseconds : limits.bytes) = againstTime ? amount : amount * kMiB;
    tuner.limits = limits;
  }
  if (held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(ImVec2(x, plot.low().y), plot.high(), packed(ImVec4(0, 0, 0, 0.22f)));
  list->AddLine(ImVec2(x, plot.low().y), ImVec2(x, plot.high().y), packed(uiColour(UiColour::accent)), unit(held ? 3.0f : 2.0f));
  list->AddRectFilled(ImVec2(x - unit(4), plot.low().y - unit(6)), ImVec2(x + unit(4), plot.low().y + unit(6)),
                      packed(uiColour(UiColour::accent)), unit(2));
  if (ImGui::IsItemHovered()) whyTooltip("Drag: settings to the right of it are not recommended");
  const std::string text = againstTime ? printed("limit %.1f ms", amount) : "limit " + plotNumber(std::round(amount)) + " MiB";
  const float width = plotTextWidth(text, false);
  const float left = x + width + unit(6) < plot.high().x ? x + unit(5) : x - width - unit(5);
  plotText(ImVec2(left, plot.low().y + unit(1)), text, uiColour(UiColour::text), false);
}

// A square of each capacity's colour, at the right end of the title's line.
void drawCapacities(const TunerPanel& tuner, const ImVec2& rightTop) {
  std::set<uint32_t> capacities;
  for (const TuneRow& row : tuner.state.rows) capacities.insert(row.grid.capacity);
  float x = rightTop.x - unit(6);
  for (auto capacity = capacities.rbegin(); capacity != capacities.rend(); ++capacity) {
    const std::string text = std::to_string(*capacity);
    x -= plotTextWidth(text, true);
    plotText(ImVec2(x, rightTop.y + unit(3)), text, uiColour(UiColour::dim), true);
    x -= unit(12);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, rightTop.y + unit(6)), ImVec2(x + unit(8), rightTop.y + unit(14)),
                                              packed(capacityColour(tuner, *capacity)));
    x -= unit(8);
  }
  plotText(ImVec2(x - plotTextWidth("capacity", false), rightTop.y + unit(3)), "capacity", uiColour(UiColour::dim), false);
}

std::string readOut(const TuneRow& row) {
  return tuneTitle(row) + printed("\n%.1f %% wrong, %.1f MiB, trace %.1f ms\n", wrongShare(row), memoryOf(row) / kMiB, traceTimeOf(row)) +
         grouped(row.refused) + " refused, " + grouped(row.saturated) + " saturated cells\nClick: apply it";
}

// The point under the mouse, within a few pixels.
std::optional<size_t> pointUnder(const PlotFrame& plot, const TunerPanel& tuner, bool againstTime) {
  if (!plot.hovered()) return std::nullopt;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  std::optional<size_t> nearest;
  float least = unit(7);
  for (size_t index = 0; index < tuner.state.rows.size(); ++index) {
    const TuneRow& row = tuner.state.rows[index];
    if (!row.measured()) continue;
    const float distance = std::hypot(plot.x(amountOf(row, againstTime)) - mouse.x, plot.y(wrongShare(row)) - mouse.y);
    if (distance < least) least = distance, nearest = index;
  }
  return nearest;
}

void drawNow(const WindowModel& model, const TunerPanel& tuner, const PlotFrame& plot, bool againstTime) {
  const std::optional<size_t> now = rowOfFrame(model, tuner), best = tuner.recommended();
  const auto place = [&](const TuneRow& row) { return ImVec2(plot.x(amountOf(row, againstTime)), plot.y(wrongShare(row))); };
  if (now && tuner.state.rows[*now].measured()) {
    const TuneRow& row = tuner.state.rows[*now];
    drawCallout(plot, place(row), now == best ? "Now, recommended" : "Now", shortText(row), uiColour(UiColour::dim), true);
  }
  if (best && best != now)
    drawCallout(plot, place(tuner.state.rows[*best]), "Recommended", shortText(tuner.state.rows[*best]), meaningColour(kColourTriangleHit),
                false);
}

}  // namespace

void drawTunerPlot(WindowModel& model, TunerPanel& tuner, bool againstTime, const ImVec2& low, const ImVec2& high) {
  const bool tall = high.y - low.y > unit(260), wide = high.x - low.x > unit(380);
  const PlotScale scale = amountScale(tuner, againstTime);
  PlotLook look{.title = "Wrong rays",
                .note = tall && wide && !againstTime ? "circle: plane, square: exact" : "",
                .x = scale,
                .y = wrongScale(tuner),
                .yUnit = " %",
                .gridX = true};
  look.xTitle = againstTime ? "trace, ms (" + grouped(tuner.state.width) + " \u00d7 " + grouped(tuner.state.height) + " rays, this device)"
                            : "memory of the grid image, MiB";
  const PlotFrame plot(look, low, high);
  if (!plot.drawn()) return;
  if (tall && againstTime) drawCapacities(tuner, ImVec2(high.x, low.y));
  if (tuner.state.rows.front().measured()) drawLimit(plot, scale, tuner, againstTime);
  drawFront(plot, tuner, againstTime);
  const std::optional<size_t> under = pointUnder(plot, tuner, againstTime);
  const std::vector<size_t> front = frontAgainst(tuner.state.rows, againstTime ? traceTimeOf : memoryOf);
  for (size_t index = 0; index < tuner.state.rows.size(); ++index) {
    const TuneRow& row = tuner.state.rows[index];
    if (row.measured())
      drawPoint(tuner, row, ImVec2(plot.x(amountOf(row, againstTime)), plot.y(wrongShare(row))),
                std::find(front.begin(), front.end(), index) == front.end());
  }
  drawNow(model, tuner, plot, againstTime);
  if (!under) return;
  tuner.hovered = under;
  const TuneRow& row = tuner.state.rows[*under];
  ImGui::GetWindowDrawList()->AddCircle(ImVec2(plot.x(amountOf(row, againstTime)), plot.y(wrongShare(row))), unit(5),
                                        packed(uiColour(UiColour::text)), 16, unit(1.5f));
  ImGui::SetTooltip("%s", readOut(row).c_str());
  if (ImGui::IsMouseClicked(0) && !ImGui::IsAnyItemActive()) applyRow(model, row);
}

}  // namespace gridscope
