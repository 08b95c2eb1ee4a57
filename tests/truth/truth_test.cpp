// Verdicts, demand, ledger and proof: what is counted adds up, and what is judged is judged by the rules of shaders/shared/truth/truth.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "tests/grid_words.h"
#include "tests/lesson.h"
#include "tests/truth/scene.h"

namespace gridscope {
namespace {

Hit hitAt(uint32_t kind, float t) { return {kind, t, kind == kHitMiss ? kNoReference : 7u, 0.0f, 0.0f}; }

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
  EXPECT_EQ(judge(surface, hitAt(kHitNoRay, 0.0f), grid), kVerdictNoRay);
  EXPECT_EQ(judge(hitAt(kHitNoRay, 0.0f), surface, grid), kVerdictHole);
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
      EXPECT_EQ(refused.size(), size_t(refusedAt(built.grid, cell, false) + refusedAt(built.grid, cell, true)));
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
  uint64_t lostRays = 0;
  for (const GroupLoss& mesh : ledger.meshes) {
    lostRays += mesh.lostRays;
    uint64_t lostThere = 0, raysThere = 0;
    for (const GroupCell& cell : mesh.where) {
      const std::vector<uint32_t> refused = refusedBy(told.built.grid, told.demand, cell.cell);
      EXPECT_GT(cell.lost, 0u);
      EXPECT_LE(cell.lost, refused.size());
      lostThere += cell.lost, raysThere += cell.rays;
    }
    EXPECT_LE(lostThere, mesh.lost);
    EXPECT_LE(raysThere, mesh.lostRays);
    EXPECT_EQ(mesh.where.empty(), mesh.lost == 0);
  }
  EXPECT_EQ(lostRays, told.totals.causes[kCauseRefused] + told.totals.causes[kCauseGate]);
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
      EXPECT_LE(proven.controlConfirmed, proven.controlChained);
      EXPECT_LT(proven.controlChained, proven.controlTotal / 2);
      expectSumsOfLedger(told);
    }
}

TEST(Ledger, AMeshWhoseCellsWereSteppedOverCostsRaysButNoneByLostReferences) {
  const ToldScene told(lessonScene("stepped-corner"));
  for (const GroupLoss& mesh : makeLedger(told.input(), told.truths).meshes) {
    EXPECT_EQ(mesh.lost, 0u);
    EXPECT_EQ(mesh.lostRays, 0u);
    EXPECT_TRUE(mesh.where.empty());
  }
  EXPECT_GT(told.totals.causes[kCauseSteppedOver], 0u);
}

TEST(Ledger, WhereNamesTheCellsThatCostAMeshTheMostRaysFirst) {
  Scene scene = emptyScene();
  placeMesh(scene, addMesh(scene, meshOf(clutterAt(5.0f))));
  placeMesh(scene, addMesh(scene, meshOf({panelAt(5.5f), {vec3(2.1f, 0.1f, 0.5f), vec3(2.9f, 0.1f, 0.5f), vec3(2.5f, 0.9f, 0.5f)}})));
  const ToldScene told({.scene = scene, .rays = rayBundle(), .grid = unitCells(2)});
  const Ledger ledger = makeLedger(told.input(), told.truths);
  EXPECT_TRUE(ledger.meshes[0].where.empty() || ledger.meshes[0].where[0].rays == 0u);
  ASSERT_FALSE(ledger.meshes[1].where.empty());
  EXPECT_EQ(ledger.meshes[1].where[0].cell, told.cellAt(vec3(5.5f, 2.5f, 2.5f)));
  EXPECT_EQ(ledger.meshes[1].where[0].rays, told.rays.size());
  EXPECT_EQ(ledger.meshes[1].where[0].lost, 1u);
  EXPECT_EQ(ledger.meshes[1].lostRays, told.rays.size());
}

TEST(Ledger, ACellWithRoomRefusedNothingWhateverAnotherBuilderPutThere) {
  BuiltScene built(sceneOf({panelAt(5.5f)}), unitCells(2));
  const Demand demand(built.grid.parameters, built.numbered, built.worldTriangles);
  const ivec3 cell = gridCell(built.grid.parameters, vec3(5.5f, 2.5f, 2.5f));
  built.grid = makeEmptyGrid(built.grid.parameters);
  EXPECT_TRUE(demand.wants(cell, makeReference(0, 0)));
  EXPECT_TRUE(refusedBy(built.grid, demand, cell).empty());
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
  EXPECT_TRUE(proveRay(told.input(), told.rays[0], told.hits[0], told.exact[0], told.truths[0]).confirmed);
  for (uint32_t cause : {kCauseFilledEarly, kCauseNumeric, kCauseGate, kCauseAlpha, kCauseSelfHit, kCauseSegmentEnd, kCauseSegmentLimit}) {
    RayTruth wrong = told.truths[0];
    wrong.cause = cause;
    const Proof proof = proveRay(told.input(), told.rays[0], told.hits[0], told.exact[0], wrong);
    EXPECT_FALSE(proof.confirmed) << causeName(cause).title;
    EXPECT_EQ(proof.links.size(), 1u) << causeName(cause).title;
  }
}

TEST(Truth, AnEventThatChangesTheRayButNotItsFirstEventStartsNoChain) {
  // Another triangle, shown in an empty cell before: the ray tests it and misses it, and then differs as before.
  Scene scene = sceneOf({panelAt(5.5f), {vec3(1.1f, 1.1f, 1.1f), vec3(1.1f, 1.9f, 1.1f), vec3(1.1f, 1.1f, 1.9f)}});
  TruthScene damaged{.scene = scene, .rays = rayBundle(), .grid = unitCells(8)};
  damaged.damage = [](BuiltScene& built) { built.grid = makeEmptyGrid(built.grid.parameters); };
  const ToldScene told(damaged);
  RayTruth wrong = told.truths[0];
  wrong.cell = told.cellAt(vec3(3.5f, 2.5f, 2.5f));
  wrong.reference = makeReference(0, 1);
  const Proof proof = proveRay(told.input(), told.rays[0], told.hits[0], told.exact[0], wrong);
  EXPECT_FALSE(proof.confirmed);
  EXPECT_EQ(proof.links.size(), 1u);
}

TEST(Truth, HitsThatAreNoneOfThisTracesProveNothing) {
  // Every hit of the frame is replaced by a miss: no rule makes such a frame.
  TruthScene scene{.scene = sceneOf({panelAt(5.5f)}), .rays = rayBundle(), .grid = unitCells(8)};
  scene.tracedElsewhere = [&scene](BuiltScene&) { return std::vector<Hit>(scene.rays.size(), hitAt(kHitMiss, 0.0f)); };
  const ToldScene told(scene);
  EXPECT_EQ(told.totals.causes[kCauseNumeric], told.rays.size());
  const ProofTotals::Count proven = told.proofs().sum();
  EXPECT_EQ(proven.total, told.rays.size());
  EXPECT_EQ(proven.alone + proven.chain, 0u);
  EXPECT_EQ(proven.controlConfirmed + proven.controlChained, 0u);
}

// The truths of a frame whose hits are a hair off: another device's rounding.
TEST(Truth, HitsOneUlpOffHaveTheCausesAndTheProofsOfTheTracesOwn) {
  for (std::string_view name : {"alpha-leaf", "saturated-cell", "stepped-corner"}) {
    TruthScene scene = lessonScene(name);
    scene.grid.capacity = 4;
    const ToldScene own(scene);
    ASSERT_GT(own.totals.differ(), 0u) << name;
    scene.tracedElsewhere = [&](BuiltScene&) {
      std::vector<Hit> hits = own.hits;
      for (Hit& hit : hits) hit.t = std::nextafter(hit.t, kFar), hit.u += 1e-6f;
      return hits;
    };
    const ToldScene off(scene);
    EXPECT_EQ(off.totals.causes, own.totals.causes) << name;
    EXPECT_EQ(off.totals.causes[kCauseAlpha] + off.totals.causes[kCauseSelfHit], 0u) << name;
    EXPECT_TRUE(off.proofs().notConfirmed.empty()) << name;
  }
}

// A lesson's frame whose hits were made by another rule: every cause is proven, by removing events or by making the hit.
TEST(Truth, ALessonTracedWithoutKeyingOrWithAnotherTMinIsProven) {
  for (float tMin : {1e-3f, 0.2f})
    for (uint32_t threshold : {0u, 128u, 256u}) {
      TruthScene scene = lessonScene("alpha-leaf");
      scene.grid.capacity = 6;
      scene.tracedElsewhere = [&](BuiltScene& built) {
        const std::vector<TraceMaterial> materials = built.numbered.materials;
        for (TraceMaterial& material : built.numbered.materials) material.alphaThreshold = threshold;
        TraceSettings other = scene.trace;
        other.tMin = tMin;
        std::vector<Hit> hits(scene.rays.size());
        traceRays(built.traceInput(other), scene.rays, hits, {});
        built.numbered.materials = materials;
        return hits;
      };
      const ToldScene told(scene);
      EXPECT_EQ(told.totals.causes[kCauseAlpha] > 0u, threshold != 128u) << tMin << ", " << threshold;
      EXPECT_EQ(told.totals.causes[kCauseSelfHit] > 0u, tMin == 0.2f) << tMin << ", " << threshold;
      EXPECT_EQ(told.totals.causes[kCauseNumeric], 0u) << tMin << ", " << threshold;
      EXPECT_TRUE(told.proofs().notConfirmed.empty()) << tMin << ", " << threshold;
    }
}

TEST(Truth, AValidRayWithoutAHitIsAMiss) {
  TruthScene scene{.scene = sceneOf({panelAt(5.5f)}), .rays = rayBundle(), .grid = unitCells(8)};
  scene.rays[1].valid = 0u;
  scene.tracedElsewhere = [&scene](BuiltScene&) { return std::vector<Hit>(scene.rays.size(), hitAt(kHitNoRay, 0.0f)); };
  const ToldScene told(scene);
  EXPECT_EQ(told.totals.rays, told.rays.size() - 1);
  EXPECT_EQ(told.totals.verdicts[kVerdictHole], told.rays.size() - 1);
  EXPECT_EQ(told.totals.verdicts[kVerdictNoRay], 1u);
  // Where there is no surface, such a hit agrees.
  for (Ray& ray : scene.rays) ray.direction = vec3(-1.0f, 0.0f, 0.0f);
  EXPECT_EQ(ToldScene(scene).totals.agreeMiss, told.rays.size() - 1);
}

TEST(Truth, WorkCanBeAbandoned) {
  const ToldScene told({.scene = sceneOf({panelAt(5.5f)}), .rays = rayBundle()});
  EXPECT_TRUE(tellTruth(told.input(), told.reference, told.rays, told.hits, [](float) { return false; }).empty());
  std::vector<RayTruth> wrong = told.truths;
  for (RayTruth& truth : wrong) truth.cause = kCauseNumeric;
  EXPECT_EQ(proveFrame(told.input(), {told.rays, told.hits, told.exact, wrong}, [](float) { return false; }).sum().total, 0u);
}

}  // namespace
}  // namespace gridscope
