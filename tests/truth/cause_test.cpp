// Causes: for each a scene made by hand in which every ray that does not agree has that cause and no other, and its proof.
#include <gtest/gtest.h>

#include <algorithm>
#include <ranges>

#include "tests/grid_words.h"
#include "tests/truth/scene.h"

namespace gridscope {
namespace {

// Every ray has this verdict and this cause, and every cause is confirmed, or none.
void expectCause(const TruthScene& scene, uint32_t cause, uint32_t verdict, bool confirmed = true) {
  const ToldScene told(scene);
  ASSERT_GT(told.rays.size(), 0u);
  EXPECT_EQ(told.totals.verdicts[verdict], told.rays.size()) << verdictName(verdict).title;
  for (uint32_t other = kCauseRefused; other < kCauseCount; ++other)
    EXPECT_EQ(told.totals.causes[other], other == cause ? told.rays.size() : 0u) << causeName(other).title;
  const ProofTotals proofs = told.proofs();
  EXPECT_EQ(proofs.sum().alone + proofs.sum().chain, confirmed ? told.rays.size() : 0u);
  EXPECT_EQ(proofs.sum().total, told.rays.size());
  EXPECT_EQ(proofs.notConfirmed.size(), confirmed ? 0u : told.rays.size());
}

// The clutter comes first, so it has the smaller references: full cells refuse the panel.
Scene sceneWithClutter(const std::vector<Triangle>& clutter, const std::vector<Triangle>& panels) {
  Scene scene = emptyScene();
  if (!clutter.empty()) placeMesh(scene, addMesh(scene, meshOf(clutter)));
  placeMesh(scene, addMesh(scene, meshOf(panels)));
  return scene;
}

// An upright blade: `across` is half of its width.
Triangle bladeAt(const vec3& middle, const vec3& across) {
  const vec3 up(0.0f, 0.3f, 0.0f);
  return {middle - across - up, middle + across - up, middle + up};
}

// Takes a reference out of a cell and closes the gap.
void removeReference(Grid& grid, ivec3 cell, uint32_t reference) {
  std::vector<uint32_t> stored = storedIn(grid, cell);
  ASSERT_EQ(std::erase(stored, reference), 1u);
  for (int slot = 0; slot < grid.parameters.capacity; ++slot)
    slotAt(grid, cell, slot) = size_t(slot) < stored.size() ? stored[size_t(slot)] : kNoReference;
}

void appendReference(Grid& grid, ivec3 cell, uint32_t reference) {
  const int slot = int(storedIn(grid, cell).size());
  ASSERT_LT(slot, grid.parameters.capacity);
  slotAt(grid, cell, slot) = reference;
}

TEST(TruthCause, RefusedWhenTheCellOfTheHitIsFullOfSmallerReferences) {
  TruthScene scene{.scene = sceneWithClutter(clutterAt(5.0f), {panelAt(5.5f)}), .rays = rayBundle(), .grid = unitCells(2)};
  expectCause(scene, kCauseRefused, kVerdictVoxelRight);
  scene.trace.traversal = kTraversalDda;
  expectCause(scene, kCauseRefused, kVerdictVoxelRight);
  scene.trace.gapFill = false;
  expectCause(scene, kCauseRefused, kVerdictHole);
}

TEST(TruthCause, RefusedInAGridThatOnlyFlagsOrSaysNothing) {
  for (int reserved : {0, 1}) {
    TruthScene scene{.scene = sceneWithClutter(clutterAt(5.0f), {panelAt(5.5f)}), .rays = rayBundle(), .grid = unitCells(2)};
    scene.damage = [reserved](BuiltScene& built) {
      Grid foreign = built.grid;
      foreign.parameters.reserved = reserved;
      foreign.parameters.stride = foreign.parameters.capacity + reserved;
      const ivec3 texels = gridTexelCount(foreign.parameters);
      foreign.words.assign(size_t(texels.x) * size_t(texels.y) * size_t(texels.z), 0);
      forEachCell(foreign.parameters, [&](ivec3 cell) {
        for (int slot = 0; slot < foreign.parameters.stride; ++slot) slotAt(foreign, cell, slot) = slotAt(built.grid, cell, slot);
      });
      built.grid = foreign;
    };
    expectCause(scene, kCauseRefused, kVerdictVoxelRight);
  }
}

TEST(TruthCause, LeftOutWhereAnotherBuildersGridHasRoomAndLacksTheTriangle) {
  TruthScene scene{.scene = sceneWithClutter({}, {panelAt(5.5f)}), .rays = rayBundle()};
  scene.damage = [](BuiltScene& built) {
    built.grid.parameters.reserved = 0;
    built.grid.parameters.stride = built.grid.parameters.capacity;
    built.grid = makeEmptyGrid(built.grid.parameters);
  };
  expectCause(scene, kCauseLeftOut, kVerdictHole);
}

TEST(TruthCause, SteppedOverWhenNoSegmentStartsInTheCellOfTheHit) {
  // Along the diagonal, 0.05 edges off the corner line: the ray is in cell x 3, z 2 for 0.07 edges around s = 3.57.
  const vec3 direction = glm::normalize(vec3(1.0f, 0.0f, 1.0f)), across = vec3(0.011f, 0.0f, -0.011f);
  const vec3 middle = vec3(0.5f, 2.5f, 0.45f) + 3.57f * direction;
  TruthScene scene{.scene = sceneWithClutter({}, {bladeAt(middle, across)})};
  for (int i = 0; i < 9; ++i) scene.rays.push_back(makeRay(vec3(0.5f, 2.3f + 0.02f * float(i), 0.45f), direction));
  expectCause(scene, kCauseSteppedOver, kVerdictHole);
}

TEST(TruthCause, RevisitWhenTheSegmentThatReachesTheHitIsSkipped) {
  // Along the diagonal through the cells' corners, 1.4 edges in each: segments 3 and 4 start in the cell x 2, z 2.
  const vec3 direction = glm::normalize(vec3(1.0f, 0.0f, 1.0f)), across = vec3(0.01f, 0.0f, -0.01f);
  const vec3 middle = vec3(0.1f, 2.5f, 0.1f) + 4.075f * direction;
  TruthScene scene{.scene = sceneWithClutter({}, {bladeAt(middle, across)})};
  for (int i = 0; i < 9; ++i) scene.rays.push_back(makeRay(vec3(0.1f, 2.3f + 0.02f * float(i), 0.1f), direction));
  scene.trace.ahead = 0.05f;
  expectCause(scene, kCauseRevisit, kVerdictHole);
}

TEST(TruthCause, SegmentEndWhenTheHitLiesOutsideTheWindowOfItsCellsOnlySegment) {
  TruthScene scene{.scene = sceneWithClutter({}, {panelAt(5.2f)}), .rays = rayBundle()};
  scene.trace.back = 0.0f;  // segments start at x = 5.5
  expectCause(scene, kCauseSegmentEnd, kVerdictHole);
}

TEST(TruthCause, AcceptedEarlyWhenTheElongatedSegmentBeforeMeetsAFartherTriangle) {
  // A ramp from x 4.2 to 6.5 is met at x 5.79, behind the panel, and already by the segment of the cell before the panel's.
  const Triangle ramp{vec3(4.2f, 2.05f, 2.1f), vec3(4.2f, 2.05f, 2.9f), vec3(6.5f, 2.7f, 2.5f)};
  TruthScene scene{.scene = sceneWithClutter({}, {ramp, panelAt(5.2f)})};
  for (int i = 0; i < 5; ++i) scene.rays.push_back(makeRay(vec3(0.5f, 2.48f, 2.46f + 0.02f * float(i)), vec3(1.0f, 0.0f, 0.0f)));
  expectCause(scene, kCauseAcceptedEarly, kVerdictTooFar);
}

TEST(TruthCause, GateWhenTheGapOfTheCellOfTheHitIsHeldBack) {
  TruthScene scene{.scene = sceneWithClutter(clutterAt(5.0f), {panelAt(5.5f)}), .grid = unitCells(2)};
  scene.rays = rayBundle(vec3(0.0f, 1.0f, 0.0f));
  expectCause(scene, kCauseGate, kVerdictHole);
  scene.trace.traversal = kTraversalDda;
  expectCause(scene, kCauseGate, kVerdictHole);
}

TEST(TruthCause, FilledEarlyWhenASaturatedCellBeforeTheHitEndsTheRay) {
  TruthScene scene{.scene = sceneWithClutter(clutterAt(3.0f), {panelAt(5.8f)}), .rays = rayBundle(), .grid = unitCells(2)};
  expectCause(scene, kCauseFilledEarly, kVerdictVoxelWrong);
  scene.trace.traversal = kTraversalDda;
  expectCause(scene, kCauseFilledEarly, kVerdictVoxelWrong);
}

TEST(TruthCause, FilledEarlyWhereThereIsNoSurfaceAtAll) {
  const Triangle aside{vec3(7.5f, 0.1f, 0.1f), vec3(7.5f, 0.9f, 0.1f), vec3(7.5f, 0.5f, 0.9f)};
  const TruthScene scene{.scene = sceneWithClutter(clutterAt(3.0f), {aside}), .rays = rayBundle(), .grid = unitCells(2)};
  expectCause(scene, kCauseFilledEarly, kVerdictVoxelWrong);
}

// Hits of the same scene under another rule.
std::vector<Hit> tracedWith(BuiltScene& built, const std::vector<Ray>& rays, const TraceSettings& settings) {
  std::vector<Hit> hits(rays.size());
  traceRays(built.traceInput(settings), rays, hits, {});
  return hits;
}

// A panel whose material is keyed, all of its alpha map `alpha`, before one that is not.
TruthScene keyedScene(uint8_t alpha) {
  TruthScene scene{.scene = emptyScene(), .rays = rayBundle()};
  scene.scene.images.push_back({.name = "alpha", .width = 1, .height = 1, .rgba = {255, 255, 255, alpha}});
  scene.scene.materials.push_back({.name = "keyed", .imageIndex = 0, .alphaMode = AlphaMode::mask});
  placeMesh(scene.scene, addMesh(scene.scene, meshOf({panelAt(3.5f)}, 1)));
  placeMesh(scene.scene, addMesh(scene.scene, meshOf({panelAt(6.5f)}, 0)));
  return scene;
}

// The hits are those of a trace in which alpha turns down what lies below another threshold.
void traceWithThreshold(TruthScene& scene, uint32_t threshold) {
  scene.tracedElsewhere = [&scene, threshold](BuiltScene& built) {
    const std::vector<TraceMaterial> materials = built.numbered.materials;
    for (TraceMaterial& material : built.numbered.materials) material.alphaThreshold = threshold;
    const std::vector<Hit> hits = tracedWith(built, scene.rays, scene.trace);
    built.numbered.materials = materials;
    return hits;
  };
}

TEST(TruthCause, AlphaWhenAHitThatIsTurnedDownWasLetThrough) {
  TruthScene scene = keyedScene(0);
  traceWithThreshold(scene, 0);
  expectCause(scene, kCauseAlpha, kVerdictTooNear);
}

TEST(TruthCause, AlphaWhenAHitThatCountsWasTurnedDown) {
  TruthScene scene = keyedScene(255);
  traceWithThreshold(scene, 256);
  expectCause(scene, kCauseAlpha, kVerdictTooFar);
}

TEST(TruthCause, SelfHitWhenAnotherTminHidOrMadeAHit) {
  TruthScene scene{.scene = sceneWithClutter({}, {panelAt(0.55f), panelAt(5.5f)}), .rays = rayBundle()};
  TraceSettings other = scene.trace;
  other.tMin = 0.1f;
  scene.tracedElsewhere = [&](BuiltScene& built) { return tracedWith(built, scene.rays, other); };
  expectCause(scene, kCauseSelfHit, kVerdictTooFar);
  std::swap(scene.trace.tMin, other.tMin);
  expectCause(scene, kCauseSelfHit, kVerdictTooNear);
}

// Two keyed leaves before a wall.
TEST(TruthCause, AlphaOfSeveralLeavesIsConfirmedAsAChain) {
  TruthScene scene = keyedScene(255);
  placeMesh(scene.scene, addMesh(scene.scene, meshOf({panelAt(4.5f)}, 1)));
  traceWithThreshold(scene, 256);
  expectCause(scene, kCauseAlpha, kVerdictTooFar);
  EXPECT_EQ(ToldScene(scene).proofs().mostLinks, 2u);
}

TEST(TruthCause, AlphaAndSelfHitThatDoNotMakeTheHitAgainAreNotConfirmed) {
  // A keyed surface was missed, but not because of its key: the wall behind it was missed too.
  TruthScene keyed = keyedScene(255);
  keyed.tracedElsewhere = [&keyed](BuiltScene&) {
    return std::vector<Hit>(keyed.rays.size(), Hit{kHitMiss, 0.0f, kNoReference, 0.0f, 0.0f});
  };
  expectCause(keyed, kCauseAlpha, kVerdictHole, false);
  TruthScene near{.scene = sceneWithClutter({}, {panelAt(0.55f), panelAt(5.5f)}), .rays = rayBundle()};
  near.tracedElsewhere = keyed.tracedElsewhere;
  expectCause(near, kCauseSelfHit, kVerdictHole, false);
}

TEST(TruthCause, OutsideWhenTheSurfaceLiesBeyondTheGrid) {
  const TruthScene scene{.scene = sceneWithClutter({}, {panelAt(12.5f)}), .rays = rayBundle()};
  expectCause(scene, kCauseOutside, kVerdictHole);
}

TEST(TruthCause, OutsideWhenTheRayNeverMeetsTheGrid) {
  TruthScene scene{.scene = sceneWithClutter({}, {panelAt(-5.5f)}), .rays = rayBundle()};
  for (Ray& ray : scene.rays) ray.origin.x = -4.0f, ray.direction = vec3(-1.0f, 0.0f, 0.0f);
  expectCause(scene, kCauseOutside, kVerdictHole);
  scene.trace.traversal = kTraversalDda;
  expectCause(scene, kCauseOutside, kVerdictHole);
}

TEST(TruthCause, LeftOutWhenTheOverlapTestKeepsATriangleOutOfTheCellOfTheHit) {
  TruthScene scene{.scene = sceneWithClutter({}, {panelAt(5.9f)}), .rays = rayBundle()};
  scene.grid.enlargement = 0.3f;  // a sphere of radius 0.26 about x = 5.5
  expectCause(scene, kCauseLeftOut, kVerdictHole);
}

TEST(TruthCause, LeftOutWhenATriangleIsTooSmallToHaveAnArea) {
  // A sliver as long as a cell's half and 1e-15 wide at the middle of the bundle's rays: its normal's square is below 1e-30.
  const Triangle sliver{vec3(5.5f, 2.25f, 0.0f), vec3(5.5f, 2.75f, 0.0f), vec3(5.5f, 2.5f, 1e-15f)};
  const Triangle wall{vec3(7.5f, 2.1f, -0.9f), vec3(7.5f, 2.9f, -0.9f), vec3(7.5f, 2.5f, 0.9f)};
  TruthScene scene{.scene = sceneWithClutter({}, {sliver, wall})};
  scene.grid.bounds = Bounds{.low = vec3(0.0f, 0.0f, -2.0f), .high = vec3(8.0f, 4.0f, 2.0f)};
  for (int i = 0; i < 5; ++i) scene.rays.push_back(makeRay(vec3(0.5f, 2.48f + 0.01f * float(i), 1e-16f), vec3(1.0f, 0.0f, 0.0f)));
  expectCause(scene, kCauseLeftOut, kVerdictTooFar);
}

// A static panel at x = 7.5 and a dynamic one at x = 5.5, whose reference is 0x00010000.
TruthScene dynamicScene() {
  TruthScene scene{.scene = emptyScene(), .rays = rayBundle()};
  placeMesh(scene.scene, addMesh(scene.scene, meshOf({panelAt(7.5f)})));
  placeMesh(scene.scene, addMesh(scene.scene, meshOf({panelAt(5.5f)})), vec3(0.0f), true);
  return scene;
}

TEST(TruthCause, SteppedOverWhereTheHitLiesOnAFaceAndTheCellBehindItDoesNotWantTheTriangle) {
  // A floor tile on a face is in the cells above the face alone. Rays meet it in the corner of a cell that they skip; some of the hits round
  // to just below the face.
  const vec3 direction = glm::normalize(vec3(1.0f, -1.0f, 1.0f));
  const Triangle tile{vec3(3.001f, 1.0f, 2.93f), vec3(3.07f, 1.0f, 2.999f), vec3(3.001f, 1.0f, 2.999f)};
  TruthScene scene{.scene = sceneWithClutter({}, {tile})};
  for (int i = 0; i < 20; ++i) scene.rays.push_back(makeRay(vec3(0.5f, 3.525f + 1e-4f * float(i), 0.45f), direction));
  const ToldScene told(scene);
  const auto below = std::ranges::count_if(std::views::iota(size_t{0}, told.rays.size()), [&](size_t i) {
    return !told.demand.wants(hitCell(told.built.grid.parameters, told.rays[i], told.exact[i]), told.exact[i].reference);
  });
  EXPECT_GT(below, 0);
  expectCause(scene, kCauseSteppedOver, kVerdictHole);
}

TEST(TruthCause, StaleWhenTheUpdateMissedADynamicReference) {
  TruthScene scene = dynamicScene();
  scene.damage = [](BuiltScene& built) {
    removeReference(built.grid, gridCell(built.grid.parameters, vec3(5.5f, 2.5f, 2.5f)), makeReference(1, 0));
  };
  expectCause(scene, kCauseStale, kVerdictTooFar);
}

TEST(TruthCause, StaleWhenTheUpdateLeftADynamicReferenceBehind) {
  // The cell before still holds it: the ray meets it there, and not the static panel just before it in its own cell.
  TruthScene scene = dynamicScene();
  scene.scene.meshes[0] = meshOf({panelAt(5.2f)});
  scene.damage = [](BuiltScene& built) {
    appendReference(built.grid, gridCell(built.grid.parameters, vec3(4.5f, 2.5f, 2.5f)), makeReference(1, 0));
  };
  expectCause(scene, kCauseStale, kVerdictTooFar);
}

TEST(TruthCause, NotInsertedWhenAReferenceIsMissingThoughItsCellHasRoom) {
  TruthScene scene{.scene = sceneWithClutter({}, {panelAt(5.5f)}), .rays = rayBundle()};
  scene.damage = [](BuiltScene& built) { removeReference(built.grid, gridCell(built.grid.parameters, vec3(5.5f, 2.5f, 2.5f)), 0u); };
  expectCause(scene, kCauseNotInserted, kVerdictHole);
}

TEST(TruthCause, NotInsertedWhenAFullCellLacksOneOfItsSmallestReferences) {
  // The panel is first in the file: sorted insertion never refuses it.
  TruthScene scene{.scene = sceneWithClutter({panelAt(5.5f)}, clutterAt(5.0f)), .rays = rayBundle(), .grid = unitCells(2)};
  scene.damage = [](BuiltScene& built) {
    const ivec3 cell = gridCell(built.grid.parameters, vec3(5.5f, 2.5f, 2.5f));
    removeReference(built.grid, cell, makeReference(0, 0));
    appendReference(built.grid, cell, makeReference(1, 1));
  };
  expectCause(scene, kCauseNotInserted, kVerdictVoxelRight);
}

TEST(TruthCause, SegmentLimitWhenTheRayWasNotLetFarEnough) {
  TruthScene scene{.scene = sceneWithClutter({}, {panelAt(5.5f)}), .rays = rayBundle()};
  scene.trace.maxSegments = 3;
  expectCause(scene, kCauseSegmentLimit, kVerdictHole);
  scene.trace.traversal = kTraversalDda;
  expectCause(scene, kCauseSegmentLimit, kVerdictHole);
}

TEST(TruthCause, NumericWhenADistanceIsALittleOffAndNothingSaysWhy) {
  TruthScene scene{.scene = sceneWithClutter({}, {panelAt(5.5f)}), .rays = rayBundle()};
  scene.tracedElsewhere = [&scene](BuiltScene& built) {
    std::vector<Hit> hits = tracedWith(built, scene.rays, scene.trace);
    for (Hit& hit : hits) hit.t += 2.0f * kAgreement;
    return hits;
  };
  expectCause(scene, kCauseNumeric, kVerdictTooFar, false);
}

TEST(TruthCause, NothingIsSaidOfRaysThatAgreeAndOfPixelsWithoutARay) {
  TruthScene scene{.scene = sceneWithClutter({}, {panelAt(5.5f)}), .rays = rayBundle()};
  scene.rays[0].valid = 0u;
  scene.rays[1].direction = vec3(-1.0f, 0.0f, 0.0f);
  const ToldScene told(scene);
  EXPECT_EQ(told.totals.rays, told.rays.size() - 1);
  EXPECT_EQ(told.totals.agreeMiss, 1u);
  EXPECT_EQ(told.totals.agreeHit, told.rays.size() - 2);
  EXPECT_EQ(told.totals.differ(), 0u);
  EXPECT_EQ(told.truths[0].verdict, kVerdictNoRay);
}

TEST(TruthCause, TheEvidenceNamesTheCellTheReferenceAndTheStep) {
  const TruthScene scene{.scene = sceneWithClutter(clutterAt(5.0f), {panelAt(5.5f)}), .rays = rayBundle(), .grid = unitCells(2)};
  const ToldScene told(scene);
  for (const RayTruth& truth : told.truths) {
    EXPECT_EQ(truth.cell, told.cellAt(vec3(5.5f, 2.5f, 2.5f)));
    EXPECT_EQ(truth.reference, makeReference(1, 0));
    EXPECT_EQ(truth.exactReference, makeReference(1, 0));
    EXPECT_EQ(truth.exactT, 5.0f);
    EXPECT_EQ(truth.segment, 5);
  }
}

}  // namespace
}  // namespace gridscope
