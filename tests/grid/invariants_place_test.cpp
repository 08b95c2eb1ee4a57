// Where triangles must be: a built grid passes, and each kind of damage is found and named.
#include "core/grid/invariants_place.h"

#include <gtest/gtest.h>

#include "core/trace/invariants_rays.h"
#include "tests/grid_words.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

// Many triangles in few cells, of which a third moves.
struct Crowd {
  Scene scene = emptyScene();
  GridSettings settings;
  Crowd(uint32_t capacity, uint32_t insertion) {
    placeMesh(scene, addMesh(scene, meshOf(randomTriangles(200, 1.0f, 0.4f, 7))));
    placeMesh(scene, addMesh(scene, meshOf(randomTriangles(100, 1.0f, 0.4f, 8))), vec3(0.0f), true);
    settings.cells = 6;
    settings.capacity = capacity;
    settings.insertion = insertion;
  }
};

Demand demandOf(const BuiltScene& built) { return Demand(built.grid.parameters, built.numbered, built.worldTriangles); }

TEST(Placement, HoldsAfterBuildAndUpdateForEveryInsertionFullOrNot) {
  for (uint32_t capacity : {4u, 16u, 512u})
    for (uint32_t insertion : {kInsertionSorted, kInsertionFirstCome}) {
      const Crowd crowd(capacity, insertion);
      BuiltScene built(crowd.scene, crowd.settings);
      const Demand demand = demandOf(built);
      EXPECT_EQ(testPlacement({built.grid, demand}).fault, "");
      EXPECT_EQ(testStale({built.grid, demand}).fault, "");
      BuildReport report{};
      const Grid statics = buildGrid(built.grid.parameters, built.numbered, built.worldTriangles, report);
      EXPECT_EQ(testPlacement({statics, demand, false}).fault, "");
      EXPECT_EQ(testStale({statics, demand, false}).fault, "");
    }
}

// The first cell with room for one more reference, and one that it holds.
ivec3 cellWithRoom(const Grid& grid, bool dynamic) {
  ivec3 found(-1);
  forEachCell(grid.parameters, [&](const ivec3& cell) {
    const std::vector<uint32_t> held = storedReferences(grid, cell);
    if (held.empty() || int(held.size()) >= grid.parameters.capacity || found.x >= 0) return;
    if ((held.back() >= firstDynamicReference(grid.parameters)) == dynamic) found = cell;
  });
  return found;
}

TEST(Placement, AReferenceThatIsMissingIsNamedWithItsCell) {
  const Crowd crowd(512, kInsertionSorted);
  BuiltScene built(crowd.scene, crowd.settings);
  const ivec3 cell = cellWithRoom(built.grid, true);
  const std::vector<uint32_t> held = storedReferences(built.grid, cell);
  slotAt(built.grid, cell, int(held.size()) - 1) = kBlank;
  const Invariant placed = testPlacement({built.grid, demandOf(built)});
  EXPECT_EQ(placed.count, 1u);
  char expected[128];
  std::snprintf(expected, sizeof expected, "1 cell; the first, (%d, %d, %d), lacks 0x%08X, which overlaps it", cell.x, cell.y, cell.z,
                held.back());
  EXPECT_EQ(placed.fault, expected);
}

TEST(Placement, AReferenceOutOfPlaceIsFoundWhetherStaticOrDynamic) {
  const Crowd crowd(512, kInsertionFirstCome);
  for (bool dynamic : {false, true}) {
    BuiltScene built(crowd.scene, crowd.settings);
    const Demand demand = demandOf(built);
    const ivec3 cell = cellWithRoom(built.grid, dynamic);
    const int slot = int(storedReferences(built.grid, cell).size());
    uint32_t stranger = dynamic ? makeReference(1, 0) : makeReference(0, 0);
    while (demand.wants(cell, stranger)) ++stranger;
    slotAt(built.grid, cell, slot) = stranger;
    EXPECT_EQ(testPlacement({built.grid, demand}).holds(), dynamic);
    EXPECT_EQ(testStale({built.grid, demand}).count, dynamic ? 1u : 0u);
  }
}

TEST(Placement, ADynamicReferenceBeforeTheFirstUpdateIsStale) {
  const Crowd crowd(512, kInsertionSorted);
  const BuiltScene built(crowd.scene, crowd.settings);
  EXPECT_NE(testStale({built.grid, demandOf(built), false}).fault.find("before the first update"), std::string::npos);
}

TEST(Placement, AFullSortedCellMustHoldTheSmallest) {
  const Crowd crowd(4, kInsertionSorted);
  BuiltScene built(crowd.scene, crowd.settings);
  const Demand demand = demandOf(built);
  bool done = false;
  forEachCell(built.grid.parameters, [&](const ivec3& cell) {
    if (done || demand.wanted(cell).size() < 6) return;
    slotAt(built.grid, cell, 3) = demand.wanted(cell)[4];
    done = true;
  });
  ASSERT_TRUE(done);
  EXPECT_EQ(testPlacement({built.grid, demand}).count, 1u);
  built.grid.parameters.insertion = kInsertionFirstCome;
  EXPECT_TRUE(testPlacement({built.grid, demand}).holds()) << "first come may keep any of them";
}

TEST(CellInvariants, SayWhatDoesNotApplyToAGridThatDoesNotCount) {
  const Crowd crowd(4, kInsertionSorted);
  BuiltScene built(crowd.scene, crowd.settings);
  const uint64_t tried = uint64_t(built.staticReport.tried) + built.dynamicReport.tried, wrong = tried + 1;
  for (const Invariant& invariant : testCells(built.grid, built.numbered, &tried))
    EXPECT_TRUE(invariant.holds() && invariant.whyNot.empty()) << invariant.key;
  EXPECT_FALSE(testCells(built.grid, built.numbered, &wrong).back().holds());
  EXPECT_EQ(testCells(built.grid, built.numbered, nullptr).back().whyNot, "nobody counted what was tried");
  built.grid.parameters.reserved = 1;
  EXPECT_EQ(testCells(built.grid, built.numbered, &tried).back().whyNot, "the grid does not count what it refuses");
}

TEST(RayInvariants, FindRaysWithoutAReasonAndHitsOfNothing) {
  const Crowd crowd(16, kInsertionSorted);
  const BuiltScene built(crowd.scene, crowd.settings);
  std::vector<Ray> rays(3, makeRay(vec3(-2.0f, 0.1f, 0.1f), vec3(1.0f, 0.0f, 0.0f)));
  rays[2].valid = 0;
  std::vector<Hit> hits(3);
  const TraceInput input = built.traceInput({});
  traceRays(input, rays, hits, {});
  EXPECT_EQ(testEnds(rays, hits).fault, "");
  EXPECT_EQ(testHits(built.numbered, input.parameters, hits).fault, "");
  EXPECT_TRUE(testGridKept(built.grid, built.grid).holds());
  hits[1].kind = kHitCut;
  EXPECT_EQ(testEnds(rays, hits).fault, "1 rays ended without a reason; the first is ray 1");
  hits[0] = {.kind = kHitTriangle, .t = 1.0f, .reference = makeReference(7, 0)};
  EXPECT_EQ(testHits(built.numbered, input.parameters, hits).count, 1u);
}

}  // namespace
}  // namespace gridscope
