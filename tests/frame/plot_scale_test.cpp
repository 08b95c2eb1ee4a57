// Plots: axes, ticks, histograms and the history of stage times.
#include "app/frame/plot_scale.h"

#include <gtest/gtest.h>

#include <numeric>

#include "app/frame/histogram.h"
#include "app/frame/stage_history.h"
#include "tests/frame/small_frame.h"

namespace gridscope {
namespace {

std::vector<std::string> labels(const PlotScale& scale, int most) {
  std::vector<std::string> texts;
  for (const PlotTick& tick : plotTicks(scale, most)) texts.push_back(tick.text);
  return texts;
}

using Texts = std::vector<std::string>;

TEST(PlotScale, TicksStandAtRoundNumbersAndAreNeverMoreThanAskedFor) {
  EXPECT_EQ(labels({0.0, 64.0}, 5), (Texts{"0", "16", "32", "48", "64"}));
  EXPECT_EQ(labels({0.0, 1.0}, 3), (Texts{"0.0", "0.5", "1.0"}));
  EXPECT_EQ(labels({1.0, 10000.0, true}, 5), (Texts{"1", "10", "100", "1,000", "10,000"}));
  for (const int most : {2, 3, 5, 9})
    for (const double high : {0.3, 1.0, 7.0, 33.0, 463.0, 99999.0}) EXPECT_LE(int(plotTicks({0.0, high}, most).size()), most) << high;
}

TEST(PlotScale, AScaleFromZeroEndsAtARoundNumberAtOrAboveTheHighestValue) {
  EXPECT_DOUBLE_EQ(scaleFromZero(463.0).high, 600.0);
  EXPECT_DOUBLE_EQ(scaleFromZero(0.0).high, 1.0);
  EXPECT_DOUBLE_EQ(scaleFromZero(20.0).high, 20.0);
  EXPECT_DOUBLE_EQ(scaleOfTens(3.0, 200.0).low, 1.0);
  EXPECT_DOUBLE_EQ(scaleOfTens(3.0, 200.0).high, 1000.0);
}

TEST(PlotScale, PlacesAndValuesAreInverse) {
  for (const PlotScale& scale : {PlotScale{0.0, 64.0}, PlotScale{1.0, 3000.0, true}})
    for (const double place : {0.0, 0.25, 1.0}) EXPECT_NEAR(scale.placeOf(scale.valueAt(place)), place, 1e-9);
}

TEST(Histogram, EveryValueIsCountedOnceAndTheLastBarTakesTheRest) {
  const std::vector<uint32_t> values = {1, 1, 2, 5, 64, 1000};
  const Histogram histogram = countValues(values, 64, 65);
  EXPECT_EQ(histogram.width, 1u);
  ASSERT_EQ(histogram.counts.size(), 65u);
  EXPECT_EQ(histogram.counts[1], 2u);
  EXPECT_EQ(histogram.counts[64], 2u);
  EXPECT_TRUE(histogram.lastIsOpen);
  EXPECT_EQ(histogram.most(), 2u);
  const Histogram wide = countValues(values, 1000, 65);
  EXPECT_EQ(wide.width, 16u);
  EXPECT_FALSE(wide.lastIsOpen);
  EXPECT_EQ(std::accumulate(wide.counts.begin(), wide.counts.end(), uint64_t{0}), 6u);
  EXPECT_TRUE(countValues({}, 10, 10).counts.empty());
}

TEST(Histogram, CountsOccupiedCellsAndRays) {
  const SmallFrame small;
  EXPECT_EQ(countedValues(Counted::tried, small.frame), (std::vector<uint32_t>{3, 1}));
  EXPECT_EQ(countedValues(Counted::stored, small.frame), (std::vector<uint32_t>{2, 1}));
  EXPECT_EQ(countedValues(Counted::visits, small.frame), (std::vector<uint32_t>{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_TRUE(countedValues(Counted::tests, FrameSnapshot{}).empty());
  EXPECT_EQ(reachOf({}), 1u);
  EXPECT_EQ(reachOf({3}), 3u);
}

TEST(StageHistory, KeepsEachFinishedFrameOnceAndTheLastTwoHundred) {
  SmallFrame small;
  small.frame.traceNumber = 1;
  StageHistory history;
  history.note(small.frame);
  history.note(small.frame);
  EXPECT_EQ(history.moments().size(), 1u);
  small.frame.traceNumber = 2, small.frame.stale = true;
  history.note(small.frame);
  EXPECT_EQ(history.moments().size(), 1u);
  small.frame.stale = false;
  small.frame.request.settings->grid.capacity = 48;
  history.note(small.frame);
  EXPECT_EQ(history.moments().back().change, "capacity 2 \u2192 48");
  for (small.frame.traceNumber = 3; small.frame.traceNumber < 300; ++small.frame.traceNumber) history.note(small.frame);
  EXPECT_EQ(history.moments().size(), StageHistory::kMost);
  EXPECT_EQ(history.moments().back().change, "");
}

}  // namespace
}  // namespace gridscope
