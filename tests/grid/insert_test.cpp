// Insertion into single cells: sorted insertion against a set, first-come insertion against its promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/grid/slots.h"
#include "shaders/shared/grid/overlap.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

struct TestInsert : SlotWriter {
  using SlotWriter::SlotWriter;
#include "shaders/shared/grid/insert.h"
#include "tests/grid_words.h"
};

// A grid of 3 x 4 x 5 cells, the instances below 100 static.
GridParameters smallGrid(int capacity, int stretchAxis, uint32_t insertion) {
  GridParameters grid{};
  grid.cellCount = ivec3(3, 4, 5);
  grid.capacity = capacity;
  grid.reserved = 2;
  grid.stride = capacity + 2;
  grid.stretchAxis = stretchAxis;
  grid.insertion = insertion;
  grid.staticInstanceCount = 100;
  return grid;
}

std::vector<uint32_t> randomReferences(std::mt19937& random, size_t count) {
  std::set<uint32_t> references;
  while (references.size() < count) references.insert(makeReference(random() % 200, random() % 50));
  std::vector<uint32_t> shuffled(references.begin(), references.end());
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  return shuffled;
}

TEST(Insertion, SortedKeepsTheSmallestInOrderWhateverTheOrderOfArrival) {
  std::mt19937 random(1);
  for (int round = 0; round < 3000; ++round) {
    const int capacity = 1 + int(random() % 40);
    const GridParameters parameters = smallGrid(capacity, int(random() % 3), kInsertionSorted);
    const ivec3 cell(int(random() % 3), int(random() % 4), int(random() % 5));
    const std::vector<uint32_t> arrivals = randomReferences(random, random() % 80);
    Grid grid = makeEmptyGrid(parameters);
    const Grid empty = grid;
    TestInsert insert(grid);
    uint32_t stored = 0, refused = 0;
    for (uint32_t reference : arrivals) {
      const TestInsert::InsertResult result = insert.insertReference(parameters, cell, reference);
      stored += result.stored, refused += result.refused;
      ASSERT_EQ(result.cut, 0u);
    }

    std::vector<uint32_t> expected = arrivals;
    std::sort(expected.begin(), expected.end());
    const size_t kept = std::min(expected.size(), size_t(capacity));
    const auto refusedBegin = expected.begin() + std::ptrdiff_t(kept);
    const auto refusedStatic = std::count_if(refusedBegin, expected.end(), [](uint32_t r) { return r < 100u << 16; });
    EXPECT_EQ(refusedAt(grid, cell, false), uint32_t(refusedStatic));
    EXPECT_EQ(refusedAt(grid, cell, true), uint32_t(expected.end() - refusedBegin - refusedStatic));
    EXPECT_EQ(stored, kept);
    EXPECT_EQ(refused, expected.size() - kept);
    expected.resize(kept);
    ASSERT_EQ(storedReferences(grid, cell), expected);

    // No other texel is touched.
    for (int slot = 0; slot < parameters.stride; ++slot) {
      const ivec3 texel = gridTexel(parameters, cell, slot);
      grid.words[wordOf(parameters, texel)] = empty.words[wordOf(parameters, texel)];
    }
    ASSERT_EQ(grid.words, empty.words);
  }
}

TEST(Insertion, FirstComeKeepsTheFirstInTheirOrder) {
  std::mt19937 random(2);
  for (int round = 0; round < 500; ++round) {
    const GridParameters parameters = smallGrid(1 + int(random() % 20), 0, kInsertionFirstCome);
    std::vector<uint32_t> arrivals = randomReferences(random, random() % 40);
    Grid grid = makeEmptyGrid(parameters);
    TestInsert insert(grid);
    for (uint32_t reference : arrivals) insert.insertReference(parameters, ivec3(1, 2, 3), reference);
    const size_t kept = std::min(arrivals.size(), size_t(parameters.capacity));
    const uint32_t refused = refusedAt(grid, ivec3(1, 2, 3), false) + refusedAt(grid, ivec3(1, 2, 3), true);
    EXPECT_EQ(refused, arrivals.size() - kept);
    arrivals.resize(kept);
    ASSERT_EQ(storedReferences(grid, ivec3(1, 2, 3)), arrivals);
  }
}

TEST(Insertion, AGridWithoutReservedTexelsOnlyReportsRefusals) {
  GridParameters parameters = smallGrid(2, 1, kInsertionSorted);
  parameters.reserved = 0;
  parameters.stride = 2;
  Grid grid = makeEmptyGrid(parameters);
  TestInsert insert(grid);
  for (uint32_t reference : {9u, 7u, 8u}) insert.insertReference(parameters, ivec3(0), reference);
  EXPECT_EQ(storedReferences(grid, ivec3(0)), (std::vector<uint32_t>{7, 8}));
  EXPECT_TRUE(storedReferences(grid, ivec3(0, 1, 0)).empty());
}

TEST(Insertion, AnEmptyGridHasBlankSlotsAndZeroedReservedTexelsOnEveryStretchedAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    const GridParameters parameters = smallGrid(3, axis, kInsertionSorted);
    const Grid grid = makeEmptyGrid(parameters);
    EXPECT_EQ(grid.words.size(), size_t(3 * 4 * 5 * 5));
    forEachCell(parameters, [&](const ivec3& cell) {
      for (int slot = 0; slot < 5; ++slot) EXPECT_EQ(slotAt(grid, cell, slot), slot < 3 ? kBlank : 0u);
    });
  }
}

}  // namespace
}  // namespace gridscope
