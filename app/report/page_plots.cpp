// The histograms of a report's page; see page_sections.h.
#include <algorithm>

#include "app/report/page_sections.h"
#include "shaders/shared/views/palette.h"
#include "views/plot.h"

namespace gridscope {

namespace {

constexpr PlotSize kSize{.width = 640, .height = 300};
constexpr size_t kMostBins = 96;

std::string plotHtml(const HistogramPlot& plot) { return "<div>" + svgOf(drawHistogram(plot, kSize), true) + "</div>\n"; }

HistogramPlot occupancyPlot(const PageFrame& frame) {
  const std::vector<uint32_t>& histogram = frame.rendered.frames.back().grid.occupancyHistogram;
  HistogramPlot plot{.title = "References that cells hold (cells that hold none left out)",
                     .xTitle = "references in the cell",
                     .yTitle = "cells",
                     .first = 1.0,
                     .colour = kColourTested,
                     .markedColour = kColourSaturated,
                     .markedWords = "full"};
  plot.counts.assign(histogram.begin() + std::min<ptrdiff_t>(1, ptrdiff_t(histogram.size())), histogram.end());
  plot.markedFrom = plot.counts.empty() ? SIZE_MAX : plot.counts.size() - 1;
  return plot;
}

HistogramPlot demandPlot(const PageFrame& frame) {
  std::vector<uint32_t> tried;
  for (const CellLoss& cell : frame.explained.ledger.cells) tried.push_back(cell.tried);
  HistogramPlot plot = histogramOf(tried, kMostBins);
  plot.title = "References that cells were asked to take";
  plot.xTitle = "references tried in the cell";
  plot.yTitle = "cells";
  plot.colour = kColourTested;
  plot.markedFrom = size_t(double(frame.grid.capacity) / plot.binWidth) + 1;
  plot.markedColour = kColourSaturated;
  plot.markedWords = "above the capacity";
  return plot;
}

HistogramPlot counterPlot(const PageFrame& frame, uint32_t RayCounters::*counter, const char* title, const char* xTitle) {
  std::vector<uint32_t> values;
  for (size_t ray = 0; ray < frame.counters.size(); ++ray)
    if (frame.explained.frame.rays[ray].valid) values.push_back(frame.counters[ray].*counter);
  HistogramPlot plot = histogramOf(values, kMostBins);
  plot.title = title;
  plot.xTitle = xTitle;
  plot.yTitle = "rays";
  plot.colour = kColourTriangleHit;
  return plot;
}

}  // namespace

std::string plotsHtml(const PageFrame& frame) {
  return "<p class=\"dim\">Heights are logarithmic. Rest the mouse on a bar for its numbers.</p><div class=\"columns plots\">\n" +
         plotHtml(occupancyPlot(frame)) + plotHtml(demandPlot(frame)) +
         plotHtml(counterPlot(frame, &RayCounters::visits, "Cells that rays visited", "cells visited by the ray")) +
         plotHtml(counterPlot(frame, &RayCounters::tests, "Triangle tests of rays", "tests of the ray")) + "</div>\n";
}

}  // namespace gridscope
