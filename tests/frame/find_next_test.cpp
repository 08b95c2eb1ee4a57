// Where the jumps lead.
#include "app/frame/find_next.h"

#include <gtest/gtest.h>

#include "tests/frame/small_frame.h"
#include "tests/grid_words.h"

namespace gridscope {
namespace {

using Pixels = std::vector<uint32_t>;

TEST(FindNext, TheNextHoleGoesAroundAndEndsAtItself) {
  SmallFrame small;
  small.tellTruth();
  EXPECT_EQ(nextHole(small.frame, {}, 3u), 6u);
  EXPECT_EQ(nextHole(small.frame, {}, 6u), 3u);
  EXPECT_EQ(nextVoxelWrong(small.frame, {}, 4u), 4u);
}

TEST(FindNext, BeginsInTheMiddleOfThePicture) {
  SmallFrame small;
  small.tellTruth();
  ASSERT_EQ(nextHole(small.frame, {}, 0u), 3u) << "the first of the picture";
  EXPECT_EQ(nextHole(small.frame, {}, std::nullopt), 3u) << "of 4x2 pixels, 6 is the middle, and comes last";
  EXPECT_EQ(nextRay(small.frame, {}, std::nullopt, {}), 7u);
}

TEST(FindNext, FollowsTheOrderOfTheTable) {
  SmallFrame small;
  small.tellTruth();
  EXPECT_EQ(nextHole(small.frame, Pixels{7, 6, 5, 3}, std::nullopt), 6u);
  EXPECT_EQ(nextHole(small.frame, Pixels{7, 6, 5, 3}, 6u), 3u);
  EXPECT_EQ(nextHole(small.frame, Pixels{7, 6, 5, 3}, 1u), 6u);
  EXPECT_EQ(nextHole(small.frame, Pixels{7, 5}, 7u), std::nullopt);
}

TEST(FindNext, FindsACauseAndAKindOfHit) {
  SmallFrame small;
  EXPECT_EQ(nextRay(small.frame, {}, 0u, {.cause = kCauseRefused}), std::nullopt) << "the truth has not been told";
  EXPECT_EQ(nextRay(small.frame, {}, 0u, {.kind = kHitVoxel}), 4u);
  small.tellTruth();
  EXPECT_EQ(nextRay(small.frame, {}, 4u, {.cause = kCauseRefused}), 6u);
  EXPECT_EQ(nextRay(small.frame, {}, 0u, {.verdict = kVerdictHole, .cause = kCauseRefused}), 6u);
  EXPECT_EQ(nextRay(small.frame, {}, 0u, {.cause = kCauseAlpha}), std::nullopt);
}

TEST(FindNext, NeighboursLeaveOutPixelsWithoutARay) {
  const SmallFrame small;
  EXPECT_EQ(neighbourRay(small.frame, {}, 7u, 1), 1u);
  EXPECT_EQ(neighbourRay(small.frame, {}, 1u, -1), 7u);
  EXPECT_EQ(neighbourRay(small.frame, Pixels{5, 2, 0, 4}, 2u, 1), 4u);
  EXPECT_EQ(neighbourRay(small.frame, Pixels{5, 2, 0, 4}, 2u, 2), 5u);
  EXPECT_EQ(neighbourRay(small.frame, {}, std::nullopt, 1), 1u);
  EXPECT_EQ(neighbourRay(FrameSnapshot{}, {}, 3u, 1), std::nullopt);
}

TEST(FindNext, FullCellsComeByFallingDemand) {
  Grid grid = makeEmptyGrid({.cellEdge = 1.0f,
                             .cellCount = ivec3(3, 1, 1),
                             .inverseCellEdge = 1.0f,
                             .capacity = 2,
                             .reserved = 2,
                             .stride = 4,
                             .stretchAxis = 1});
  EXPECT_EQ(nextFullCell(occupiedCells(grid), {}), std::nullopt);
  const auto fill = [&](int x, int stored, uint32_t refused) {
    for (int slot = 0; slot < stored; ++slot) slotAt(grid, ivec3(x, 0, 0), slot) = uint32_t(slot);
    refusedAt(grid, ivec3(x, 0, 0), false) = refused;
  };
  fill(0, 1, 0);
  EXPECT_EQ(nextFullCell(occupiedCells(grid), {}), ivec3(0, 0, 0)) << "nothing is saturated: the fullest";
  fill(1, 2, 3), fill(2, 2, 9);
  EXPECT_EQ(nextFullCell(occupiedCells(grid), {}), ivec3(2, 0, 0));
  EXPECT_EQ(nextFullCell(occupiedCells(grid), ivec3(2, 0, 0)), ivec3(1, 0, 0));
  EXPECT_EQ(nextFullCell(occupiedCells(grid), ivec3(1, 0, 0)), ivec3(2, 0, 0));
  EXPECT_EQ(nextFullCell(occupiedCells(grid), ivec3(0, 0, 0)), ivec3(2, 0, 0));
  EXPECT_EQ(cellFacts(grid, ivec3(1, 0, 0)).tried(), 5u);
}

TEST(FindNext, AFlagAloneCountsAsOneRefusedAndWithoutReservedTexelsAFullCellIsSaturated) {
  Grid flagged = makeEmptyGrid({.cellCount = ivec3(1), .capacity = 1, .reserved = 1, .stride = 2, .stretchAxis = 0});
  flagged.words = {5, 77};
  EXPECT_EQ(cellFacts(flagged, ivec3(0)).refused, 1u);
  Grid plain = makeEmptyGrid({.cellCount = ivec3(1), .capacity = 1, .reserved = 0, .stride = 1, .stretchAxis = 0});
  EXPECT_FALSE(cellFacts(plain, ivec3(0)).saturated);
  plain.words = {5};
  EXPECT_TRUE(cellFacts(plain, ivec3(0)).saturated);
}

}  // namespace
}  // namespace gridscope
