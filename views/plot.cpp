// See plot.h.
#include "views/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "shaders/shared/views/palette.h"
#include "views/legend.h"

namespace gridscope {
namespace {

constexpr TextStyle kTitle{Font::sans, 13.0f, kColourText};
constexpr TextStyle kWords{Font::sans, 12.0f, kColourDim};
constexpr TextStyle kNumber{Font::mono, 11.0f, kColourDim};

// The plot's frame on its drawing, and the way from values to pixels.
class PlotFrame {
 public:
  PlotFrame(Drawing& drawing, const PlotAxis& x, const PlotAxis& y, float top)
      : drawing_(drawing), x_(drawableAxis(x)), y_(drawableAxis(y)), top_(top) {
    left_ = 64.0f;
    right_ = float(drawing.width) - 24.0f;
    bottom_ = float(drawing.height) - 42.0f;
  }

  float left() const { return left_; }
  float right() const { return right_; }
  float top() const { return top_; }
  float bottom() const { return bottom_; }
  float placeX(double value) const { return left_ + float(share(x_, value)) * (right_ - left_); }
  float placeY(double value) const { return bottom_ - float(share(y_, value)) * (bottom_ - top_); }

  // Lines behind the data, numbers and titles at the axes.
  void drawAxes() {
    for (const PlotTick& tick : axisTicks(x_, std::max(2, int((right_ - left_) / 70.0f)))) {
      const float x = placeX(tick.value);
      drawing_.shapes.push_back(DrawnLine{{{x, top_}, {x, bottom_}}, kColourLine, 1.0f, false});
      drawing_.shapes.push_back(DrawnText{tick.text, {x, bottom_ + 16.0f}, kNumber, TextAnchor::middle});
    }
    for (const PlotTick& tick : axisTicks(y_, std::max(2, int((bottom_ - top_) / 36.0f)))) {
      const float y = placeY(tick.value);
      drawing_.shapes.push_back(DrawnLine{{{left_, y}, {right_, y}}, kColourLine, 1.0f, false});
      drawing_.shapes.push_back(DrawnText{tick.text, {left_ - 8.0f, y + 4.0f}, kNumber, TextAnchor::end});
    }
    drawing_.shapes.push_back(DrawnText{x_.title, {0.5f * (left_ + right_), bottom_ + 34.0f}, kWords, TextAnchor::middle});
    if (!y_.title.empty()) drawing_.shapes.push_back(DrawnText{y_.title, {left_, top_ - 8.0f}, kWords, TextAnchor::start});
  }

 private:
  static double share(const PlotAxis& axis, double value) {
    if (axis.logarithmic) return std::clamp(std::log(std::max(value, axis.low) / axis.low) / std::log(axis.high / axis.low), 0.0, 1.0);
    return std::clamp((value - axis.low) / (axis.high - axis.low), 0.0, 1.0);
  }

  Drawing& drawing_;
  PlotAxis x_, y_;
  float left_ = 0.0f, right_ = 0.0f, top_ = 0.0f, bottom_ = 0.0f;
};

Drawing startDrawing(const std::string& title, PlotSize size) {
  Drawing drawing{.width = size.width, .height = size.height, .background = kColourPanel, .title = title};
  drawing.shapes.push_back(DrawnText{title, {14.0f, 22.0f}, kTitle, TextAnchor::start});
  return drawing;
}

// Thousands with commas, as many decimals as a small number needs.
std::string valueText(double value) {
  if (value >= 100.0 || value == std::floor(value)) return tickText(float(value), 1.0f);
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

// 1, 2 and 5 times powers of ten; fewer when that is more than `most`.
std::vector<PlotTick> logarithmicTicks(const PlotAxis& axis, int most) {
  for (const std::vector<double>& steps : {std::vector<double>{1, 2, 5}, {1, 3}, {1}}) {
    std::vector<PlotTick> ticks;
    for (double power = std::floor(std::log10(axis.low)); power <= std::ceil(std::log10(axis.high)); power += 1.0)
      for (double step : steps) {
        const double value = step * std::pow(10.0, power);
        if (value >= axis.low * 0.999 && value <= axis.high * 1.001) ticks.push_back({value, valueText(value)});
      }
    if (int(ticks.size()) <= most) return ticks;
  }
  // Decades alone are too many: every n-th of them.
  std::vector<PlotTick> ticks;
  const double decades = std::log10(axis.high / axis.low), every = std::ceil((decades + 1.0) / most);
  for (double power = std::ceil(std::log10(axis.low)); std::pow(10.0, power) <= axis.high * 1.001; power += every)
    ticks.push_back({std::pow(10.0, power), valueText(std::pow(10.0, power))});
  return ticks;
}

void drawKeys(Drawing& drawing, const std::vector<PlotKey>& keys, float y) {
  float x = 14.0f;
  for (const PlotKey& key : keys) {
    drawing.shapes.push_back(DrawnMark{key.shape, {x + 4.0f, y - 4.0f}, 4.0f, key.colour, 1.0f, ""});
    drawing.shapes.push_back(DrawnText{key.words, {x + 13.0f, y}, kWords, TextAnchor::start});
    x += 13.0f + textWidth(key.words, kWords) + 14.0f;
  }
}

// A ring, and name and words beside it on the side that has room: at the plot's top or bottom, where points are few.
void drawNote(Drawing& drawing, const PlotFrame& frame, const PlotNote& note, bool atTop) {
  const DrawingPoint centre{frame.placeX(note.x), frame.placeY(note.y)};
  drawing.shapes.push_back(DrawnMark{MarkShape::ring, centre, 8.0f, note.colour, 1.0f, note.name + ": " + note.about});
  const TextStyle name{Font::sans, 12.0f, kColourText}, about{Font::mono, 11.0f, kColourDim};
  const float width = std::max(textWidth(note.name, name), textWidth(note.about, about)) + 16.0f;
  const bool toLeft = centre.x + 24.0f + width > frame.right();
  const float x = std::max(frame.left(), toLeft ? centre.x - 24.0f - width : centre.x + 24.0f);
  const float y = atTop ? frame.top() + 4.0f : frame.bottom() - 40.0f;
  drawing.shapes.push_back(DrawnLine{{centre, {toLeft ? x + width : x, y + 18.0f}}, note.colour, 1.0f, false});
  drawing.shapes.push_back(DrawnBox{{x, y}, width, 36.0f, kColourWindow, ""});
  drawing.shapes.push_back(DrawnBox{{x, y}, 3.0f, 36.0f, note.colour, ""});
  drawing.shapes.push_back(DrawnText{note.name, {x + 10.0f, y + 15.0f}, name, TextAnchor::start});
  drawing.shapes.push_back(DrawnText{note.about, {x + 10.0f, y + 29.0f}, about, TextAnchor::start});
}

}  // namespace

PlotAxis drawableAxis(PlotAxis axis) {
  if (!std::isfinite(axis.low)) axis.low = axis.logarithmic ? 1.0 : 0.0;
  if (!std::isfinite(axis.high)) axis.high = axis.low;
  if (axis.logarithmic) {
    axis.low = std::max(axis.low, 1e-6);
    axis.high = std::max(axis.high, axis.low * 1.5);
  } else if (!(axis.high > axis.low)) {
    axis.high = axis.low + std::max(1.0, std::abs(axis.low) * 0.1);
  }
  return axis;
}

std::vector<PlotTick> axisTicks(const PlotAxis& given, int most) {
  const PlotAxis axis = drawableAxis(given);
  if (axis.logarithmic) return logarithmicTicks(axis, std::max(most, 1));
  std::vector<float> values = tickValues(float(axis.low), float(axis.high), std::max(most, 2));
  float step = float(axis.high - axis.low);
  for (size_t i = 1; i < values.size(); ++i) step = std::min(step, values[i] - values[i - 1]);
  std::vector<PlotTick> ticks;
  for (float value : values) ticks.push_back({double(value), tickText(value, step)});
  return ticks;
}

Drawing drawScatter(const ScatterPlot& plot, PlotSize size) {
  Drawing drawing = startDrawing(plot.title, size);
  drawKeys(drawing, plot.keys, 44.0f);
  PlotFrame frame(drawing, plot.x, plot.y, plot.keys.empty() ? 50.0f : 76.0f);
  frame.drawAxes();

  // The front: level to the next point, then down to it.
  DrawnLine stairs{.colour = kColourDim, .width = 1.5f};
  for (size_t i : plot.front) {
    const DrawingPoint place{frame.placeX(plot.points[i].x), frame.placeY(plot.points[i].y)};
    if (!stairs.points.empty()) stairs.points.push_back({place.x, stairs.points.back().y});
    stairs.points.push_back(place);
  }
  if (stairs.points.size() > 1) drawing.shapes.push_back(stairs);

  for (const PlotPoint& point : plot.points)
    if (std::isfinite(point.x) && std::isfinite(point.y))
      drawing.shapes.push_back(
          DrawnMark{point.shape, {frame.placeX(point.x), frame.placeY(point.y)}, 3.5f, point.colour, point.opacity, point.title});
  for (size_t i = 0; i < plot.notes.size(); ++i) drawNote(drawing, frame, plot.notes[i], i % 2 == 0);
  return drawing;
}

Drawing drawHistogram(const HistogramPlot& plot, PlotSize size) {
  Drawing drawing = startDrawing(plot.title, size);
  uint64_t most = 1;
  for (uint64_t count : plot.counts) most = std::max(most, count);
  const double end = plot.first + plot.binWidth * double(std::max<size_t>(plot.counts.size(), 1));
  PlotFrame frame(drawing, {plot.xTitle, plot.first, end, false}, {plot.yTitle, 0.5, double(most) * 1.1, true}, 60.0f);
  frame.drawAxes();
  for (size_t bin = 0; bin < plot.counts.size(); ++bin) {
    if (plot.counts[bin] == 0) continue;
    const double from = plot.first + plot.binWidth * double(bin);
    const float x = frame.placeX(from), width = frame.placeX(from + plot.binWidth) - x, y = frame.placeY(double(plot.counts[bin]));
    const std::string range = plot.binWidth > 1.0 ? valueText(from) + " to " + valueText(from + plot.binWidth - 1.0) : valueText(from);
    drawing.shapes.push_back(DrawnBox{{x + (width > 3.0f ? 0.5f : 0.0f), y},
                                      std::max(width - (width > 3.0f ? 1.0f : 0.0f), 0.75f),
                                      frame.bottom() - y,
                                      bin >= plot.markedFrom ? plot.markedColour : plot.colour,
                                      range + ": " + valueText(double(plot.counts[bin]))});
  }
  if (!plot.markedWords.empty() && plot.markedFrom < plot.counts.size()) {
    drawing.shapes.push_back(DrawnMark{
        MarkShape::square, {frame.right() - textWidth(plot.markedWords, kWords) - 12.0f, 48.0f}, 4.0f, plot.markedColour, 1.0f, ""});
    drawing.shapes.push_back(DrawnText{plot.markedWords, {frame.right(), 52.0f}, kWords, TextAnchor::end});
  }
  return drawing;
}

HistogramPlot histogramOf(const std::vector<uint32_t>& values, size_t mostBins) {
  uint32_t most = 0;
  for (uint32_t value : values) most = std::max(most, value);
  uint64_t width = 1;
  for (int step = 0; uint64_t(most) / width + 1 > mostBins; ++step) width = step % 3 == 1 ? width / 2 * 5 : width * 2;
  HistogramPlot plot{.counts = std::vector<uint64_t>(size_t(most / width) + 1), .binWidth = double(width)};
  for (uint32_t value : values) ++plot.counts[value / width];
  return plot;
}

}  // namespace gridscope
