// Plots and drawings: ticks lie in their axis, nothing that is not finite reaches a file, texts can't become markup.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shaders/shared/views/palette.h"
#include "tests/views/markup_check.h"
#include "views/plot.h"
#include "views/tune_plot.h"

namespace gridscope {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool holdsNonFinite(const std::string& svg) { return svg.find("nan") != std::string::npos || svg.find("inf") != std::string::npos; }

TEST(Plot, TicksRiseAndLieInTheAxis) {
  for (const PlotAxis& axis : {PlotAxis{"", 0.0, 1.0}, PlotAxis{"", 0.0, 48.4}, PlotAxis{"", 3.0, 3.0}, PlotAxis{"", 0.9, 2200.0, true},
                               PlotAxis{"", 1.0, 1.0, true}, PlotAxis{"", 1e-3, 1e9, true}, PlotAxis{"", 61.0, 63.0, true}})
    for (int most : {2, 5, 9}) {
      const PlotAxis drawn = drawableAxis(axis);
      const std::vector<PlotTick> ticks = axisTicks(axis, most);
      EXPECT_LE(int(ticks.size()), most) << axis.low << " to " << axis.high;
      for (size_t i = 0; i < ticks.size(); ++i) {
        EXPECT_GE(ticks[i].value, drawn.low * 0.998);
        EXPECT_LE(ticks[i].value, drawn.high * 1.002);
        EXPECT_FALSE(ticks[i].text.empty());
        if (i > 0) {
          EXPECT_GT(ticks[i].value, ticks[i - 1].value);
        }
      }
    }
}

TEST(Plot, AnAxisThatIsNotFiniteCanBeDrawn) {
  for (bool logarithmic : {false, true})
    for (const PlotAxis& axis :
         {PlotAxis{"", kNaN, kNaN, logarithmic}, PlotAxis{"", kInfinity, -kInfinity, logarithmic}, PlotAxis{"", 5.0, -5.0, logarithmic}}) {
      const PlotAxis drawn = drawableAxis(axis);
      EXPECT_TRUE(std::isfinite(drawn.low) && std::isfinite(drawn.high));
      EXPECT_LT(drawn.low, drawn.high);
    }
}

TEST(Plot, PointsThatAreNotFiniteAreLeftOut) {
  ScatterPlot plot{.title = "points", .x = {"x", 0.0, 1.0}, .y = {"y", 0.0, 1.0}};
  plot.points = {{0.5, 0.5}, {kNaN, 0.5}, {0.5, kInfinity}};
  const Drawing drawing = drawScatter(plot);
  size_t marks = 0;
  for (const DrawnShape& shape : drawing.shapes) marks += std::holds_alternative<DrawnMark>(shape);
  EXPECT_EQ(marks, 1u);
  EXPECT_FALSE(holdsNonFinite(svgOf(drawing)));
}

TEST(Plot, ASweepOfOneSettingAndOneOfNoneCanBeDrawn) {
  TuneResult result;
  EXPECT_EQ(markupFault(svgOf(drawTune(result))), "");
  TuneRow row;
  row.bytes = 1 << 20;
  row.rays = 10;
  row.traceMs = {1.0, 1.0, 1.0};
  result.rows.push_back(row);
  const std::string svg = svgOf(drawTune(result));
  EXPECT_EQ(markupFault(svg), "");
  EXPECT_FALSE(holdsNonFinite(svg));
  EXPECT_NE(svg.find("Now"), std::string::npos);
}

TEST(Plot, AHistogramCountsEveryValueOnce) {
  std::vector<uint32_t> values;
  for (uint32_t i = 0; i < 1000; ++i) values.push_back(i * i % 997);
  for (size_t mostBins : {1u, 7u, 96u, 5000u}) {
    const HistogramPlot plot = histogramOf(values, mostBins);
    EXPECT_LE(plot.counts.size(), mostBins);
    uint64_t sum = 0;
    for (uint64_t count : plot.counts) sum += count;
    EXPECT_EQ(sum, values.size());
  }
  EXPECT_EQ(markupFault(svgOf(drawHistogram(histogramOf({}, 10)))), "");
}

TEST(Drawing, TextsAreEscapedInSvg) {
  Drawing drawing{.width = 10, .height = 10, .title = "</svg><script>"};
  drawing.shapes.push_back(DrawnText{"<b>&\"'\x01\xFF", {1.0f, 1.0f}, {}, TextAnchor::start});
  drawing.shapes.push_back(DrawnBox{{0.0f, 0.0f}, 1.0f, 1.0f, 0, "<i>"});
  const std::string svg = svgOf(drawing, true);
  EXPECT_EQ(svg.find("<script>"), std::string::npos);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_NE(svg.find("&lt;b&gt;&amp;&quot;&#39;\xEF\xBF\xBD\xEF\xBF\xBD"), std::string::npos) << svg;
  EXPECT_EQ(markupFault(svg), "");
}

TEST(Drawing, MarkupKeepsLettersOfEveryLanguage) {
  EXPECT_EQ(markupText("caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8C\xB2"), "caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8C\xB2");
  EXPECT_EQ(markupText("\xC0\xAF"), "\xEF\xBF\xBD\xEF\xBF\xBD");                  // an overlong slash
  EXPECT_EQ(markupText("\xED\xA0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");  // half of a surrogate pair
  EXPECT_EQ(markupText("\xE2\x82"), "\xEF\xBF\xBD\xEF\xBF\xBD");                  // cut short
}

TEST(Drawing, PicturesShowWhatSvgSays) {
  Drawing drawing{.width = 20, .height = 20, .background = 0x000000};
  drawing.shapes.push_back(DrawnBox{{2.0f, 2.0f}, 4.0f, 4.0f, 0xFF0000, ""});
  drawing.shapes.push_back(DrawnMark{MarkShape::circle, {14.0f, 14.0f}, 3.0f, 0x00FF00, 1.0f, ""});
  drawing.shapes.push_back(DrawnLine{{{-50.0f, 10.5f}, {50.0f, 10.5f}}, 0x0000FF, 1.0f, false});  // beyond both sides
  const Picture picture = pictureOf(drawing, 1.0f);
  auto colourAt = [&](uint32_t x, uint32_t y) {
    const uint8_t* pixel = &picture.rgba[(size_t(y) * picture.width + x) * 4];
    return uint32_t(pixel[0]) << 16 | uint32_t(pixel[1]) << 8 | pixel[2];
  };
  EXPECT_EQ(colourAt(3, 3), 0xFF0000u);
  EXPECT_EQ(colourAt(14, 14), 0x00FF00u);
  EXPECT_EQ(colourAt(0, 10), 0x0000FFu);
  EXPECT_EQ(colourAt(19, 19), 0x000000u);
}

}  // namespace
}  // namespace gridscope
