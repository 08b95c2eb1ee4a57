// What is found out about cells: how often rays ask them, what an update changed, what the order of arrival changes.
#include <gtest/gtest.h>

#include <set>

#include "core/grid/cell_updates.h"
#include "core/pipeline/stability.h"
#include "core/trace/cell_rays.h"
#include "tests/grid_words.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

Scene crowdedScene() {
  Scene scene = emptyScene();
  placeMesh(scene, addMesh(scene, meshOf(randomTriangles(200, 1.0f, 0.3f, 3))));
  placeMesh(scene, addMesh(scene, meshOf(randomTriangles(20, 0.3f, 0.2f, 4))), vec3(0.0f), true);
  return scene;
}

TEST(CellRays, AreTheRaysThatAskACellEachOnce) {
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
    const BuiltScene built(crowdedScene(), {.cells = 12, .capacity = 4});
    const TraceInput input = built.traceInput({.traversal = traversal});
    std::mt19937 random(5);
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) rays.push_back(makeRay(randomPoint(random, -1.5f, 1.5f), randomDirection(random)));
    rays[3].valid = 0;

    std::vector<CellRays> expected(cellCountOf(built.grid.parameters));
    uint64_t reads = 0;
    for (const Ray& ray : rays) {
      std::set<size_t> asked;
      for (const StepRecord& step : recordRay(input, ray).steps) {
        if (step.outcome != kStepRead && step.outcome != kStepEmpty) continue;
        const size_t cell = cellNumber(built.grid.parameters, step.cell);
        if (!asked.insert(cell).second) continue;
        if (step.outcome == kStepRead)
          ++expected[cell].read, ++reads;
        else
          ++expected[cell].empty;
      }
    }
    const std::vector<CellRays> counted = countCellRays(input, rays);
    ASSERT_EQ(counted.size(), expected.size());
    for (size_t i = 0; i < counted.size(); ++i) {
      ASSERT_EQ(counted[i].read, expected[i].read) << "cell " << i;
      ASSERT_EQ(counted[i].empty, expected[i].empty) << "cell " << i;
    }
    EXPECT_GT(reads, 0u);
  }
}

TEST(CellUpdates, NameTheInstanceAndCountWhatLeftCameAndStayed) {
  BuiltScene built(crowdedScene(), {.cells = 12, .capacity = 32});
  const Grid before = built.grid;
  built.numbered.instances[1].row0.w += 0.25f;
  updateAll(built.numbered, built.worldTriangles, built.grid);
  uint64_t cleared = 0, filled = 0, kept = 0, untouched = 0;
  for (const CellUpdate& update : compareUpdate(before, built.grid)) {
    cleared += update.cleared, filled += update.filled, kept += update.kept;
    const bool touched = update.cleared + update.filled + update.kept > 0;
    EXPECT_EQ(update.instance, touched ? 1u : kNoReference);
    untouched += !touched;
  }
  EXPECT_EQ(cleared + kept, countGrid(before).statistics.dynamicStored);
  EXPECT_EQ(filled + kept, countGrid(built.grid).statistics.dynamicStored);
  EXPECT_GT(cleared, 0u);
  EXPECT_GT(filled, 0u);
  EXPECT_GT(kept, 0u);
  EXPECT_GT(untouched, 0u);
}

// A cell that holds at least two references.
ivec3 fullerCell(const Grid& grid) {
  ivec3 found(-1);
  forEachCell(grid.parameters, [&](const ivec3& cell) {
    if (storedReferences(grid, cell).size() >= 2) found = cell;
  });
  return found;
}

TEST(Stability, TellsOrderFromSetAndCountsRaysThatChange) {
  const BuiltScene built(crowdedScene(), {.cells = 12, .capacity = 4});
  const GridParameters& parameters = built.grid.parameters;
  const ivec3 cell = fullerCell(built.grid);
  const std::vector<Hit> hits(3, Hit{.kind = kHitTriangle, .t = 1.0f, .reference = 0});
  BuildComparison comparison;
  comparison.add(built.grid, hits);
  comparison.add(built.grid, hits);
  EXPECT_EQ(comparison.result().setDiffers + comparison.result().orderDiffers + comparison.result().raysChange, 0u);

  Grid swapped = built.grid;
  std::swap(slotAt(swapped, cell, 0), slotAt(swapped, cell, 1));
  std::vector<Hit> farther = hits;
  farther[1].t = 1.0000001f;
  comparison.add(swapped, farther);
  Stability found = comparison.result();
  EXPECT_EQ(found.orderDiffers, 1u);
  EXPECT_EQ(found.setDiffers, 0u);
  EXPECT_EQ(found.cells[cellNumber(parameters, cell)], kStableSet);
  EXPECT_EQ(found.rays, (std::vector<uint32_t>{0, 1, 0}));

  // A set that once differed stays so, whatever comes later.
  Grid other = built.grid;
  slotAt(other, cell, 0) = makeReference(0, 199);
  comparison.add(other, hits);
  comparison.add(swapped, hits);
  found = comparison.result();
  EXPECT_EQ(found.builds, 5u);
  EXPECT_EQ(found.setDiffers, 1u);
  EXPECT_EQ(found.orderDiffers, 0u);
  EXPECT_EQ(found.raysChange, 1u);
  EXPECT_EQ(found.occupied, countGrid(built.grid).statistics.occupied);
}

}  // namespace
}  // namespace gridscope
