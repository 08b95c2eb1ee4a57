// Build: every cell holds what a set says it should, nothing is lost, and what was left out is counted.
#include "core/grid/build.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/grid/invariants.h"
#include "shaders/shared/grid/overlap.h"
#include "tests/grid_words.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

// All references that a cell should be offered, rising: each triangle is asked alone.
std::vector<uint32_t> overlappingReferences(const BuiltScene& built, const ivec3& cell) {
  const GridParameters& grid = built.grid.parameters;
  std::vector<uint32_t> references;
  for (uint32_t i = 0; i < built.numbered.instanceCount(); ++i)
    for (uint32_t k = 0; k < built.numbered.instances[i].triangleCount; ++k) {
      const Triangle& triangle = built.worldTriangles[built.numbered.instances[i].firstWorldTriangle + k];
      const CellRange range = triangleCells(grid, triangle);
      const bool inBox = glm::all(glm::greaterThanEqual(cell, range.low)) && glm::all(glm::lessThanEqual(cell, range.high));
      if (inBox && !triangleDegenerate(triangleNormal(triangle)) && cellTakesTriangle(grid, triangle, triangleNormal(triangle), cell))
        references.push_back(makeReference(i, k));
    }
  return references;
}

void expectNothingBroken(const BuiltScene& built) {
  const uint64_t tried = uint64_t(built.staticReport.tried) + built.dynamicReport.tried;
  EXPECT_EQ(checkInvariants(built.grid, built.numbered, &tried), std::vector<std::string>{});
  for (const BuildReport& report : {built.staticReport, built.dynamicReport}) {
    EXPECT_EQ(report.stored + report.refused, report.tried);
    EXPECT_EQ(report.cellsWalked, report.cellsExpected);
    EXPECT_EQ(report.loopsCut, 0u);
  }
}

// Static and dynamic triangles, some of them large.
Scene mixedScene() {
  Scene scene = emptyScene();
  std::vector<Triangle> triangles = randomTriangles(300, 1.0f, 0.2f, 11);
  for (const Triangle& large : randomTriangles(20, 1.0f, 1.5f, 12)) triangles.push_back(large);
  const uint32_t mesh = addMesh(scene, meshOf(triangles));
  placeMesh(scene, mesh, vec3(0.0f), true);
  placeMesh(scene, mesh, vec3(0.3f, 0.1f, 0.0f));
  placeMesh(scene, mesh, vec3(0.0f, 0.0f, 0.4f));
  scene.nodes[2].scale = vec3(-1.0f, 1.0f, 1.0f);
  return scene;
}

TEST(Build, EveryCellHoldsTheSmallestOfTheReferencesThatOverlapItAndCountsTheRest) {
  for (uint32_t overlap : {kOverlapPlane, kOverlapExact})
    for (uint32_t capacity : {1u, 7u, 300u}) {
      GridSettings settings;
      settings.cells = 12;
      settings.capacity = capacity;
      settings.overlap = overlap;
      settings.stretch = Stretch(capacity % 3);
      const BuiltScene built(mixedScene(), settings);
      const GridParameters& grid = built.grid.parameters;
      forEachCell(grid, [&](const ivec3& cell) {
        std::vector<uint32_t> expected = overlappingReferences(built, cell);
        const auto kept = expected.begin() + std::ptrdiff_t(std::min<size_t>(expected.size(), capacity));
        const auto refusedStatic = std::count_if(kept, expected.end(), [&](uint32_t r) { return r < firstDynamicReference(grid); });
        ASSERT_EQ(refusedAt(built.grid, cell, false), uint32_t(refusedStatic));
        ASSERT_EQ(refusedAt(built.grid, cell, true), uint32_t(expected.end() - kept - refusedStatic));
        expected.erase(kept, expected.end());
        ASSERT_EQ(storedReferences(built.grid, cell), expected);
      });
      expectNothingBroken(built);
    }
}

TEST(Build, FirstComeHoldsTheSameReferencesWhereNothingIsRefused) {
  GridSettings settings;
  settings.cells = 12;
  settings.capacity = 300;
  const BuiltScene sorted(mixedScene(), settings);
  settings.insertion = kInsertionFirstCome;
  const BuiltScene firstCome(mixedScene(), settings);
  EXPECT_EQ(sorted.grid.words, firstCome.grid.words);  // in rising order, first come is sorted
  settings.capacity = 5;
  expectNothingBroken(BuiltScene(mixedScene(), settings));
}

TEST(Build, TheSameSceneGivesTheSameGridEveryTime) {
  for (uint32_t insertion : {kInsertionSorted, kInsertionFirstCome}) {
    GridSettings settings;
    settings.cells = 20;
    settings.capacity = 4;
    settings.insertion = insertion;
    const BuiltScene first(mixedScene(), settings);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(BuiltScene(mixedScene(), settings).grid.words, first.grid.words);
  }
}

TEST(Build, DegenerateTrianglesAreCountedAndNotInsertedButKeepTheirNumbers) {
  std::vector<Triangle> triangles = randomTriangles(3, 1.0f, 0.5f, 3);
  triangles[1] = {vec3(0.0f), vec3(0.5f), vec3(1.0f)};
  GridSettings settings;
  settings.cells = 8;
  const BuiltScene built(sceneOf(triangles), settings);
  EXPECT_EQ(built.staticReport.degenerate, 1u);
  EXPECT_EQ(built.worldTriangles[1].c, vec3(1.0f));
  bool sawFirst = false, sawLast = false;
  forEachCell(built.grid.parameters, [&](const ivec3& cell) {
    for (uint32_t reference : storedReferences(built.grid, cell)) {
      EXPECT_NE(reference, 1u);
      sawFirst |= reference == 0, sawLast |= reference == 2;
    }
  });
  EXPECT_TRUE(sawFirst && sawLast);
}

TEST(Build, TrianglesThatReachOutsideTheBoundsAreCountedAndClipped) {
  GridSettings settings;
  settings.cells = 8;
  settings.bounds = Bounds{vec3(-1.0f), vec3(1.0f)};
  const Triangle inside{vec3(-0.5f), vec3(0.5f, -0.5f, 0.0f), vec3(0.0f, 0.5f, 0.0f)};
  const Triangle across{vec3(0.0f), vec3(9.0f, 0.0f, 0.0f), vec3(0.0f, 9.0f, 0.0f)};
  const Triangle beside{vec3(5.0f), vec3(6.0f, 5.0f, 5.0f), vec3(5.0f, 6.0f, 5.0f)};
  const BuiltScene built(sceneOf({inside, across, beside}), settings);
  EXPECT_EQ(built.staticReport.outside, 2u);
  bool sawAcross = false;
  forEachCell(built.grid.parameters, [&](const ivec3& cell) {
    for (uint32_t reference : storedReferences(built.grid, cell)) {
      EXPECT_NE(reference, 2u);
      sawAcross |= reference == 1;
    }
  });
  EXPECT_TRUE(sawAcross);
  expectNothingBroken(built);
}

TEST(Build, NeighbouringTrianglesWithBoxesOf256CellsLoseNoReference) {
  static constexpr int kShapes[][3] = {{256, 1, 1}, {1, 256, 1}, {1, 1, 256}, {16, 16, 1}, {1, 16, 16},
                                       {16, 1, 16}, {8, 8, 4},   {4, 8, 8},   {2, 2, 64}};
  for (const auto& shape : kShapes)
    for (uint32_t capacity : {16u, 32u, 128u}) {
      GridSettings settings;
      settings.cellEdge = 1.0f;
      settings.capacity = capacity;
      const vec3 low(0.1f), high = vec3(float(shape[0]), float(shape[1]), float(shape[2])) - 0.1f;
      std::vector<Triangle> triangles;
      for (int i = 0; i < 8; ++i) {
        const float shift = 0.01f * float(i);
        triangles.push_back({low + shift, vec3(high.x, high.y, low.z) - shift, vec3(low.x, (low.y + high.y) / 2, high.z) - shift});
      }
      const BuiltScene built(sceneOf(triangles), settings);
      EXPECT_EQ(built.staticReport.cellsExpected, 8u * 256u);
      EXPECT_EQ(built.staticReport.refused, 0u);
      forEachCell(built.grid.parameters,
                  [&](const ivec3& cell) { ASSERT_EQ(storedReferences(built.grid, cell), overlappingReferences(built, cell)); });
    }
}

TEST(Build, ATriangleAcrossTheDiagonalOfALargeGridLosesNothing) {
  GridSettings settings;
  settings.cells = 128;
  settings.capacity = 8;
  const Triangle across{vec3(0.0f), vec3(1.0f), vec3(1.0f, 0.9f, 0.0f)};
  const BuiltScene built(sceneOf({across}), settings);
  EXPECT_EQ(built.staticReport.cellsWalked, built.staticReport.cellsExpected);
  EXPECT_GT(built.staticReport.tried, 10000u);
  EXPECT_EQ(built.staticReport.refused, 0u);

  // Every point of it finds it in its cell.
  std::mt19937 random(9);
  std::uniform_real_distribution<float> number(0.0f, 1.0f);
  for (int i = 0; i < 20000; ++i) {
    float u = number(random), v = number(random);
    if (u + v > 1.0f) u = 1.0f - u, v = 1.0f - v;
    const vec3 point = across.a * (1.0f - u - v) + across.b * u + across.c * v;
    ASSERT_EQ(storedReferences(built.grid, gridCell(built.grid.parameters, point)), std::vector<uint32_t>{0});
  }
}

TEST(Build, NumberByAreaLosesTheSmallTriangles) {
  std::vector<Triangle> triangles(50, {vec3(0.0f), vec3(0.01f, 0.0f, 0.0f), vec3(0.0f, 0.01f, 0.0f)});
  triangles.push_back({vec3(-1.0f, 0.0f, -1.0f), vec3(1.0f, 0.1f, -1.0f), vec3(0.0f, 0.0f, 1.0f)});
  GridSettings settings;
  settings.cells = 10;
  settings.capacity = 8;
  settings.numberBy = NumberBy::area;
  const BuiltScene built(sceneOf(triangles), settings);
  const std::vector<uint32_t> references = storedReferences(built.grid, gridCell(built.grid.parameters, vec3(0.005f)));
  ASSERT_EQ(references.size(), 8u);
  EXPECT_EQ(nameTriangle(built.numbered, references[0]).triangle, 50u);
}

}  // namespace
}  // namespace gridscope
