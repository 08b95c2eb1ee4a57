// The tuner: sweeps the grid's settings over the rays of the frame that is shown, and says which one to take.
#include "app/ui/panels/tuner.h"

#include <algorithm>

#include "app/base/text.h"
#include "app/model/comparison.h"
#include "app/model/exports.h"
#include "app/report/tune_report.h"
#include "app/ui/panels/panels.h"
#include "app/ui/panels/sheet.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

std::optional<size_t> TunerPanel::recommended() const {
  if (state.rows.empty() || !state.rows.front().measured()) return std::nullopt;
  if (limits) return bestWithin(state.rows, *limits);
  return state.recommended;
}

void applyRow(WindowModel& model, const TuneRow& row) {
  if (!row.measured()) return model.announce(LogLine::Kind::warning, row.refusal);
  model.changeSettings([&](FrameSettings& settings) { applyTuneRow(row, settings); });
  model.announce(LogLine::Kind::note, "Applied " + tuneTitle(row));
}

void compareRow(WindowModel& model, const TuneRow& row) {
  if (!row.measured()) return applyRow(model, row);
  keepFrame(model);
  applyRow(model, row);
  // The viewport, which the tuner fills in its own workspace.
  if (model.workspace == Workspace::tune) model.workspace = Workspace::grid;
  model.layout = ViewportLayout::compare;
  model.showTab(BottomTab::tune);
}

std::string cellsText(const TuneRow& row) {
  return row.grid.cellEdge > 0.0f ? printed("edge %g", double(row.grid.cellEdge)) : std::to_string(row.grid.cells);
}

double wrongShare(const TuneRow& row) { return row.rays == 0 ? 0.0 : 100.0 * double(row.wrong()) / double(row.rays); }

ImVec4 capacityColour(const TunerPanel& tuner, uint32_t capacity) {
  std::vector<uint32_t> capacities = tuner.axes.capacities;
  for (const TuneRow& row : tuner.state.rows) capacities.push_back(row.grid.capacity);
  std::sort(capacities.begin(), capacities.end());
  capacities.erase(std::unique(capacities.begin(), capacities.end()), capacities.end());
  const auto place = std::lower_bound(capacities.begin(), capacities.end(), capacity) - capacities.begin();
  const float share = capacities.size() < 2 ? 1.0f : float(place) / float(capacities.size() - 1);
  const vec3 colour = colourMap(kColourMapViridis, 0.22f + 0.78f * share);
  return ImVec4(colour.x, colour.y, colour.z, 1.0f);
}

std::optional<size_t> rowOfFrame(const WindowModel& model, const TunerPanel& tuner) {
  if (!model.request.settings) return std::nullopt;
  const FrameSettings& now = *model.request.settings;
  for (size_t index = 0; index < tuner.state.rows.size(); ++index) {
    const TuneRow& row = tuner.state.rows[index];
    const bool sameGrid = row.grid.cells == now.grid.cells && row.grid.cellEdge == now.grid.cellEdge &&
                          row.grid.capacity == now.grid.capacity && row.grid.overlap == now.grid.overlap &&
                          row.grid.numberBy == now.grid.numberBy;
    const bool sameTrace = row.trace.traversal == now.trace.traversal && row.trace.back == now.trace.back &&
                           row.trace.ahead == now.trace.ahead && row.trace.gate == now.trace.gate;
    if (sameGrid && sameTrace) return index;
  }
  return std::nullopt;
}

namespace {

// --- Axes -------------------------------------------------------------------------------------------------------------------------

// A row of check boxes, one a value; the last one that is on can't be taken off.
template <typename Value, typename Text>
void axisRow(const char* name, std::vector<Value>& axis, const std::vector<Value>& choices, const Text& textOf) {
  textDim(name);
  ImGui::PushID(name);
  float x = unit(90);
  for (size_t index = 0; index < choices.size(); ++index, x += unit(76)) {
    if (index > 0 && index % 7 == 0) ImGui::NewLine(), x = unit(90);
    ImGui::SameLine(x);
    const auto found = std::find(axis.begin(), axis.end(), choices[index]);
    bool on = found != axis.end();
    const bool last = on && axis.size() == 1;
    ImGui::BeginDisabled(last);
    ImGui::PushID(static_cast<int>(index));
    if (ImGui::Checkbox(textOf(choices[index]).c_str(), &on)) {
      if (on)
        axis.insert(std::upper_bound(axis.begin(), axis.end(), choices[index]), choices[index]);
      else
        axis.erase(found);
    }
    ImGui::PopID();
    ImGui::EndDisabled();
    if (last) whyTooltip("One value must stay");
  }
  ImGui::PopID();
}

void drawAxes(const WindowModel& model, TunerPanel& tuner) {
  static const TuneAxes usual;
  TuneAxes& axes = tuner.axes;
  const auto whole = [](uint32_t value) { return std::to_string(value); };
  const auto length = [](float value) { return printed("%g", double(value)); };
  axisRow("Cells", axes.cells, {32, 48, 64, 96, 128, 160, 192, 256, 320}, whole);
  axisRow("Capacity", axes.capacities, {4, 8, 16, 24, 32, 48, 64, 128}, whole);
  axisRow("Overlap", axes.overlaps, usual.overlaps, [](uint32_t overlap) { return std::string(overlapWord(overlap)); });
  ImGui::BeginDisabled(!canRenumber(*model.frame));
  axisRow("Numbering", axes.numberings, usual.numberings,
          [](NumberBy order) { return std::string(order == NumberBy::area ? "by area" : "by file"); });
  ImGui::EndDisabled();
  if (!canRenumber(*model.frame)) whyTooltip("Captures and edited scenes keep their numbering");
  ImGui::Dummy(ImVec2(0.0f, unit(4)));
  textDim("Then, on the best of these grids:");
  axisRow("Traversal", axes.traversals, usual.traversals, [](uint32_t traversal) { return std::string(traversalWord(traversal)); });
  axisRow("Back", axes.backs, usual.backs, length);
  axisRow("Ahead", axes.aheads, usual.aheads, length);
  axisRow("Gate", axes.gates, usual.gates, length);
  ImGui::Dummy(ImVec2(0.0f, unit(4)));
  if (smallButton("Usual axes", "usual", "What `gridscope tune` sweeps")) axes = usual;
}

template <typename Value>
std::string axisText(const std::vector<Value>& axis, std::string (*textOf)(Value)) {
  if (axis.size() == 1) return textOf(axis.front());
  return textOf(axis.front()) + (axis.size() == 2 ? ", " : " \u2026 ") + textOf(axis.back());
}

std::string axesText(const TuneAxes& axes) {
  const auto whole = [](uint32_t value) { return std::to_string(value); };
  return "cells " + axisText<uint32_t>(axes.cells, whole) + ", capacity " + axisText<uint32_t>(axes.capacities, whole);
}

std::string durationText(double seconds) {
  if (seconds < 60.0) return printed("%.0f s", seconds);
  return printed("%d min %d s", int(seconds) / 60, int(seconds) % 60);
}

void drawProgress(const TuneState& state) {
  const std::string count = grouped(state.done) + " of " + grouped(state.total) + " settings";
  if (state.total == 0) return textDim("Preparing the sweep...");
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, meaningColour(kColourTriangleHit));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + unit(5));
  const float besideWords = ImGui::GetContentRegionAvail().x - unit(345);
  ImGui::ProgressBar(float(state.done) / float(state.total), ImVec2(std::clamp(besideWords, unit(24), unit(110)), unit(6)), "");
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ImGui::SameLine(0.0f, unit(8));
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - unit(5));
  textMono(count);
  ImGui::SameLine(0.0f, unit(8));
  if (!state.running)
    textDim((state.stopped ? "stopped after " : "in ") + durationText(state.seconds));
  else if (state.secondsLeft() >= 0.0)
    textDim(durationText(state.secondsLeft()) + " left");
}

}  // namespace

void drawTunerStrip(WindowModel& model, TunerPanel& tuner) {
  beginStrip();
  const FrameSnapshot& frame = *model.frame;
  const bool possible = frame.rays && frame.instances && !frame.scene->foreign;
  const char* why = frame.scene->foreign ? "Another engine's grid can't be built again" : "The frame's rays are not there yet";
  if (tuner.state.running) {
    if (smallButton("Cancel", "cancel", "Stops after the setting that is being tried; what is done stays")) tuner.job.cancel();
  } else if (smallButton("Run sweep", "run", "Builds and traces every setting and compares it with the exact hits", possible, why)) {
    tuner.limits.reset();
    tuner.job.start(model.frame, tuner.axes);
  }
  ImGui::SameLine(0.0f, unit(6));
  if (smallButton("Axes...", "axes", "Which settings to try", !tuner.state.running, "The sweep is running")) ImGui::OpenPopup("tuner axes");
  ImGui::SetNextWindowSize(ImVec2(unit(650), 0.0f));
  if (ImGui::BeginPopup("tuner axes")) drawAxes(model, tuner), ImGui::EndPopup();
  ImGui::SameLine(0.0f, unit(10));
  if (tuner.state.running || !tuner.state.rows.empty()) {
    drawProgress(tuner.state);
    ImGui::SameLine();
    if (exportButton("Writes every setting tried as a CSV file", !tuner.state.running && !tuner.state.rows.empty(),
                     "The sweep is running")) {
      const TuneResult result{.rows = tuner.state.rows, .recommended = tuner.state.recommended};
      exportCsv(model, "tune", result.rows.size(), [result] { return tuneCsv(result); });
    }
    return;
  }
  textMono(grouped(settingCount(tuner.axes, canRenumber(frame))));
  ImGui::SameLine(0.0f, unit(6));
  textDim("settings: " + axesText(tuner.axes));
}

namespace {

// Choices side by side, one of them on.
template <typename Value>
void pageButtons(Value& value, std::initializer_list<std::pair<Value, const char*>> pages) {
  bool first = true;
  for (const auto& [page, label] : pages) {
    if (!first) ImGui::SameLine(0.0f, unit(2));
    first = false;
    const bool on = value == page;
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, uiColour(UiColour::selectedRow));
    if (smallButton(label, label, "")) value = page;
    if (on) ImGui::PopStyleColor();
  }
}

void drawTablePages(WindowModel& model, TunerPanel& tuner, bool withRecommendation, const ImVec2& size) {
  ImGui::BeginChild("pages", size);
  TunerPage page = tuner.page;
  if (!withRecommendation && page == TunerPage::recommendation) page = TunerPage::front;
  if (withRecommendation) {
    pageButtons<TunerPage>(page,
                           {{TunerPage::recommendation, "Recommendation"}, {TunerPage::front, "Front"}, {TunerPage::all, "All runs"}});
  } else {
    pageButtons<TunerPage>(page, {{TunerPage::front, "Front"}, {TunerPage::all, "All runs"}});
    const char* hint = "Click a point or a row to apply it";
    toTheRight(ImGui::CalcTextSize(hint).x);
    textDim(hint);
  }
  if (withRecommendation || page != TunerPage::front || tuner.page != TunerPage::recommendation) tuner.page = page;
  if (page == TunerPage::recommendation)
    drawTunerRecommendation(model, tuner, ImVec2(0, 0));
  else
    drawTunerTable(model, tuner, page == TunerPage::front, ImVec2(0, 0));
  ImGui::EndChild();
}

// Room for both plots, the table and the recommendation.
void drawLarge(WindowModel& model, TunerPanel& tuner, const ImVec2& free) {
  const float side = free.x >= unit(760) ? unit(300) : 0.0f, gap = unit(10);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float left = free.x - side - (side > 0.0f ? gap : 0.0f), plotHeight = std::floor(0.58f * free.y);
  const float each = 0.5f * (left - gap);
  drawTunerPlot(model, tuner, false, start, ImVec2(start.x + each, start.y + plotHeight));
  drawTunerPlot(model, tuner, true, ImVec2(start.x + each + gap, start.y), ImVec2(start.x + left, start.y + plotHeight));
  ImGui::SetCursorScreenPos(ImVec2(start.x, start.y + plotHeight + unit(6)));
  drawTablePages(model, tuner, side == 0.0f, ImVec2(left, free.y - plotHeight - unit(6)));
  if (side == 0.0f) return;
  ImGui::SetCursorScreenPos(ImVec2(start.x + left + gap, start.y));
  drawTunerRecommendation(model, tuner, ImVec2(side, free.y));
}

// One plot beside the pages.
void drawSmall(WindowModel& model, TunerPanel& tuner, const ImVec2& free) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float plotWidth = std::floor(0.46f * free.x), gap = unit(10);
  drawTunerPlot(model, tuner, tuner.againstTime, start, ImVec2(start.x + plotWidth, start.y + free.y));
  ImGui::SetCursorScreenPos(ImVec2(start.x + plotWidth - unit(108), start.y + unit(1)));
  ImGui::PushID("axis");
  pageButtons<bool>(tuner.againstTime, {{false, "Memory"}, {true, "Time"}});
  ImGui::PopID();
  ImGui::SetCursorScreenPos(ImVec2(start.x + plotWidth + gap, start.y));
  drawTablePages(model, tuner, true, ImVec2(free.x - plotWidth - gap, free.y));
}

}  // namespace

void drawTuner(WindowModel& model) {
  static TunerPanel tuner;
  if (!model.frame || !model.frame->scene) return emptyState("No frame yet: it shows here as soon as the first one is done.");
  if (tuner.state.number != tuner.job.number() || tuner.state.running) tuner.state = tuner.job.state();
  drawTunerStrip(model, tuner);
  if (!tuner.state.fault.empty()) return emptyState(("The sweep failed: " + tuner.state.fault).c_str());
  if (tuner.state.rows.empty())
    return emptyState(tuner.state.running
                          ? "The first setting is being tried..."
                          : "Run a sweep: every setting is built, traced with this frame's rays and compared with the exact hits.");
  const ImVec2 free = ImGui::GetContentRegionAvail();
  tuner.hovered.reset();
  if (free.y >= unit(380))
    drawLarge(model, tuner, free);
  else
    drawSmall(model, tuner, free);
}

}  // namespace gridscope
