// See tune_plot.h.
#include "views/tune_plot.h"

#include <algorithm>
#include <cmath>

#include "core/tune/choice.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {
namespace {

constexpr double kBytesPerMebibyte = 1024.0 * 1024.0;

using Amount = double (*)(const TuneRow& row);

double mebibytesOf(const TuneRow& row) { return memoryOf(row) / kBytesPerMebibyte; }
double wrongPercent(const TuneRow& row) { return row.rays == 0 ? 0.0 : 100.0 * double(row.wrong()) / double(row.rays); }

// Capacities as steps of the map, from its blue to its yellow.
uint32_t capacityColour(const std::vector<uint32_t>& capacities, uint32_t capacity) {
  const size_t place = size_t(std::ranges::lower_bound(capacities, capacity) - capacities.begin());
  const float share = capacities.size() < 2 ? 0.5f : float(place) / float(capacities.size() - 1);
  const uint32_t bytes = packBytes(colourMap(kColourMapViridis, 0.2f + 0.8f * share));
  return (bytes & 255u) << 16 | (bytes & 0xFF00u) | bytes >> 16;  // packBytes() has red lowest
}

std::vector<uint32_t> capacitiesOf(const TuneResult& result) {
  std::vector<uint32_t> capacities;
  for (const TuneRow& row : result.rows) capacities.push_back(row.grid.capacity);
  std::ranges::sort(capacities);
  capacities.erase(std::unique(capacities.begin(), capacities.end()), capacities.end());
  return capacities;
}

MarkShape shapeOf(const TuneRow& row) { return row.grid.overlap == kOverlapExact ? MarkShape::square : MarkShape::circle; }

PlotNote noteOf(const TuneRow& row, Amount amountOf, const char* name, uint32_t colour) {
  const std::string about = (row.grid.cellEdge > 0.0f ? std::string("edge") : std::to_string(row.grid.cells)) + " \xC2\xB7 " +
                            std::to_string(row.grid.capacity) + " \xC2\xB7 " + (row.grid.overlap == kOverlapExact ? "exact" : "plane") +
                            " \xC2\xB7 " + (row.grid.numberBy == NumberBy::area ? "area" : "file") +
                            (row.trace.traversal == kTraversalDda ? " \xC2\xB7 dda" : "");
  return {amountOf(row), wrongPercent(row), name, about, colour};
}

// To the next whole step of a tenth to a fifth of the value: 48.4 to 50.
double roundUp(double value) {
  if (!(value > 0.0)) return 1.0;
  const double step = 0.5 * std::pow(10.0, std::floor(std::log10(value)));
  return step * std::ceil(value / step);
}

PlotAxis rangeOf(std::string title, const std::vector<TuneRow>& rows, Amount amountOf, bool logarithmic) {
  PlotAxis axis{std::move(title), INFINITY, -INFINITY, logarithmic};
  for (const TuneRow& row : rows) {
    if (!row.measured()) continue;
    axis.low = std::min(axis.low, amountOf(row));
    axis.high = std::max(axis.high, amountOf(row));
  }
  if (logarithmic)
    axis.low *= 0.9, axis.high *= 1.1;
  else
    axis.low = 0.0, axis.high = roundUp(axis.high);
  return axis;
}

ScatterPlot plotAgainst(const TuneResult& result, std::string title, std::string xTitle, Amount amountOf) {
  ScatterPlot plot{.title = std::move(title)};
  plot.x = rangeOf(std::move(xTitle), result.rows, amountOf, true);
  plot.y = rangeOf("wrong rays, %", result.rows, wrongPercent, false);

  const std::vector<uint32_t> capacities = capacitiesOf(result);
  const std::vector<size_t> front = frontAgainst(result.rows, amountOf);
  std::vector<size_t> pointOf(result.rows.size(), 0);
  for (size_t i = 0; i < result.rows.size(); ++i) {
    const TuneRow& row = result.rows[i];
    if (!row.measured()) continue;
    pointOf[i] = plot.points.size();
    const bool onFront = std::ranges::find(front, i) != front.end();
    plot.points.push_back({amountOf(row), wrongPercent(row), shapeOf(row), capacityColour(capacities, row.grid.capacity),
                           onFront ? 1.0f : 0.55f, tuneTitle(row)});
  }
  for (size_t i : front) plot.front.push_back(pointOf[i]);

  if (!result.rows.empty() && result.rows[0].measured()) plot.notes.push_back(noteOf(result.rows[0], amountOf, "Now", kColourDim));
  if (result.recommended != 0) plot.notes.push_back(noteOf(result.rows[result.recommended], amountOf, "Recommended", kColourTriangleHit));
  for (uint32_t capacity : capacities)
    plot.keys.push_back({std::to_string(capacity), MarkShape::circle, capacityColour(capacities, capacity)});
  if (!plot.keys.empty()) plot.keys.front().words = "capacity " + plot.keys.front().words;
  plot.keys.push_back({"plane", MarkShape::circle, kColourDim});
  plot.keys.push_back({"exact", MarkShape::square, kColourDim});
  return plot;
}

}  // namespace

ScatterPlot tuneMemoryPlot(const TuneResult& result) {
  return plotAgainst(result, "Wrong rays against memory", "memory of the grid, MiB", mebibytesOf);
}

ScatterPlot tuneTimePlot(const TuneResult& result) {
  return plotAgainst(result, "Wrong rays against trace time", "trace, ms", traceTimeOf);
}

Drawing drawTune(const TuneResult& result, PlotSize each) {
  const Drawing memory = drawScatter(tuneMemoryPlot(result), each), time = drawScatter(tuneTimePlot(result), each);
  Drawing both{.width = memory.width + time.width,
               .height = memory.height,
               .background = memory.background,
               .title = "Wrong rays of every setting against memory and against trace time"};
  place(both, memory, {});
  place(both, time, {float(memory.width), 0.0f});
  return both;
}

}  // namespace gridscope
