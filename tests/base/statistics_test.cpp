// Statistics of rays, counters, triangles and times.
#include "core/grid/statistics.h"
#include "core/trace/statistics.h"

#include <gtest/gtest.h>

#include <numeric>

namespace gridscope {
namespace {

Hit hitOf(uint32_t kind) {
  Hit hit{};
  hit.kind = kind;
  return hit;
}

TEST(Statistics, ASummaryOfNothingIsZero) {
  const Summary summary = summarise({});
  EXPECT_EQ(summary.mean, 0.0);
  EXPECT_EQ(summary.p99, 0u);
  EXPECT_EQ(summary.max, 0u);
}

TEST(Statistics, ThePercentileIsAValueThatNinetyNineInAHundredDoNotExceed) {
  std::vector<uint32_t> values(200);
  std::iota(values.rbegin(), values.rend(), 1u);
  const Summary summary = summarise(values);
  EXPECT_DOUBLE_EQ(summary.mean, 100.5);
  EXPECT_EQ(summary.p99, 198u);
  EXPECT_EQ(summary.max, 200u);
  EXPECT_EQ(summarise(std::vector<uint32_t>{7}).p99, 7u);
  EXPECT_EQ(summarise(std::vector<uint32_t>{7, 9}).p99, 9u);
}

TEST(Statistics, SumsBeyond32BitsAreKept) {
  const std::vector<uint32_t> values(4, 0xFFFFFFFFu);
  EXPECT_DOUBLE_EQ(summarise(values).mean, 4294967295.0);
}

TEST(Statistics, PixelsWithoutARayAreNotCounted) {
  const std::vector<Hit> hits = {hitOf(kHitNoRay), hitOf(kHitTriangle), hitOf(kHitVoxel),
                                 hitOf(kHitMiss),  hitOf(kHitLimit),    hitOf(kHitTriangle)};
  const RayTotals totals = countRays(hits);
  EXPECT_EQ(totals.count, 5u);
  EXPECT_EQ(totals.triangleHits, 2u);
  EXPECT_EQ(totals.voxelHits, 1u);
  EXPECT_EQ(totals.misses, 2u);

  const std::vector<RayCounters> counters = {{100, 1000}, {1, 10}, {2, 20}, {3, 30}, {4, 40}, {5, 50}};
  const CounterTotals summaries = summariseCounters(counters, hits);
  EXPECT_DOUBLE_EQ(summaries.visits.mean, 3.0);
  EXPECT_EQ(summaries.visits.max, 5u);
  EXPECT_DOUBLE_EQ(summaries.tests.mean, 30.0);
  EXPECT_EQ(summaries.tests.p99, 50u);
}

TEST(Statistics, TrianglesWithoutAreaAreDegenerateAndNotOutside) {
  GridParameters grid{};
  grid.cellEdge = grid.inverseCellEdge = 1.0f;
  grid.cellCount = ivec3(4, 4, 4);
  const std::vector<Triangle> triangles = {
      {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}},  // inside
      {{1, 1, 1}, {9, 1, 1}, {1, 2, 1}},  // reaches out
      {{9, 9, 9}, {8, 9, 9}, {9, 8, 9}},  // wholly outside
      {{9, 1, 1}, {9, 1, 1}, {9, 2, 1}},  // no area
  };
  const TriangleTotals totals = countTriangles(grid, triangles);
  EXPECT_EQ(totals.degenerate, 1u);
  EXPECT_EQ(totals.outside, 2u);
}

TEST(Statistics, TheMedianOfAnEvenCountLiesBetweenTheMiddleTwo) {
  const Spread even = spreadOf({4.0, 1.0, 3.0, 2.0});
  EXPECT_DOUBLE_EQ(even.min, 1.0);
  EXPECT_DOUBLE_EQ(even.median, 2.5);
  EXPECT_DOUBLE_EQ(even.max, 4.0);
  EXPECT_DOUBLE_EQ(spreadOf({5.0, 9.0, 1.0}).median, 5.0);
  EXPECT_DOUBLE_EQ(spreadOf({}).median, 0.0);
}

}  // namespace
}  // namespace gridscope
