// The two overlap tests against clipping in double, and what the build relies on: no point of a triangle lies in a cell that missed it.
#include <gtest/gtest.h>

#include "shaders/shared/grid/overlap.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

using Polygon = std::vector<glm::dvec3>;

// The part of a polygon on the lower (sign 1) or upper (-1) side of a plane across an axis. Source: Sutherland and Hodgman, 1974.
Polygon clipped(const Polygon& polygon, int axis, double sign, double limit) {
  Polygon kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double a = limit - sign * from[axis], b = limit - sign * to[axis];
    if (a >= 0.0) kept.push_back(from);
    if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) kept.push_back(from + (to - from) * (a / (a - b)));
  }
  return kept;
}

bool meetsCube(const Triangle& triangle, const vec3& centre, double halfEdge) {
  Polygon polygon{glm::dvec3(triangle.a) - glm::dvec3(centre), glm::dvec3(triangle.b) - glm::dvec3(centre),
                  glm::dvec3(triangle.c) - glm::dvec3(centre)};
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {1.0, -1.0}) polygon = clipped(polygon, axis, sign, halfEdge);
  return !polygon.empty();
}

GridParameters unitGrid(uint32_t overlap, float enlargement = 1.05f) {
  GridSettings settings;
  settings.cellEdge = 0.25f;
  settings.overlap = overlap;
  settings.enlargement = enlargement;
  return deriveGrid(settings, {vec3(-1.0f), vec3(1.0f)}, NumberedScene{});
}

TEST(Overlap, TheExactTestAgreesWithClipping) {
  const GridParameters grid = unitGrid(kOverlapExact);
  std::mt19937 random(1);
  int met = 0, missed = 0;
  for (int i = 0; i < 200000; ++i) {
    const float size = i % 3 == 0 ? 0.1f : i % 3 == 1 ? 0.6f : 3.0f;
    const Triangle triangle = randomTriangles(1, 0.5f, size, uint32_t(i)).front();
    if (triangleDegenerate(triangleNormal(triangle))) continue;
    const ivec3 cell(int(random() % 10), int(random() % 10), int(random() % 10));
    const vec3 centre = gridCellCentre(grid, cell);
    const bool says = cellTakesTriangle(grid, triangle, triangleNormal(triangle), cell);
    const bool meetsSmaller = meetsCube(triangle, centre, grid.boxHalfEdge * (1.0 - 1e-5));
    const bool meetsLarger = meetsCube(triangle, centre, grid.boxHalfEdge * (1.0 + 1e-5));
    ASSERT_TRUE(says || !meetsSmaller) << "case " << i;
    ASSERT_TRUE(!says || meetsLarger) << "case " << i;
    (says ? met : missed) += 1;
  }
  EXPECT_GT(met, 2000);
  EXPECT_GT(missed, 2000);
}

TEST(Overlap, ThePlaneTestComparesTheDistanceOfTheCentreWithTheEnlargedRadius) {
  const GridParameters grid = unitGrid(kOverlapPlane);
  const double radius = 1.05 * 0.25 * std::sqrt(3.0) / 2.0;
  std::mt19937 random(2);
  int met = 0, missed = 0;
  for (int i = 0; i < 100000; ++i) {
    const Triangle triangle = randomTriangles(1, 1.0f, 1.0f, uint32_t(i)).front();
    const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(triangle.b - triangle.a), glm::dvec3(triangle.c - triangle.a)));
    const ivec3 cell(int(random() % 10), int(random() % 10), int(random() % 10));
    const double distance = std::abs(glm::dot(normal, glm::dvec3(gridCellCentre(grid, cell)) - glm::dvec3(triangle.a)));
    const bool says = cellTakesTriangle(grid, triangle, triangleNormal(triangle), cell);
    ASSERT_TRUE(says || distance > radius * (1.0 - 1e-3)) << "case " << i;
    ASSERT_TRUE(!says || distance < radius * (1.0 + 1e-3)) << "case " << i;
    (says ? met : missed) += 1;
  }
  EXPECT_GT(met, 5000);
  EXPECT_GT(missed, 5000);
}

TEST(Overlap, WhatTheExactTestTakesThePlaneTestTakesToo) {
  const GridParameters exact = unitGrid(kOverlapExact), plane = unitGrid(kOverlapPlane);
  for (const Triangle& triangle : randomTriangles(500, 0.9f, 0.6f, 4)) {
    const vec3 normal = triangleNormal(triangle);
    forEachCell(exact, [&](const ivec3& cell) {
      EXPECT_TRUE(!cellTakesTriangle(exact, triangle, normal, cell) || cellTakesTriangle(plane, triangle, normal, cell));
    });
  }
}

TEST(Overlap, EveryPointOfATriangleLiesInACellThatTakesIt) {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> number(0.0f, 1.0f);
  for (uint32_t overlap : {kOverlapPlane, kOverlapExact}) {
    const GridParameters grid = unitGrid(overlap);
    for (const Triangle& triangle : randomTriangles(2000, 0.5f, 0.49f, 7 + overlap)) {
      const CellRange range = triangleCells(grid, triangle);
      ASSERT_FALSE(range.clipped);
      for (int i = 0; i < 50; ++i) {
        float u = number(random), v = number(random);
        if (u + v > 1.0f) u = 1.0f - u, v = 1.0f - v;
        const ivec3 cell = gridCell(grid, triangle.a * (1.0f - u - v) + triangle.b * u + triangle.c * v);
        for (int axis = 0; axis < 3; ++axis) ASSERT_TRUE(cell[axis] >= range.low[axis] && cell[axis] <= range.high[axis]);
        ASSERT_TRUE(cellTakesTriangle(grid, triangle, triangleNormal(triangle), cell));
      }
    }
  }
}

TEST(Overlap, ATriangleOnTheFaceBetweenCellsIsTakenByTheCellOfItsPoints) {
  for (uint32_t overlap : {kOverlapPlane, kOverlapExact}) {
    const GridParameters grid = unitGrid(overlap, 1.0f);
    const Triangle wall{vec3(-0.9f, 0.25f, -0.9f), vec3(0.9f, 0.25f, -0.9f), vec3(-0.9f, 0.25f, 0.9f)};
    const CellRange range = triangleCells(grid, wall);
    EXPECT_EQ(range.low.y, range.high.y);
    EXPECT_TRUE(cellTakesTriangle(grid, wall, triangleNormal(wall), gridCell(grid, vec3(-0.5f, 0.25f, -0.5f))));
  }
}

TEST(Overlap, ARangesCellsAreCountedAndListedXFirst) {
  const CellRange range{ivec3(1, 2, 3), ivec3(2, 4, 4), false};
  ASSERT_EQ(cellRangeCount(range), 12u);
  uint32_t index = 0;
  for (int z = 3; z <= 4; ++z)
    for (int y = 2; y <= 4; ++y)
      for (int x = 1; x <= 2; ++x) EXPECT_EQ(cellRangeCell(range, index++), ivec3(x, y, z));
  EXPECT_EQ(cellRangeCount({ivec3(0), ivec3(1, -1, 1), true}), 0u);
}

}  // namespace
}  // namespace gridscope
