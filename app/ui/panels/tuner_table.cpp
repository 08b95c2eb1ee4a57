// The tuner's rows, and what it recommends.
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>

#include "app/base/text.h"
#include "app/ui/panels/sheet.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/panels/tuner.h"
#include "app/ui/widgets/rows.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

constexpr double kMiB = 1024.0 * 1024.0;

double share(uint64_t part, const TuneRow& row) { return row.rays == 0 ? 0.0 : 100.0 * double(part) / double(row.rays); }

std::string percent(double value) { return printed(value < 1.0 && value > 0.0 ? "%.2f %%" : "%.1f %%", value); }

std::string traceText(const TraceSettings& trace) {
  if (trace.traversal == kTraversalDda) return printed("dda, gate %g", double(trace.gate));
  return printed("%g/%g, gate %g", double(trace.back), double(trace.ahead), double(trace.gate));
}

// --- Table ------------------------------------------------------------------------------------------------------------------------

struct TunerColumn {
  const char* title;
  const char* about;
  bool number;
  float weight;
  int rank;  // columns of a higher rank go first when the table is narrow
  std::string (*text)(const TuneRow& row);
};

const TunerColumn kColumns[] = {
    {"cells", "Along the longest side", true, 0.7f, 0, [](const TuneRow& row) { return cellsText(row); }},
    {"capacity", "Slots of a cell", true, 0.8f, 0, [](const TuneRow& row) { return std::to_string(row.grid.capacity); }},
    {"overlap", "Which cells take a triangle", false, 0.8f, 0,
     [](const TuneRow& row) { return std::string(overlapWord(row.grid.overlap)); }},
    {"order", "Numbering of the references", false, 0.6f, 1,
     [](const TuneRow& row) { return std::string(numberingWord(row.grid.numberBy)); }},
    {"trace", "Back / ahead of a segment, and the gate, in cell edges", false, 1.6f, 2,
     [](const TuneRow& row) { return traceText(row.trace); }},
    {"MiB", "Memory of the grid image", true, 0.8f, 0, [](const TuneRow& row) { return printed("%.1f", double(row.bytes) / kMiB); }},
    {"ms", "Trace, median", true, 0.8f, 0,
     [](const TuneRow& row) { return row.measured() ? printed("%.1f", row.traceMs.median) : "\u2013"; }},
    {"refused", "References that found no slot", true, 1.0f, 2,
     [](const TuneRow& row) { return row.measured() ? grouped(row.refused) : "\u2013"; }},
    {"saturated", "Cells that refused one or more", true, 1.0f, 3,
     [](const TuneRow& row) { return row.measured() ? grouped(row.saturated) : "\u2013"; }},
    {"holes", "A surface is there, the ray missed everything", true, 0.8f, 3,
     [](const TuneRow& row) { return percent(share(row.verdicts[kVerdictHole], row)); }},
    {"voxel wrong", "Voxel hits farther than a cell's diagonal from the true surface", true, 1.2f, 3,
     [](const TuneRow& row) { return percent(share(row.verdicts[kVerdictVoxelWrong], row)); }},
    {"far, near", "Triangle hits behind or before the true surface", true, 1.0f, 3,
     [](const TuneRow& row) { return percent(share(row.verdicts[kVerdictTooFar] + row.verdicts[kVerdictTooNear], row)); }},
    {"wrong", "Holes, wrong voxel hits, too far and too near", true, 0.8f, 0,
     [](const TuneRow& row) { return row.measured() ? percent(wrongShare(row)) : "\u2013"; }},
};

std::vector<const TunerColumn*> columnsFor(float width) {
  const int rank = width >= unit(760) ? 3 : width >= unit(560) ? 2 : width >= unit(420) ? 1 : 0;
  std::vector<const TunerColumn*> columns;
  for (const TunerColumn& column : kColumns)
    if (column.rank <= rank) columns.push_back(&column);
  return columns;
}

struct RowName {
  std::string text;
  ImVec4 colour;
};

RowName nameOf(const TunerPanel& tuner, size_t index, const std::optional<size_t>& now) {
  const TuneRow& row = tuner.state.rows[index];
  if (tuner.recommended() == index) return {"Recommended", meaningColour(kColourTriangleHit)};
  if (now == index) return {"Now", uiColour(UiColour::text)};
  if (!row.measured()) return {"Can't", uiColour(UiColour::disabled)};
  const TuneLimits limits = tuner.shownLimits();
  if (memoryOf(row) > limits.bytes) return {"over memory", uiColour(UiColour::disabled)};
  if (traceTimeOf(row) > limits.milliseconds) return {"over time", uiColour(UiColour::disabled)};
  return {"", uiColour(UiColour::dim)};
}

// Best first; what was refused last.
std::vector<size_t> orderedRows(const TunerPanel& tuner, bool frontAlone, const std::optional<size_t>& now) {
  std::vector<size_t> order;
  const std::optional<size_t> best = tuner.recommended();
  for (size_t index = 0; index < tuner.state.rows.size(); ++index)
    if (!frontAlone || tuner.state.rows[index].front || best == index || now == index) order.push_back(index);
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    const TuneRow &left = tuner.state.rows[a], &right = tuner.state.rows[b];
    if (left.measured() != right.measured()) return left.measured();
    return left.wrong() < right.wrong();
  });
  return order;
}

void drawRow(WindowModel& model, TunerPanel& tuner, size_t index, const std::vector<const TunerColumn*>& columns,
             const std::optional<size_t>& now) {
  const TuneRow& row = tuner.state.rows[index];
  ImGui::TableNextRow(0, unit(20));
  ImGui::TableSetColumnIndex(0);
  ImGui::PushID(static_cast<int>(index));
  if (rowSelectable(now == index)) applyRow(model, row);
  if (!row.measured()) whyTooltip(row.refusal.c_str());
  const RowName name = nameOf(tuner, index, now);
  smallText(name.text, name.colour);
  const ImVec4 ink = row.measured() ? uiColour(UiColour::text) : uiColour(UiColour::disabled);
  for (size_t column = 0; column < columns.size(); ++column) {
    ImGui::TableSetColumnIndex(static_cast<int>(column) + 1);
    const std::string text = columns[column]->text(row);
    if (columns[column]->number)
      rightNumber(text, ink);
    else
      smallText(text, ink);
  }
  ImGui::PopID();
}

}  // namespace

void drawTunerTable(WindowModel& model, TunerPanel& tuner, bool frontAlone, const ImVec2& size) {
  const std::vector<const TunerColumn*> columns = columnsFor(ImGui::GetContentRegionAvail().x);
  const std::optional<size_t> now = rowOfFrame(model, tuner);
  const std::vector<size_t> order = orderedRows(tuner, frontAlone, now);
  TableStyle style;
  // The number of columns is part of the name: a table keeps its columns.
  const std::string name = "tuner rows " + std::to_string(columns.size());
  if (!ImGui::BeginTable(name.c_str(), static_cast<int>(columns.size()) + 1, kTableFlags | ImGuiTableFlags_ScrollY, size)) return;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 1.6f);
  for (const TunerColumn* column : columns) ImGui::TableSetupColumn(column->title, ImGuiTableColumnFlags_WidthStretch, column->weight);
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, unit(20));
  for (size_t column = 0; column < columns.size(); ++column) {
    ImGui::TableSetColumnIndex(static_cast<int>(column) + 1);
    tableTitle(columns[column]->title, columns[column]->number);
    whyTooltip(columns[column]->about);
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(order.size()), tableRowHeight());
  while (clipper.Step())
    for (int at = clipper.DisplayStart; at < clipper.DisplayEnd; ++at) drawRow(model, tuner, order[size_t(at)], columns, now);
  ImGui::EndTable();
}

namespace {

// --- Recommendation ---------------------------------------------------------------------------------------------------------------

std::string changeText(double before, double after) {
  if (before == 0.0) return after == 0.0 ? "" : "new";
  const double change = 100.0 * (after - before) / before;
  return printed("%+.0f %%", change);
}

void changeRow(const char* name, double before, double after, std::string (*textOf)(double)) {
  ImGui::TableNextRow(0, unit(20));
  ImGui::TableSetColumnIndex(0);
  smallText(name, uiColour(UiColour::dim));
  ImGui::TableSetColumnIndex(1);
  rightNumber(textOf(before), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(2);
  rightNumber(textOf(after), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(3);
  rightNumber(changeText(before, after), after < before ? meaningColour(kColourTriangleHit) : uiColour(UiColour::dim));
}

void drawComparison(const TuneRow& before, const TuneRow& after) {
  TableStyle style;
  if (!ImGui::BeginTable("now and recommended", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::TableSetupColumn("", 0, 1.2f), ImGui::TableSetupColumn("now", 0, 1.0f), ImGui::TableSetupColumn("recommended", 0, 1.6f),
      ImGui::TableSetupColumn("change", 0, 0.8f);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, unit(20));
  int column = 0;
  for (const char* title : {"", "now", "recommended", "change"})
    if (ImGui::TableSetColumnIndex(column++) && *title) tableTitle(title, true);
  const auto shareText = [](double value) { return percent(value); };
  const auto wholeText = [](double value) { return grouped(uint64_t(std::llround(value))); };
  const auto meanText = [](double value) { return printed("%.1f", value); };
  const auto verdict = [](const TuneRow& row, uint32_t kind) { return share(row.verdicts[kind], row); };
  changeRow("Wrong rays", wrongShare(before), wrongShare(after), shareText);
  changeRow("Holes", verdict(before, kVerdictHole), verdict(after, kVerdictHole), shareText);
  changeRow("Voxel wrong", verdict(before, kVerdictVoxelWrong), verdict(after, kVerdictVoxelWrong), shareText);
  changeRow("Voxel right", verdict(before, kVerdictVoxelRight), verdict(after, kVerdictVoxelRight), shareText);
  changeRow("Too far", verdict(before, kVerdictTooFar), verdict(after, kVerdictTooFar), shareText);
  changeRow("Too near", verdict(before, kVerdictTooNear), verdict(after, kVerdictTooNear), shareText);
  changeRow("Memory", memoryOf(before) / kMiB, memoryOf(after) / kMiB, [](double value) { return printed("%.1f MiB", value); });
  changeRow("Trace", traceTimeOf(before), traceTimeOf(after), [](double value) { return printed("%.1f ms", value); });
  changeRow("Refused", double(before.refused), double(after.refused), wholeText);
  changeRow("Saturated", double(before.saturated), double(after.saturated), wholeText);
  changeRow("Tests a ray", before.tests, after.tests, meanText);
  changeRow("Visits a ray", before.visits, after.visits, meanText);
  ImGui::EndTable();
}

// One sentence of what changes.
std::string sentenceOf(const TuneRow& before, const TuneRow& after) {
  std::string text = after.wrong() < before.wrong() ? "Lowers the wrong rays from " : "Leaves the wrong rays at ";
  text += percent(wrongShare(before));
  if (after.wrong() != before.wrong()) text += " to " + percent(wrongShare(after));
  const double time = traceTimeOf(before) > 0.0 ? 100.0 * (traceTimeOf(after) / traceTimeOf(before) - 1.0) : 0.0;
  const double memory = (memoryOf(after) - memoryOf(before)) / kMiB;
  text += printed(", traces %.0f %% %s, for %.1f MiB %s.", std::abs(time), time <= 0.0 ? "faster" : "slower", std::abs(memory),
                  memory >= 0.0 ? "more" : "less");
  return text;
}

// From the least to the most that a setting took.
std::pair<SliderRange, SliderRange> measuredRanges(const TunerPanel& tuner) {
  SliderRange memory{FLT_MAX, 0.0f, true}, time{FLT_MAX, 0.0f, true};
  for (const TuneRow& row : tuner.state.rows) {
    if (!row.measured()) continue;
    const auto mebibytes = float(memoryOf(row) / kMiB), milliseconds = float(traceTimeOf(row));
    memory.low = std::min(memory.low, mebibytes), memory.high = std::max(memory.high, mebibytes);
    time.low = std::min(time.low, milliseconds), time.high = std::max(time.high, milliseconds);
  }
  for (SliderRange* range : {&memory, &time})
    range->low = std::max(0.9f * range->low, 1e-3f), range->high = std::max(1.1f * range->high, 2.0f * range->low);
  return {memory, time};
}

void drawLimits(TunerPanel& tuner) {
  TuneLimits limits = tuner.shownLimits();
  float memory = float(limits.bytes / kMiB), time = float(limits.milliseconds);
  ImGui::PushFont(windowFonts().sansSmall);
  const float width = ImGui::GetContentRegionAvail().x, field = std::max(unit(90), width - unit(110));
  bool changed = false;
  const auto [memoryRange, timeRange] = measuredRanges(tuner);
  textDim("Memory, at most");
  ImGui::SameLine(unit(110)), ImGui::SetNextItemWidth(field);
  changed |= fillSlider("##memory", memory, memoryRange, memory < 10.0f ? "%.1f MiB" : "%.0f MiB");
  textDim("Trace, at most");
  ImGui::SameLine(unit(110)), ImGui::SetNextItemWidth(field);
  changed |= fillSlider("##time", time, timeRange, "%.1f ms");
  ImGui::PopFont();
  if (changed) tuner.limits = TuneLimits{double(memory) * kMiB, double(time)};
  if (tuner.limits &&
      smallButton("Usual limits", "usual limits", "Twice the memory and 1.25 times the trace time of the frame's own setting"))
    tuner.limits.reset();
}

void drawFlags(WindowModel& model, const TuneRow& row) {
  const std::string flags = tuneFlags(row);
  ImGui::PushFont(windowFonts().mono);
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(flags.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  if (smallButton("Apply", "apply", "Shows the frame with this setting; Ctrl+Z goes back")) applyRow(model, row);
  ImGui::SameLine(0.0f, unit(6));
  if (smallButton("Compare A/B", "compare",
                  "Keeps the frame as it is now as B and shows it with this setting beside it; Space flips in the A/B layout"))
    compareRow(model, row);
  ImGui::SameLine(0.0f, unit(6));
  if (smallButton("Copy flags", "copy", "The options of the command line, to paste")) {
    ImGui::SetClipboardText(flags.c_str());
    model.announce(LogLine::Kind::note, "Copied: " + flags);
  }
}

// The best of what fits into the memory that the grid takes now.
void drawNoMoreMemory(WindowModel& model, const TunerPanel& tuner) {
  const TuneRow& first = tuner.state.rows.front();
  const std::optional<size_t> best = bestWithin(tuner.state.rows, {memoryOf(first), INFINITY});
  ImGui::PushFont(windowFonts().sansBold);
  ImGui::TextUnformatted("At no more memory than now");
  ImGui::PopFont();
  ImGui::PushTextWrapPos(0.0f);
  if (!best || *best == 0) {
    textDim(printed("No other run has fewer wrong rays within %.1f MiB.", memoryOf(first) / kMiB));
  } else {
    const TuneRow& row = tuner.state.rows[*best];
    textDim(tuneTitle(row) + printed(": %.1f MiB, ", memoryOf(row) / kMiB) + percent(wrongShare(row)) +
            printed(" wrong, trace %.1f ms.", traceTimeOf(row)));
    if (smallButton("Show it", "no more memory", "Shows the frame with this setting; Ctrl+Z goes back")) applyRow(model, row);
  }
  ImGui::PopTextWrapPos();
}

// What the figures rest on.
void drawHowMeasured(const TunerPanel& tuner) {
  const TuneRow& first = tuner.state.rows.front();
  ImGui::PushTextWrapPos(0.0f);
  textDim("Every run traces the same " + grouped(first.rays) + " rays (" + grouped(tuner.state.width) + " \u00d7 " +
          grouped(tuner.state.height) + ", this frame) and compares them with the exact hits. Times are medians on this device.");
  ImGui::PopTextWrapPos();
}

}  // namespace

void drawTunerRecommendation(WindowModel& model, TunerPanel& tuner, const ImVec2& size) {
  ImGui::BeginChild("recommendation", size);
  const std::optional<size_t> best = tuner.recommended();
  const TuneRow& first = tuner.state.rows.front();
  if (!first.measured()) {
    emptyState(("The frame's own setting could not be measured: " + first.refusal).c_str());
  } else if (!best) {
    emptyState("No run is within both limits. Raise one of them.");
    drawLimits(tuner);
  } else {
    const TuneRow& row = tuner.state.rows[*best];
    ImGui::PushFont(windowFonts().sansLarge);
    ImGui::TextWrapped("%s%s, capacity %u", cellsText(row).c_str(), row.grid.cellEdge > 0.0f ? "" : " cells", row.grid.capacity);
    ImGui::PopFont();
    ImGui::PushTextWrapPos(0.0f);
    textDim(tuneTitle(row));
    if (*best == 0)
      ImGui::TextUnformatted("The frame's own setting: no run is better within the limits.");
    else
      ImGui::TextUnformatted(sentenceOf(first, row).c_str());
    ImGui::PopTextWrapPos();
    drawFlags(model, row);
    ImGui::Dummy(ImVec2(0.0f, unit(4)));
    drawLimits(tuner);
    ImGui::Dummy(ImVec2(0.0f, unit(4)));
    drawComparison(first, row);
    ImGui::Dummy(ImVec2(0.0f, unit(4)));
    drawNoMoreMemory(model, tuner);
    ImGui::Dummy(ImVec2(0.0f, unit(4)));
    drawHowMeasured(tuner);
  }
  ImGui::EndChild();
}

}  // namespace gridscope
