// The exact reference: the same distance and the same reference, to the bit, as the test of every triangle, on scenes that are awkward for
// a hierarchy of boxes.
#include "core/trace/exact.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/base/parallel.h"
#include "tests/lesson.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

// Rays from anywhere in a box to anywhere, half of them along the axes.
std::vector<Ray> raysIn(uint32_t count, const vec3& low, const vec3& high, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Ray> rays;
  for (uint32_t i = 0; i < count; ++i) {
    const vec3 origin = low + (high - low) * randomPoint(random, 0.0f, 1.0f);
    vec3 direction = randomDirection(random);
    if (i % 2 == 0) {
      direction = vec3(0.0f);
      direction[int(i / 2 % 3)] = i % 4 == 0 ? 1.0f : -1.0f;
    }
    rays.push_back(makeRay(origin, direction));
  }
  return rays;
}

// Rays that aim at corners, edges and middles of triangles, some along the triangle's own plane, and some that start on it.
std::vector<Ray> raysAt(const std::vector<Triangle>& triangles, uint32_t count, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Ray> rays;
  for (uint32_t i = 0; i < count; ++i) {
    const Triangle& triangle = triangles[random() % triangles.size()];
    const float b = i % 3 == 0 ? 0.0f : randomPoint(random, 0.0f, 0.5f).x, c = i % 4 == 0 ? 0.0f : randomPoint(random, 0.0f, 0.5f).y;
    const vec3 target = triangle.a * (1.0f - b - c) + triangle.b * b + triangle.c * c;
    const vec3 size = glm::max(glm::abs(triangle.b - triangle.a), glm::abs(triangle.c - triangle.a));
    const vec3 inPlane = triangle.b - triangle.a;
    const vec3 way = i % 5 == 0 ? inPlane : (glm::length(size) + 1e-6f) * 3.0f * randomDirection(random);
    if (glm::length(way) > 0.0f) rays.push_back(makeRay(i % 7 == 0 ? target : target - way, way));
  }
  return rays;
}

void expectLikeBruteForce(const Scene& scene, const std::vector<Ray>& rays, GridSettings grid = {.cells = 16}) {
  const BuiltScene built(scene, grid);
  const TraceInput input = built.traceInput({});
  const ExactReference exact(input);
  const std::vector<Hit> hits = exact.trace(rays);
  std::vector<Hit> expected(rays.size());
  forRanges(rays.size(), 64, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) expected[i] = traceBruteForce(input, rays[i]);
  });
  uint32_t different = 0, found = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    different += std::memcmp(&hits[i], &expected[i], sizeof(Hit)) != 0 ? 1 : 0;
    found += expected[i].kind == kHitTriangle ? 1 : 0;
  }
  EXPECT_EQ(different, 0u) << "of " << rays.size() << " rays, of which " << found << " meet a triangle";
  EXPECT_GT(found, 0u);
}

TEST(Exact, FindsWhatBruteForceFindsAmongRandomTriangles) {
  const std::vector<Triangle> triangles = randomTriangles(600, 5.0f, 1.0f, 1);
  expectLikeBruteForce(sceneOf(triangles), raysIn(2000, vec3(-7.0f), vec3(7.0f), 2));
  expectLikeBruteForce(sceneOf(triangles), raysAt(triangles, 2000, 3));
}

TEST(Exact, OfCoplanarDuplicatesTheSmallestReferenceWins) {
  std::vector<Triangle> triangles = randomTriangles(60, 2.0f, 1.0f, 4);
  const std::vector<Triangle> once = triangles;
  for (int copy = 0; copy < 3; ++copy) triangles.insert(triangles.end(), once.rbegin(), once.rend());
  expectLikeBruteForce(sceneOf(triangles), raysAt(triangles, 3000, 5));
}

TEST(Exact, RaysThroughSharedEdgesAndAlongFlatFloorsFindTheSame) {
  std::vector<Triangle> triangles;
  for (int x = 0; x < 12; ++x)
    for (int z = 0; z < 12; ++z) {
      const vec3 a(float(x), 0.0f, float(z)), b(float(x + 1), 0.0f, float(z));
      const vec3 c(float(x), 0.0f, float(z + 1)), d(float(x + 1), 0.0f, float(z + 1));
      triangles.push_back({a, b, c});
      triangles.push_back({d, c, b});
      triangles.push_back({a + vec3(0.0f, 1.0f, 0.0f), b, c + vec3(0.0f, 1.0f, 0.0f)});
    }
  std::vector<Ray> rays = raysAt(triangles, 2000, 6);
  for (int x = 0; x <= 12; ++x)
    for (int z = 0; z <= 12; ++z) {
      rays.push_back(makeRay(vec3(float(x), 3.0f, float(z)), vec3(0.0f, -1.0f, 0.0f)));
      rays.push_back(makeRay(vec3(-1.0f, 0.0f, float(z)), vec3(1.0f, 0.0f, 0.0f)));
    }
  expectLikeBruteForce(sceneOf(triangles), rays);
}

TEST(Exact, ThinSliversAndTrianglesWithoutAreaAreTreatedTheSame) {
  std::mt19937 random(7);
  std::vector<Triangle> triangles;
  for (uint32_t i = 0; i < 400; ++i) {
    const vec3 a = randomPoint(random, -3.0f, 3.0f), along = randomDirection(random), beside = randomDirection(random);
    triangles.push_back({a, a + 4.0f * along, a + 2.0f * along + (i % 4 == 0 ? 0.0f : 1e-4f) * beside});
  }
  expectLikeBruteForce(sceneOf(triangles), raysAt(triangles, 4000, 8));
}

TEST(Exact, HugeSmallAndFarAwayScenesFindTheSame) {
  for (float scale : {1e-4f, 1e5f}) {
    std::vector<Triangle> triangles = randomTriangles(300, 5.0f, 1.0f, 9);
    for (Triangle& triangle : triangles) triangle = {triangle.a * scale, triangle.b * scale, triangle.c * scale};
    expectLikeBruteForce(sceneOf(triangles), raysAt(triangles, 2000, 10));
  }
  std::vector<Triangle> triangles = randomTriangles(300, 5.0f, 1.0f, 11);
  const vec3 away(20000.0f, -30000.0f, 10000.0f);
  for (Triangle& triangle : triangles) triangle = {triangle.a + away, triangle.b + away, triangle.c + away};
  expectLikeBruteForce(sceneOf(triangles), raysAt(triangles, 2000, 12));
}

TEST(Exact, RaysFromFarAwayFindTheSame) {
  const std::vector<Triangle> triangles = randomTriangles(400, 1.0f, 0.5f, 15);
  std::mt19937 random(16);
  for (float distance : {20.0f, 300.0f, 20000.0f, 1e6f, 1e9f}) {
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) {
      const vec3 origin = distance * randomDirection(random), target = randomPoint(random, -1.0f, 1.0f);
      rays.push_back(makeRay(origin, target - origin));
    }
    expectLikeBruteForce(sceneOf(triangles), rays);
  }
}

TEST(Exact, AlphaKeyedLeavesLetTheSameRaysThrough) {
  const Scene scene = makeBuiltInScene("alpha-leaf");
  const Bounds bounds = sceneBounds(scene);
  expectLikeBruteForce(scene, raysIn(3000, bounds.low, bounds.high, 13), {.cells = 24});
}

TEST(Exact, APixelWithoutARayAndASceneWithoutTrianglesHaveNoHit) {
  const BuiltScene built(sceneOf(randomTriangles(5, 1.0f, 1.0f, 14)), {.cells = 8});
  const TraceInput input = built.traceInput({});
  const ExactReference exact(input);
  Ray ray = makeRay(vec3(0.0f), vec3(1.0f, 0.0f, 0.0f));
  ray.valid = 0u;
  EXPECT_EQ(exact.trace(ray).kind, kHitNoRay);

  const BuiltScene flat(sceneOf({{vec3(0.0f), vec3(1.0f, 0.0f, 0.0f), vec3(2.0f, 0.0f, 0.0f)}}), {.cells = 8});
  const TraceInput nothing = flat.traceInput({});
  EXPECT_EQ(ExactReference(nothing).trace(makeRay(vec3(0.5f, 1.0f, 0.0f), vec3(0.0f, -1.0f, 0.0f))).kind, kHitMiss);
}

}  // namespace
}  // namespace gridscope
