// Verdicts, demand, ledger and proof: what is counted adds up, and what is judged is judged by the rules of shaders/shared/truth.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "tests/lesson.h"
#include "tests/truth_scene.h"

namespace gridscope {
namespace {

Hit hitAt(uint32_t kind, float t) { return {kind, t, kind == kHitMiss ? kBlank : 7u, 0.0f, 0.0f}; }

TEST(Verdict, FollowsTheDistanceToTheExactHit) {
  GridParameters grid{};
  grid.cellEdge = 2.0f;
  const Hit miss = hitAt(kHitMiss, 0.0f), surface = hitAt(kHitTriangle, 10.0f);
  EXPECT_EQ(judge(miss, miss, grid), kVerdictAgrees);
  EXPECT_EQ(judge(miss, surface, grid), kVerdictHole);
  EXPECT_EQ(judge(hitAt(kHitLimit, 0.0f), surface, grid), kVerdictHole);
  EXPECT_EQ(judge(hitAt(kHitTriangle, 10.0019f), surface, grid), kVerdictAgrees);  // less than 1e-3 of an edge of 2
  EXPECT_EQ(judge(hitAt(kHitTriangle, 10.0021f), surface, grid), kVerdictTooFar);
  EXPECT_EQ(judge(hitAt(kHitTriangle, 9.9979f), surface, grid), kVerdictTooNear);
  EXPECT_EQ(judge(surface, miss, grid), kVerdictTooNear);
  EXPECT_EQ(judge(hitAt(kHitVoxel, 10.0f + 3.46f), surface, grid), kVerdictVoxelRight);  // the diagonal of an edge of 2 is 3.464
  EXPECT_EQ(judge(hitAt(kHitVoxel, 10.0f + 3.47f), surface, grid), kVerdictVoxelWrong);
  EXPECT_EQ(judge(hitAt(kHitVoxel, 10.0f), miss, grid), kVerdictVoxelWrong);
  EXPECT_EQ(judge(hitAt(kHitNoRay, 0.0f), hitAt(kHitNoRay, 0.0f), grid), kVerdictNoRay);
}

TEST(Verdict, NamesAreDistinctAndCauseNamesAreThoseOfTheCommandLine) {
  std::set<std::string_view> keys;
  for (uint32_t cause = 0; cause < kCauseCount; ++cause) keys.insert(causeName(cause).key);
  for (uint32_t verdict = 0; verdict < kVerdictCount; ++verdict) keys.insert(verdictName(verdict).key);
  EXPECT_EQ(keys.size(), size_t(kCauseCount + kVerdictCount));
  EXPECT_EQ(causeName(kCauseSteppedOver).key, "steppedOver");
  EXPECT_EQ(verdictName(kVerdictVoxelRight).key, "voxelRight");
}

// The hall's diverse little sister: a lesson with a full cell, its rays from random places towards its middle.
TruthScene lessonScene(std::string_view name, uint32_t insertion = kInsertionSorted) {
  const BuiltInScene& lesson = findBuiltInScene(name);
  TruthScene scene{.scene = lesson.make()};
  const FrameSettings settings = lessonSettings(lesson, scene.scene, 64, 36);
  scene.grid = settings.grid;
  scene.grid.insertion = insertion;
  scene.trace = settings.trace;
  const Bounds bounds = sceneBounds(scene.scene);
  std::mt19937 random(21);
  for (uint32_t i = 0; i < 4000; ++i) {
    const vec3 origin = bounds.low + (bounds.high - bounds.low) * randomPoint(random, 0.02f, 0.98f);
    const vec3 target = vec3(-0.12f, 0.6f, 0.12f) + randomPoint(random, -0.3f, 0.3f);
    scene.rays.push_back(makeRay(origin, target - origin, glm::normalize(target - origin)));
  }
  return scene;
}

TEST(Demand, StoredAndRefusedTogetherAreWhatACellWants) {
  for (uint32_t overlap : {kOverlapPlane, kOverlapExact}) {
    Scene scene = makeBuiltInScene("saturated-cell");
    GridSettings settings{.cells = 24, .capacity = 8, .overlap = overlap};
    placeMesh(scene, addMesh(scene, meshOf(randomTriangles(200, 1.0f, 0.4f, 31))), vec3(0.0f, 0.5f, 0.0f), true);
    const BuiltScene built(scene, settings);
    const Demand demand(built.grid.parameters, built.numbered, built.worldTriangles);
    EXPECT_EQ(demand.total(), uint64_t(built.staticReport.tried) + built.dynamicReport.tried);
    uint64_t refusedTotal = 0;
    forEachCell(built.grid.parameters, [&](ivec3 cell) {
      std::vector<uint32_t> together = storedIn(built.grid, cell);
      const std::vector<uint32_t> refused = refusedBy(built.grid, demand, cell);
      refusedTotal += refused.size();
      EXPECT_EQ(refused.size(), size_t(built.grid.at(gridRefusedTexel(built.grid.parameters, cell, false)) +
                                       built.grid.at(gridRefusedTexel(built.grid.parameters, cell, true))));
      together.insert(together.end(), refused.begin(), refused.end());
      std::ranges::sort(together);
      EXPECT_TRUE(std::ranges::equal(together, demand.wanted(cell)));
    });
    EXPECT_GT(refusedTotal, 0u);
  }
}

TEST(Demand, WantsNothingOutsideTheGridAndNothingWhenEmpty) {
  const BuiltScene built(sceneOf(randomTriangles(20, 1.0f, 0.5f, 32)), {.cells = 8});
  const Demand demand(built.grid.parameters, built.numbered, built.worldTriangles);
  EXPECT_TRUE(demand.wanted(ivec3(-1, 0, 0)).empty());
  EXPECT_TRUE(demand.wanted(built.grid.parameters.cellCount).empty());
  EXPECT_TRUE(storedIn(built.grid, ivec3(-1)).empty());
  EXPECT_FALSE(Demand().wants(ivec3(0), 0));
}

void expectSumsOfLedger(const ToldScene& told) {
  const Ledger ledger = makeLedger(told.input(), told.truths);
  uint64_t tried = 0, stored = 0, cellRays = 0;
  uint64_t triangleStored = 0, triangleLost = 0, triangleRays = 0, meshRays = 0, meshLost = 0, verdicts = 0;
  for (const CellLoss& cell : ledger.cells) tried += cell.tried, stored += cell.stored, cellRays += cell.rays;
  for (const TriangleLoss& triangle : ledger.triangles)
    triangleStored += triangle.stored, triangleLost += triangle.lost, triangleRays += triangle.rays;
  for (const GroupLoss& mesh : ledger.meshes) {
    meshRays += mesh.rays, meshLost += mesh.lost;
    verdicts += std::accumulate(mesh.verdicts.begin(), mesh.verdicts.end(), uint64_t{0});
  }
  EXPECT_EQ(tried, told.demand.total());
  EXPECT_EQ(stored, triangleStored);
  EXPECT_EQ(tried - stored, triangleLost);
  EXPECT_EQ(meshLost, triangleLost);
  EXPECT_EQ(triangleRays, told.totals.differ());
  EXPECT_EQ(meshRays, told.totals.differ());
  EXPECT_EQ(verdicts, told.totals.differ());
  uint64_t inCells = 0;
  for (const RayTruth& truth : told.truths)
    inCells += truth.cause != kCauseNone && gridContains(told.built.grid.parameters, truth.cell) ? 1 : 0;
  EXPECT_LE(cellRays, inCells);
  const std::vector<size_t> worst = worstOf(ledger.triangles, 5);
  for (size_t i = 1; i < worst.size(); ++i) EXPECT_GE(ledger.triangles[worst[i - 1]].rays, ledger.triangles[worst[i]].rays);
}

TEST(Truth, EveryCauseOfALessonIsConfirmedAndTheCountsAddUp) {
  for (uint32_t insertion : {kInsertionSorted, kInsertionFirstCome})
    for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
      TruthScene scene = lessonScene("saturated-cell", insertion);
      scene.trace.traversal = traversal;
      const ToldScene told(scene);
      const TruthTotals& totals = told.totals;
      EXPECT_EQ(totals.rays, told.rays.size());
      EXPECT_EQ(totals.agreeHit + totals.agreeMiss + totals.differ(), totals.rays);
      EXPECT_EQ(std::accumulate(totals.causes.begin(), totals.causes.end(), uint64_t{0}), totals.differ());
      EXPECT_GT(totals.causes[kCauseRefused], 0u);
      EXPECT_EQ(totals.causes[kCauseNotInserted], 0u);
      EXPECT_EQ(totals.causes[kCauseNumeric], 0u);
      const ProofTotals::Count proven = told.proofs().sum();
      EXPECT_EQ(proven.total, totals.differ());
      EXPECT_EQ(proven.alone + proven.chain, proven.total);
      EXPECT_LT(proven.controlConfirmed, proven.controlTotal / 2);
      expectSumsOfLedger(told);
    }
}

TEST(Truth, TheLessonsAboutSteppingShowTheirOwnCauses) {
  const ToldScene corner(lessonScene("stepped-corner"));
  EXPECT_GT(corner.totals.causes[kCauseSteppedOver], 0u);
  EXPECT_GT(corner.totals.causes[kCauseSteppedOver], corner.totals.differ() / 2);
  TruthScene scene = lessonScene("revisit");
  const ToldScene revisit(scene);
  EXPECT_GT(revisit.totals.causes[kCauseRevisit], 0u);
  EXPECT_EQ(revisit.proofs().notConfirmed.size(), 0u);
}

TEST(Truth, AProofWithAnotherEventThanTheCauseDoesNotConfirm) {
  const TruthScene scene{.scene = sceneOf({panelAt(5.5f)}), .rays = rayBundle(), .grid = unitCells(8)};
  TruthScene damaged = scene;
  damaged.damage = [](BuiltScene& built) { built.grid = makeEmptyGrid(built.grid.parameters); };
  const ToldScene told(damaged);
  ASSERT_EQ(told.truths[0].cause, kCauseNotInserted);
  RayTruth wrong = told.truths[0];
  wrong.cause = kCauseFilledEarly;
  const Proof proof = proveRay(told.input(), told.rays[0], told.exact[0], wrong);
  ASSERT_FALSE(proof.links.empty());
  EXPECT_EQ(proof.links.size(), 2u);  // the wrong one, then the right one
  wrong.cause = kCauseNumeric;
  const Proof none = proveRay(told.input(), told.rays[0], told.exact[0], wrong);
  EXPECT_EQ(none.links.back().cause, kCauseNotInserted);
}

TEST(Truth, WorkCanBeAbandoned) {
  const ToldScene told({.scene = sceneOf({panelAt(5.5f)}), .rays = rayBundle()});
  EXPECT_TRUE(tellTruth(told.input(), told.reference, told.rays, told.hits, [](float) { return false; }).empty());
  std::vector<RayTruth> wrong = told.truths;
  for (RayTruth& truth : wrong) truth.cause = kCauseNumeric;
  EXPECT_EQ(proveFrame(told.input(), told.reference, told.rays, wrong, [](float) { return false; }).sum().total, 0u);
}

}  // namespace
}  // namespace gridscope
