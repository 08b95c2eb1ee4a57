// The checker finds each fault that can be planted in a grid, and the totals add up.
#include "core/grid/invariants.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/grid_words.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

// Two static instances and a dynamic one of 10 triangles each; a cell of `grid` to plant a fault in.
class Invariants : public testing::Test {
 protected:
  Invariants() {
    Scene scene = emptyScene();
    const uint32_t mesh = addMesh(scene, meshOf(randomTriangles(10, 1.0f, 0.2f, 1)));
    placeMesh(scene, mesh);
    placeMesh(scene, mesh);
    placeMesh(scene, mesh, vec3(0.0f), true);
    numbered = numberScene(scene, NumberBy::file);
    GridSettings settings;
    settings.cells = 5;
    settings.capacity = 4;
    grid = makeEmptyGrid(deriveGrid(settings, sceneBounds(scene), numbered));
  }

  void fill(const std::vector<uint32_t>& slots, uint32_t staticRefused = 0, uint32_t dynamicRefused = 0) {
    for (int slot = 0; slot < grid.parameters.capacity; ++slot)
      slotAt(grid, cell, slot) = size_t(slot) < slots.size() ? slots[size_t(slot)] : kBlank;
    refusedAt(grid, cell, false) = staticRefused;
    refusedAt(grid, cell, true) = dynamicRefused;
  }

  // Expects one line that says `part` and names the cell.
  void expectFault(const std::string& part, const uint64_t* tried = nullptr) {
    const std::vector<std::string> lines = checkInvariants(grid, numbered, tried);
    ASSERT_EQ(lines.size(), 1u) << part;
    EXPECT_NE(lines[0].find(part), std::string::npos) << lines[0];
    if (tried == nullptr) {
      EXPECT_NE(lines[0].find("(2, 3, 1)"), std::string::npos) << lines[0];
    }
  }
  void expectSound(const uint64_t* tried = nullptr) { EXPECT_EQ(checkInvariants(grid, numbered, tried), std::vector<std::string>{}); }

  const ivec3 cell{2, 3, 1};
  const uint32_t a = makeReference(0, 1), b = makeReference(0, 5), c = makeReference(1, 0), d = makeReference(1, 9),
                 moving = makeReference(2, 3);
  NumberedScene numbered;
  Grid grid;
};

TEST_F(Invariants, HoldInSoundCells) {
  expectSound();
  fill({a, b, c, moving});
  expectSound();
  fill({a, b, c, d}, 3, 2);
  expectSound();
  fill({a, b, c, moving}, 0, 2);
  expectSound();
}

TEST_F(Invariants, ABlankBeforeAReferenceIsFound) {
  fill({a, kBlank, c});
  expectFault("behind a blank");
}

TEST_F(Invariants, FallingReferencesAreFoundInASortedGridAlone) {
  fill({b, a});
  expectFault("do not rise");
  grid.parameters.insertion = kInsertionFirstCome;
  expectSound();
}

TEST_F(Invariants, AStaticReferenceBehindADynamicOneIsFoundInAFirstComeGridToo) {
  grid.parameters.insertion = kInsertionFirstCome;
  fill({moving, a});
  expectFault("static reference behind a dynamic one");
}

TEST_F(Invariants, ADuplicateIsFound) {
  fill({a, a});
  expectFault("twice");
  grid.parameters.insertion = kInsertionFirstCome;
  fill({b, a, b});
  expectFault("twice");
}

TEST_F(Invariants, AReferenceToNothingIsFound) {
  fill({makeReference(0, 10)});
  expectFault("no triangle");
  fill({makeReference(3, 0)});
  expectFault("no triangle");
}

TEST_F(Invariants, ARefusalInACellWithRoomIsFound) {
  fill({a, b, c}, 1, 0);
  expectFault("had room");
  fill({a, b, c}, 0, 1);
  expectFault("had room");
}

TEST_F(Invariants, AStaticRefusalBesideADynamicReferenceIsFound) {
  fill({a, b, c, moving}, 1, 0);
  expectFault("had room");
}

TEST_F(Invariants, AReferenceThatWentMissingIsFoundByTheSum) {
  fill({a, b, c, d}, 1, 2);
  const uint64_t tried = 7, less = 6;
  expectSound(&tried);
  expectFault("tried 6", &less);
}

TEST_F(Invariants, SeveralBrokenCellsMakeOneLineThatCountsThem) {
  fill({b, a});
  slotAt(grid, ivec3(4, 4, 4), 0) = d;
  slotAt(grid, ivec3(4, 4, 4), 1) = c;
  expectFault("2 cells hold references that do not rise");
}

TEST_F(Invariants, TotalsAddUp) {
  fill({a, b, c, moving}, 0, 6);
  const GridTotals totals = countGrid(grid);
  EXPECT_EQ(totals.statistics.staticStored, 3u);
  EXPECT_EQ(totals.statistics.dynamicStored, 1u);
  EXPECT_EQ(totals.statistics.dynamicRefused, 6u);
  EXPECT_EQ(totals.statistics.occupied, 1u);
  EXPECT_EQ(totals.statistics.saturated, 1u);
  EXPECT_EQ(totals.statistics.maxDemand, 10u);
  ASSERT_EQ(totals.occupancyHistogram.size(), 5u);
  EXPECT_EQ(totals.occupancyHistogram[4], 1u);
  const ivec3 cells = grid.parameters.cellCount;
  EXPECT_EQ(std::accumulate(totals.occupancyHistogram.begin(), totals.occupancyHistogram.end(), 0u), uint32_t(cells.x * cells.y * cells.z));
}

TEST_F(Invariants, GridsWithFewerReservedTexelsAreReadAsTheyMeanIt) {
  GridParameters parameters = grid.parameters;
  for (int reserved : {0, 1}) {
    parameters.reserved = reserved;
    parameters.stride = parameters.capacity + reserved;
    grid = makeEmptyGrid(parameters);
    for (int slot = 0; slot < 4; ++slot) slotAt(grid, cell, slot) = uint32_t(slot);
    if (reserved == 1) slotAt(grid, cell, 4) = 1;
    expectSound();
    EXPECT_EQ(countGrid(grid).statistics.saturated, 1u);
    EXPECT_EQ(countGrid(grid).statistics.maxDemand, 4u);
  }
}

}  // namespace
}  // namespace gridscope
