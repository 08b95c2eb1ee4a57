// The trace: hits against the truth, and each rule of the technique by a scene that shows it.
#include "core/trace/trace.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/base/parallel.h"
#include "core/scene/built_in_scenes.h"
#include "shaders/shared/grid/grid.h"
#include "shaders/shared/trace/triangle_test.h"
#include "tests/grid_words.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

Hit traceOne(const TraceInput& input, const Ray& ray) {
  Hit hit;
  traceRays(input, {&ray, 1}, {&hit, 1}, {});
  return hit;
}

std::vector<Ray> randomRays(uint32_t count, const vec3& low, const vec3& high, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Ray> rays;
  for (uint32_t i = 0; i < count; ++i) {
    const vec3 origin = low + (high - low) * randomPoint(random, 0.0f, 1.0f);
    rays.push_back(makeRay(origin, randomDirection(random), randomDirection(random)));
  }
  return rays;
}

std::vector<Hit> traceAll(const TraceInput& input, const std::vector<Ray>& rays) {
  std::vector<Hit> hits(rays.size());
  traceRays(input, rays, hits, {});
  return hits;
}

bool sameBits(const Hit& a, const Hit& b) { return std::memcmp(&a, &b, sizeof(Hit)) == 0; }

std::vector<Hit> bruteForce(const TraceInput& input, const std::vector<Ray>& rays) {
  std::vector<Hit> hits(rays.size());
  forRanges(rays.size(), 32, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) hits[i] = traceBruteForce(input, rays[i]);
  });
  return hits;
}

// The nearest hit in double, without any of the code under test; -1: none. Materials are not asked.
double exactDistance(const TraceInput& input, const Ray& ray) {
  const glm::dvec3 origin(ray.origin), direction(ray.direction);
  double best = -1.0;
  for (const Triangle& triangle : input.worldTriangles) {
    const glm::dvec3 a(triangle.a), edgeB = glm::dvec3(triangle.b) - a, edgeC = glm::dvec3(triangle.c) - a;
    const glm::dvec3 p = glm::cross(direction, edgeC);
    const double determinant = glm::dot(edgeB, p);
    if (determinant == 0.0) continue;
    const glm::dvec3 s = origin - a, q = glm::cross(s, edgeB);
    const double u = glm::dot(s, p) / determinant, v = glm::dot(direction, q) / determinant, t = glm::dot(edgeC, q) / determinant;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || t < double(input.parameters.tMin)) continue;
    if (best < 0.0 || t < best) best = t;
  }
  return best;
}

// Prints the rays whose hit differs from the truth by more than 1e-3 cell edges, and returns how many there are.
int listDifferences(const TraceInput& input, const std::vector<Ray>& rays, const std::vector<Hit>& hits, const std::vector<Hit>& truth) {
  int count = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].kind == truth[i].kind && std::abs(hits[i].t - truth[i].t) <= 1e-3f * input.grid.parameters.cellEdge) continue;
    std::printf("ray %zu: kind %u t %g reference %08X, but exactly kind %u t %g reference %08X\n", i, hits[i].kind, double(hits[i].t),
                hits[i].reference, truth[i].kind, double(truth[i].t), truth[i].reference);
    ++count;
  }
  return count;
}

const Triangle kWall{vec3(2.0f, -1.0f, -1.0f), vec3(2.0f, 3.0f, -1.0f), vec3(2.0f, -1.0f, 3.0f)};
constexpr TraceSettings kDda{.traversal = kTraversalDda};

// Cells of edge 1 with faces at whole numbers, from -1 on.
GridSettings unitCells(uint32_t capacity = 8) {
  GridSettings settings;
  settings.cellEdge = 1.0f;
  settings.capacity = capacity;
  settings.bounds = Bounds{vec3(0.0f), vec3(8.0f)};
  return settings;
}

TEST(Trace, DdaFindsTheTruthWhereNothingIsRefused) {
  Scene scene = sceneOf(randomTriangles(2000, 1.0f, 0.2f, 41));
  placeMesh(scene, addMesh(scene, meshOf(randomTriangles(30, 1.0f, 2.0f, 42))));
  GridSettings settings;
  settings.cells = 24;
  settings.capacity = 512;
  for (uint32_t overlap : {kOverlapPlane, kOverlapExact}) {
    settings.overlap = overlap;
    const BuiltScene built(scene, settings);
    ASSERT_EQ(built.staticReport.refused, 0u);
    const TraceInput input = built.traceInput(kDda);
    const std::vector<Ray> rays = randomRays(4000, vec3(-1.5f), vec3(1.5f), 43);
    const std::vector<Hit> hits = traceAll(input, rays);
    EXPECT_LE(listDifferences(input, rays, hits, bruteForce(input, rays)), 1);
  }
}

TEST(Trace, BruteForceAgreesWithDoublePrecision) {
  const BuiltScene built(sceneOf(randomTriangles(500, 1.0f, 0.6f, 44)), {});
  const TraceInput input = built.traceInput(kDda);
  int differences = 0, hitCount = 0;
  for (const Ray& ray : randomRays(4000, vec3(-1.0f), vec3(1.0f), 45)) {
    const Hit hit = traceBruteForce(input, ray);
    const double exact = exactDistance(input, ray);
    hitCount += hit.kind == kHitTriangle ? 1 : 0;
    const bool same = exact < 0.0 ? hit.kind == kHitMiss : hit.kind == kHitTriangle && std::abs(double(hit.t) - exact) < 1e-4;
    differences += same ? 0 : 1;
  }
  EXPECT_GT(hitCount, 1000);
  EXPECT_LE(differences, 2);  // rays that graze an edge
}

TEST(Trace, DdaFindsTheTruthInEveryLesson) {
  for (const BuiltInScene& lesson : builtInScenes()) {
    if (lesson.name == "hall") continue;  // 200,000 triangles: too many for a quick test
    const Scene scene = lesson.make();
    const Bounds bounds = sceneBounds(scene);
    const BuiltScene built(scene, unsaturated(scene, {.cells = 20}));
    ASSERT_EQ(built.staticReport.refused + built.dynamicReport.refused, 0u) << lesson.name;
    const TraceInput input = built.traceInput(kDda);
    const std::vector<Ray> rays = randomRays(400, bounds.low, bounds.high, 46);
    EXPECT_LE(listDifferences(input, rays, traceAll(input, rays), bruteForce(input, rays)), 1) << lesson.name;
  }
}

TEST(Trace, SegmentsNeverReportAHitThatIsNotOne) {
  const BuiltScene built(sceneOf(randomTriangles(800, 1.0f, 0.2f, 47)), {.cells = 24, .capacity = 256});
  const TraceInput input = built.traceInput({});
  const std::vector<Ray> rays = randomRays(4000, vec3(-1.5f), vec3(1.5f), 48);
  const std::vector<Hit> hits = traceAll(input, rays), truth = bruteForce(input, rays);
  int equal = 0, hitCount = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    EXPECT_NE(hits[i].kind, kHitVoxel);
    if (hits[i].kind == kHitTriangle) {
      // Stepping may miss the nearest and find one behind it, but each hit is a point of its triangle.
      EXPECT_GE(hits[i].t, truth[i].t);
      EXPECT_TRUE(hits[i].u >= -1e-4f && hits[i].v >= -1e-4f && hits[i].u + hits[i].v <= 1.0f + 1e-4f);
    }
    hitCount += truth[i].kind == kHitTriangle ? 1 : 0;
    equal += truth[i].kind == kHitTriangle && sameBits(hits[i], truth[i]) ? 1 : 0;
  }
  EXPECT_GT(equal, hitCount * 3 / 4);
}

TEST(Trace, SmallPassesGiveTheBitsOfOnePass) {
  const BuiltScene built(sceneOf(randomTriangles(600, 1.0f, 0.3f, 49)), {.cells = 24, .capacity = 4});
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
    TraceInput input = built.traceInput({.traversal = traversal});
    const std::vector<Ray> rays = randomRays(3000, vec3(-2.0f), vec3(2.0f), 50);
    std::vector<Hit> whole(rays.size()), parts(rays.size());
    std::vector<RayCounters> wholeCounters(rays.size()), partCounters(rays.size());
    traceRays(input, rays, whole, wholeCounters);
    for (uint32_t perPass : {1u, 2u, 7u}) {
      input.parameters.segmentsPerPass = perPass;
      traceRays(input, rays, parts, partCounters);
      for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_TRUE(sameBits(whole[i], parts[i]));
        ASSERT_EQ(wholeCounters[i].visits, partCounters[i].visits);
        ASSERT_EQ(wholeCounters[i].tests, partCounters[i].tests);
      }
    }
  }
}

TEST(Trace, FastCountingAndRecordingAgree) {
  const BuiltScene built(sceneOf(randomTriangles(600, 1.0f, 0.3f, 51)), {.cells = 16, .capacity = 4});
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
    const TraceInput input = built.traceInput({.traversal = traversal});
    const std::vector<Ray> rays = randomRays(2000, vec3(-1.5f), vec3(1.5f), 52);
    std::vector<Hit> counted(rays.size());
    std::vector<RayCounters> counters(rays.size());
    traceRays(input, rays, counted, counters);
    const std::vector<Hit> fast = traceAll(input, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
      ASSERT_TRUE(sameBits(fast[i], counted[i]));
      const RayRecord record = recordRay(input, rays[i]);
      ASSERT_TRUE(sameBits(fast[i], record.hit));
      uint32_t visits = 0, tests = 0;
      for (const StepRecord& step : record.steps) {
        visits += step.outcome == kStepEmpty || step.outcome == kStepRead ? 1 : 0;
        tests += uint32_t(step.tests.size());
        if (step.outcome == kStepRead) {
          ASSERT_EQ(step.stored, int(step.tests.size()));
        }
      }
      ASSERT_EQ(visits, counters[i].visits);
      ASSERT_EQ(tests, counters[i].tests);
    }
  }
}

TEST(Trace, ARayThatIsNotValidIsNotTraced) {
  const BuiltScene built(sceneOf({kWall}), unitCells());
  Ray ray = makeRay(vec3(0.5f), vec3(1.0f, 0.0f, 0.0f));
  ray.valid = 0;
  for (const TraceSettings& settings : {TraceSettings{}, kDda}) {
    EXPECT_EQ(traceOne(built.traceInput(settings), ray).kind, kHitNoRay);
    EXPECT_EQ(traceBruteForce(built.traceInput(settings), ray).kind, kHitNoRay);
  }
}

TEST(Trace, HitsCarryDistanceReferenceAndBarycentrics) {
  const BuiltScene built(sceneOf({kWall}), unitCells());
  for (const TraceSettings& settings : {TraceSettings{}, kDda})
    for (float side : {1.0f, -1.0f}) {  // no culling: both sides
      const Hit hit = traceOne(built.traceInput(settings), makeRay(vec3(2.0f - side * 1.25f, 0.5f, 1.0f), vec3(side, 0.0f, 0.0f)));
      EXPECT_EQ(hit.kind, kHitTriangle);
      EXPECT_FLOAT_EQ(hit.t, 1.25f);
      EXPECT_EQ(hit.reference, 0u);
      EXPECT_FLOAT_EQ(hit.u, 1.5f / 4.0f);
      EXPECT_FLOAT_EQ(hit.v, 2.0f / 4.0f);
    }
}

TEST(Trace, TheWindowEndsAtTheElongationAndBeginsBehindTheSegment) {
  // The cell of segment 0 holds a triangle that the ray meets at t = 1.6 in its plane: the floor slants across two cells.
  const Triangle floor{vec3(0.1f, 0.4f, 0.1f), vec3(3.9f, 0.4f, 0.1f), vec3(0.1f, 0.4f, 3.9f)};
  const BuiltScene built(sceneOf({floor}), unitCells());
  const Ray ray = makeRay(vec3(0.5f, 0.9f, 0.5f), vec3(0.95f, -0.3f, 0.08f));
  const float exact = traceBruteForce(built.traceInput(kDda), ray).t;
  ASSERT_GT(exact, 1.6f);
  ASSERT_LT(exact, 1.75f);
  const RayRecord longer = recordRay(built.traceInput({.ahead = 0.75f}), ray);
  EXPECT_EQ(longer.hit.t, exact);
  EXPECT_EQ(longer.steps.size(), 1u);
  const RayRecord shorter = recordRay(built.traceInput({.ahead = 0.25f}), ray);
  ASSERT_EQ(shorter.steps.size(), 2u);
  EXPECT_EQ(shorter.steps[0].tests.at(0).verdict, kTestBeyond);
  EXPECT_EQ(shorter.hit.t, exact);

  // The second segment would see a hit before its start only as far back as asked.
  const BuiltScene wall(sceneOf({{vec3(1.3f, 0.1f, 0.1f), vec3(1.3f, 0.9f, 0.1f), vec3(1.3f, 0.1f, 0.9f)}}), unitCells());
  const Ray across = makeRay(vec3(0.9f, 0.3f, 0.3f), vec3(1.0f, 0.0f, 0.0f));  // segment 1 starts at 1.9, the wall is at t = 0.4
  EXPECT_EQ(traceOne(wall.traceInput({.back = 1.0f, .ahead = 0.0f}), across).kind, kHitTriangle);
  EXPECT_EQ(traceOne(wall.traceInput({.back = 0.5f, .ahead = 0.0f}), across).kind, kHitMiss);
  EXPECT_EQ(recordRay(wall.traceInput({.back = 0.5f, .ahead = 0.0f}), across).steps.at(1).tests.at(0).verdict, kTestBefore);
}

TEST(Trace, HitsNearerThanTMinAreNotSeen) {
  const BuiltScene built(sceneOf({kWall}), unitCells());
  const Ray ray = makeRay(vec3(1.5f, 0.5f, 0.5f), vec3(1.0f, 0.0f, 0.0f));
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
    EXPECT_EQ(traceOne(built.traceInput({.traversal = traversal, .tMin = 0.4f}), ray).kind, kHitTriangle);
    EXPECT_EQ(traceOne(built.traceInput({.traversal = traversal, .tMin = 0.6f}), ray).kind, kHitMiss);
  }
}

TEST(Trace, TheCellVisitedLastIsSkipped) {
  const BuiltScene built(sceneOf({kWall}), unitCells());
  // Diagonal steps of 1 cross about 0.58 of a cell on each axis.
  const RayRecord record = recordRay(built.traceInput({}), makeRay(vec3(4.01f), vec3(1.0f)));
  ASSERT_GE(record.steps.size(), 3u);
  EXPECT_EQ(record.steps[0].outcome, kStepEmpty);
  EXPECT_EQ(record.steps[1].outcome, kStepRevisit);
  EXPECT_EQ(record.steps[2].outcome, kStepEmpty);
  EXPECT_EQ(record.hit.kind, kHitMiss);
}

TEST(Trace, OfEqualDistancesTheSmallerReferenceWinsInEveryOrderOfSlots) {
  for (uint32_t insertion : {kInsertionSorted, kInsertionFirstCome}) {
    GridSettings settings = unitCells();
    settings.insertion = insertion;
    BuiltScene built(sceneOf({kWall, kWall, kWall}), settings);
    if (insertion == kInsertionFirstCome)
      forEachCell(built.grid.parameters, [&](const ivec3& cell) { std::swap(slotAt(built.grid, cell, 0), slotAt(built.grid, cell, 2)); });
    for (const TraceSettings& trace : {TraceSettings{}, kDda})
      EXPECT_EQ(traceOne(built.traceInput(trace), makeRay(vec3(0.5f), vec3(1.0f, 0.0f, 0.0f))).reference, 0u);
  }
}

// Small triangles that fill a cell before the wall does.
BuiltScene saturatedWall(bool gapsToFill = true) {
  std::vector<Triangle> triangles(8, {vec3(2.1f, 0.1f, 0.1f), vec3(2.2f, 0.1f, 0.1f), vec3(2.1f, 0.2f, 0.1f)});
  if (gapsToFill) triangles.push_back(kWall);
  return BuiltScene(sceneOf(triangles), unitCells(8));
}

TEST(Trace, ASaturatedCellWithoutAHitGivesAVoxelHitWithTheLastReference) {
  const BuiltScene built = saturatedWall();
  const Ray ray = makeRay(vec3(0.3f, 0.6f, 0.6f), vec3(1.0f, 0.0f, 0.0f), vec3(1.0f, 0.0f, 0.0f));
  const Hit bySegment = traceOne(built.traceInput({.gate = 0.0f}), ray);
  EXPECT_EQ(bySegment.kind, kHitVoxel);
  EXPECT_FLOAT_EQ(bySegment.t, 2.5f);  // segment 2 starts at 2.3 in the full cell
  EXPECT_EQ(bySegment.reference, 7u);
  EXPECT_TRUE(bySegment.u >= 0.0f && bySegment.v >= 0.0f && bySegment.u + bySegment.v <= 1.0f);

  const Hit byDda = traceOne(built.traceInput({.traversal = kTraversalDda, .gate = 0.0f}), ray);
  EXPECT_EQ(byDda.kind, kHitVoxel);
  EXPECT_FLOAT_EQ(byDda.t, 2.2f);  // in the full cell from 1.7 to 2.7
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda})
    EXPECT_EQ(traceOne(built.traceInput({.traversal = traversal, .gapFill = false, .gate = 0.0f}), ray).kind, kHitMiss);
}

TEST(Trace, AFullCellThatRefusedNothingGivesNoVoxelHit) {
  const BuiltScene built = saturatedWall(false);
  EXPECT_EQ(
      traceOne(built.traceInput({.gate = 0.0f}), makeRay(vec3(0.3f, 0.6f, 0.6f), vec3(1.0f, 0.0f, 0.0f), vec3(1.0f, 0.0f, 0.0f))).kind,
      kHitMiss);
}

TEST(Trace, TheGateHoldsBackVoxelHitsNearTheLaunchingSurface) {
  const BuiltScene built = saturatedWall();
  const vec3 direction(1.0f, 0.0f, 0.0f);
  auto kind = [&](uint32_t traversal, float gate, const vec3& launchNormal) {
    return traceOne(built.traceInput({.traversal = traversal, .gate = gate}), makeRay(vec3(0.3f, 0.6f, 0.6f), direction, launchNormal))
        .kind;
  };
  // Segment 2 starts at s = 2; the walk enters the cell at 1.7.
  EXPECT_EQ(kind(kTraversalSegment, 1.99f, direction), kHitVoxel);
  EXPECT_EQ(kind(kTraversalSegment, 2.0f, direction), kHitMiss);
  EXPECT_EQ(kind(kTraversalDda, 1.69f, direction), kHitVoxel);
  EXPECT_EQ(kind(kTraversalDda, 1.71f, direction), kHitMiss);

  // What counts is the distance along the launch normal.
  const vec3 slanted = glm::normalize(vec3(1.0f, 1.0f, 0.0f));
  EXPECT_EQ(kind(kTraversalSegment, 1.5f, slanted), kHitMiss);
  EXPECT_EQ(kind(kTraversalSegment, 1.4f, slanted), kHitVoxel);
  EXPECT_EQ(kind(kTraversalSegment, 0.0f, vec3(0.0f)), kHitMiss);
}

TEST(Trace, AlphaTurnsAHitDownAndTheRayGoesOn) {
  // A wall whose texture is transparent in its lower half, and a solid one behind it.
  Scene scene = emptyScene();
  scene.images.push_back({"stripes", 1, 2, {0, 0, 0, 0, 0, 0, 0, 255}});
  scene.materials[0].imageIndex = 0;
  scene.materials[0].alphaMode = AlphaMode::mask;
  scene.materials.resize(2);
  Mesh leaf = meshOf({kWall});
  leaf.uvs = {vec2(0.0f, 0.0f), vec2(0.0f, 1.0f), vec2(0.0f, 0.0f)};
  Mesh solid = meshOf({kWall}, 1);
  placeMesh(scene, addMesh(scene, leaf));
  placeMesh(scene, addMesh(scene, solid), vec3(2.5f, 0.0f, 0.0f));
  const BuiltScene built(scene, unitCells());
  for (const TraceSettings& settings : {TraceSettings{}, kDda}) {
    const TraceInput input = built.traceInput(settings);
    const Ray through = makeRay(vec3(0.5f, 0.5f, 0.5f), vec3(1.0f, 0.0f, 0.0f));  // v = 0.375
    const Ray against = makeRay(vec3(0.5f, 1.3f, 0.5f), vec3(1.0f, 0.0f, 0.0f));  // v = 0.575
    EXPECT_EQ(traceOne(input, through).reference, makeReference(1, 0));
    EXPECT_FLOAT_EQ(traceOne(input, through).t, 4.0f);
    EXPECT_EQ(traceOne(input, against).reference, makeReference(0, 0));
    EXPECT_TRUE(sameBits(traceBruteForce(input, through), traceOne(input, through)));
    bool sawAlpha = false;
    for (const StepRecord& step : recordRay(input, through).steps)
      for (const TestRecord& test : step.tests) sawAlpha |= test.verdict == kTestAlpha && test.alphaByte == 0 && test.reference == 0;
    EXPECT_TRUE(sawAlpha);
  }
}

TEST(Trace, AlphaTexelsFollowTheWrapMode) {
  EXPECT_EQ(alphaTexel(0.3f, 4, 0), 1u);
  EXPECT_EQ(alphaTexel(-0.3f, 4, 0), 2u);
  EXPECT_EQ(alphaTexel(5.99f, 4, 0), 3u);
  EXPECT_EQ(alphaTexel(1.3f, 4, 1), 2u);
  EXPECT_EQ(alphaTexel(-0.3f, 4, 1), 1u);
  EXPECT_EQ(alphaTexel(2.3f, 4, 1), 1u);
  EXPECT_EQ(alphaTexel(1.3f, 4, 2), 3u);
  EXPECT_EQ(alphaTexel(-7.0f, 4, 2), 0u);
  EXPECT_EQ(alphaTexel(1.0f, 4, 2), 3u);
  EXPECT_EQ(alphaTexel(-1e-9f, 4, 0), 3u);
}

TEST(Trace, ARayFromOutsideIsBroughtToTheGridByWholeSegments) {
  const BuiltScene built(sceneOf({kWall}), unitCells());
  const Ray ray = makeRay(vec3(-20.3f, 0.5f, 0.5f), vec3(1.0f, 0.0f, 0.0f));
  for (const TraceSettings& settings : {TraceSettings{}, kDda}) {
    EXPECT_FLOAT_EQ(traceOne(built.traceInput(settings), ray).t, 22.3f);
    EXPECT_EQ(traceOne(built.traceInput(settings), makeRay(vec3(-20.0f, 0.5f, 0.5f), vec3(-1.0f, 0.0f, 0.0f))).kind, kHitMiss);
    EXPECT_EQ(traceOne(built.traceInput(settings), makeRay(vec3(-20.0f, 50.0f, 0.5f), vec3(1.0f, 0.1f, 0.0f))).kind, kHitMiss);
  }
  const RayRecord record = recordRay(built.traceInput({}), ray);
  EXPECT_EQ(record.steps.at(0).segment, 19);  // the grid begins at x = -1
  EXPECT_EQ(record.steps.size(), 5u);         // the segment that starts at 2.7 looks back to the wall at 2
}

TEST(Trace, EveryRayFromOutsideThatHitsSomethingInTheTruthIsWalked) {
  const BuiltScene built(sceneOf(randomTriangles(500, 1.0f, 0.5f, 61)), {.cells = 16, .capacity = 256});
  const TraceInput input = built.traceInput(kDda);
  std::mt19937 random(62);
  std::vector<Ray> rays;
  for (int i = 0; i < 3000; ++i) {
    const vec3 origin = 5.0f * randomDirection(random);
    rays.push_back(makeRay(origin, randomPoint(random, -1.0f, 1.0f) - origin));
  }
  EXPECT_LE(listDifferences(input, rays, traceAll(input, rays), bruteForce(input, rays)), 1);
}

TEST(Trace, RaysAlongTheAxesAndOnTheFacesOfCellsEnd) {
  const BuiltScene built(sceneOf(randomTriangles(100, 1.0f, 0.5f, 63)), {.cells = 8, .capacity = 64});
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
    const TraceInput input = built.traceInput({.traversal = traversal});
    const GridParameters& grid = built.grid.parameters;
    for (int axis = 0; axis < 3; ++axis)
      for (float sign : {1.0f, -1.0f})
        for (int i = 0; i <= 8; ++i) {
          vec3 origin(gridFace(grid, 0, i), gridFace(grid, 1, 8 - i), gridFace(grid, 2, i)), direction(0.0f);
          direction[axis] = sign;
          const Hit hit = traceOne(input, makeRay(origin, direction));
          EXPECT_TRUE(hit.kind == kHitTriangle || hit.kind == kHitMiss) << hit.kind;
        }
  }
}

TEST(Trace, TooFewSegmentsEndARayAtItsLimit) {
  const BuiltScene built(sceneOf({kWall}), unitCells());
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
    const Ray away = makeRay(vec3(7.5f, 0.5f, 0.5f), vec3(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(traceOne(built.traceInput({.traversal = traversal, .maxSegments = 3}), away).kind, kHitLimit);
    EXPECT_EQ(traceOne(built.traceInput({.traversal = traversal}), away).kind, kHitMiss);
  }
}

TEST(Trace, MirroredAndTurnedInstancesAreHitWhereTheyStand) {
  const Scene scene = makeMirroredInstances();
  const BuiltScene built(scene, unsaturated(scene, {.cells = 32}));
  ASSERT_EQ(built.staticReport.refused + built.dynamicReport.refused, 0u);
  const Bounds bounds = sceneBounds(scene);
  const TraceInput input = built.traceInput(kDda);
  const std::vector<Ray> rays = randomRays(1500, bounds.low, bounds.high, 64);
  EXPECT_LE(listDifferences(input, rays, traceAll(input, rays), bruteForce(input, rays)), 1);

  // The transform itself, against glm.
  const std::vector<mat4> nodes = nodeTransforms(scene, 0.0f);
  for (uint32_t i = 0; i < built.numbered.instanceCount(); ++i) {
    const SceneInstance& source = scene.instances[built.numbered.sources[i].sceneInstance];
    const vec3 expected =
        vec3(nodes[source.node] * source.local * vec4(built.numbered.objectTriangles[built.numbered.instances[i].firstTriangle].a, 1.0f));
    EXPECT_LT(glm::distance(expected, built.worldTriangles[built.numbered.instances[i].firstWorldTriangle].a), 1e-4f);
  }
}

}  // namespace
}  // namespace gridscope
