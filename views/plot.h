// Plots: points over two axes, and histograms. A plot is data; its drawing is one value for SVG and for pixels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "views/drawing.h"

namespace gridscope {

struct PlotSize {
  uint32_t width = 560;  // pixels
  uint32_t height = 340;
};

// From `low` to `high`; an axis that is empty or not finite is widened to one that can be drawn.
struct PlotAxis {
  std::string title;  // with the unit
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;  // then low > 0
};

// Where an axis has ticks and what stands there: rising, inside the axis; at most `most`.
struct PlotTick {
  double value;
  std::string text;
};
std::vector<PlotTick> axisTicks(const PlotAxis& axis, int most);

// The axis as it is drawn: finite, low < high, positive when logarithmic.
PlotAxis drawableAxis(PlotAxis axis);

struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
  MarkShape shape = MarkShape::circle;
  uint32_t colour = 0;
  float opacity = 1.0f;
  std::string title;  // when the mouse rests on it
};

// A point that is named in the plot, with a ring around it.
struct PlotNote {
  double x = 0.0;
  double y = 0.0;
  std::string name;
  std::string about;  // below the name, smaller
  uint32_t colour = 0;
};

struct PlotKey {
  std::string words;
  MarkShape shape = MarkShape::circle;
  uint32_t colour = 0;
};

struct ScatterPlot {
  std::string title;
  PlotAxis x;
  PlotAxis y;
  std::vector<PlotPoint> points;  // what is not finite is left out
  std::vector<size_t> front;      // into points, by rising x: joined by a staircase
  std::vector<PlotNote> notes;
  std::vector<PlotKey> keys;
};
Drawing drawScatter(const ScatterPlot& plot, PlotSize size = {});

struct HistogramPlot {
  std::string title;
  std::string xTitle;
  std::string yTitle;            // what is counted; heights are logarithmic
  std::vector<uint64_t> counts;  // of the bins
  double first = 0.0;            // value at which the first bin begins
  double binWidth = 1.0;         // in values
  uint32_t colour = 0;
  size_t markedFrom = SIZE_MAX;  // bins from here on have `markedColour`
  uint32_t markedColour = 0;
  std::string markedWords;  // what they are; said in the plot
};
Drawing drawHistogram(const HistogramPlot& plot, PlotSize size = {});

// A histogram of whole numbers with at most `mostBins` bins of equal width, a round number of values each.
HistogramPlot histogramOf(const std::vector<uint32_t>& values, size_t mostBins);

}  // namespace gridscope
