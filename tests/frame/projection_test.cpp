// What is drawn over the viewport lands on the pixels that the gather buffer has for it.
#include <gtest/gtest.h>

#include <random>

#include "app/frame/cell_boxes.h"
#include "app/frame/projection.h"
#include "core/trace/derive.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

CameraParameters testCamera() {
  CameraPose pose;
  pose.eye = vec3(1.0f, 2.0f, 5.0f);
  pose.target = vec3(0.0f, 1.0f, 0.0f);
  return deriveCamera(pose, 160, 90, 10.0f);
}

// The point at a distance through a place of the frame, as shaders/pipeline/gather_resolve.comp has it.
vec3 pointThrough(const CameraParameters& camera, vec2 pixel, float distance) {
  const vec2 place = pixel / vec2(camera.width, camera.height) * 2.0f - 1.0f;
  const vec3 way = camera.forward + camera.right * (place.x * camera.tanHalfWidth) - camera.up * (place.y * camera.tanHalfHeight);
  return camera.eye + glm::normalize(way) * distance;
}

TEST(Projection, APointLandsOnThePixelThatItWasSeenThrough) {
  const CameraParameters camera = testCamera();
  for (const vec2 pixel : {vec2(0.5f), vec2(80.0f, 45.0f), vec2(159.5f, 3.25f), vec2(40.0f, 89.0f)}) {
    const auto point = projectPoint(camera, pointThrough(camera, pixel, 3.0f));
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR(point->pixel.x, pixel.x, 1e-3f);
    EXPECT_NEAR(point->pixel.y, pixel.y, 1e-3f);
    EXPECT_NEAR(point->depth, 3.0f, 1e-4f);
  }
  EXPECT_FALSE(projectPoint(camera, camera.eye - camera.forward).has_value());
}

TEST(Projection, ALineThroughTheEyesPlaneIsCutAtTheNearPlane) {
  const CameraParameters camera = testCamera();
  const WorldLine line{camera.eye - camera.forward + camera.right * 0.1f, camera.eye + camera.forward * 4.0f + camera.right * 0.1f};
  const auto kept = clipToView(camera, line);
  ASSERT_TRUE(kept.has_value());
  EXPECT_GE(glm::dot(kept->a - camera.eye, camera.forward), camera.nearPlane * 0.999f);
  EXPECT_NEAR(glm::length(kept->b - line.b), 0.0f, 1e-5f);
  EXPECT_FALSE(clipToView(camera, {line.a, line.a - camera.forward}).has_value());
}

TEST(Projection, EveryClippedLineHasFinitePixelsNearTheFrame) {
  const CameraParameters camera = testCamera();
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    const auto line = projectWhole(camera, {randomPoint(random, -20.0f, 20.0f), randomPoint(random, -20.0f, 20.0f)});
    if (!line) continue;
    for (const ProjectedPoint& point : {line->a, line->b}) {
      ASSERT_TRUE(std::isfinite(point.pixel.x) && std::isfinite(point.pixel.y));
      ASSERT_LT(std::abs(point.pixel.x), 5.0f * 160.0f);
      ASSERT_LT(std::abs(point.pixel.y), 5.0f * 90.0f);
    }
  }
}

TEST(Projection, SurfacesHideTheFarPartOfALine) {
  const CameraParameters camera = testCamera();
  std::vector<GatherPixel> gather(160 * 90);
  for (uint32_t i = 0; i < gather.size(); ++i) {
    gather[i].reference = i % 160 < 80 ? 0u : kNoReference;  // a wall on the left half, the sky on the right
    gather[i].depth = 3.0f;
  }
  const WorldLine across{pointThrough(camera, {20.0f, 45.0f}, 4.0f), pointThrough(camera, {140.0f, 45.0f}, 4.0f)};
  const std::vector<ProjectedLine> pieces = projectLine(camera, gather, across, 0.01f);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_TRUE(pieces[0].hidden);
  EXPECT_FALSE(pieces[1].hidden);
  EXPECT_NEAR(pieces[0].b.pixel.x, 80.0f, 3.0f);
  EXPECT_EQ(pieces[0].b.pixel, pieces[1].a.pixel);

  const WorldLine before{pointThrough(camera, {20.0f, 45.0f}, 2.0f), pointThrough(camera, {70.0f, 45.0f}, 2.0f)};
  ASSERT_EQ(projectLine(camera, gather, before, 0.01f).size(), 1u);
  EXPECT_FALSE(projectLine(camera, gather, before, 0.01f)[0].hidden);
  EXPECT_EQ(projectLine(camera, {}, across, 0.01f).size(), 1u);
}

TEST(Projection, ALineIntoTheDepthIsCutWhereItEntersTheSurface) {
  const CameraParameters camera = testCamera();
  std::vector<GatherPixel> gather(160 * 90);
  for (GatherPixel& pixel : gather) pixel.reference = 0, pixel.depth = 3.0f;
  const WorldLine line{pointThrough(camera, {20.0f, 45.0f}, 1.0f), pointThrough(camera, {140.0f, 45.0f}, 9.0f)};
  const std::vector<ProjectedLine> pieces = projectLine(camera, gather, line, 0.0f);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(pieces[0].b.depth, 3.0f, 0.2f);
}

TEST(Projection, ABoxHasTwelveEdgesOfItsOwnLength) {
  const Bounds box{vec3(1.0f, 2.0f, 3.0f), vec3(2.0f, 4.0f, 7.0f)};
  float sum = 0.0f;
  for (const WorldLine& edge : boxEdges(box)) sum += glm::length(edge.b - edge.a);
  EXPECT_FLOAT_EQ(sum, 4.0f * (1.0f + 2.0f + 4.0f));
}

TEST(Projection, BoundsCutALineAtBothFaces) {
  const Bounds box{vec3(0.0f), vec3(1.0f)};
  const auto kept = clipToBounds(box, {vec3(-1.0f, 0.5f, 0.5f), vec3(2.0f, 0.5f, 0.5f)});
  ASSERT_TRUE(kept.has_value());
  EXPECT_NEAR(kept->a.x, 0.0f, 1e-6f);
  EXPECT_NEAR(kept->b.x, 1.0f, 1e-6f);
  EXPECT_FALSE(clipToBounds(box, {vec3(-1.0f, 2.0f, 0.5f), vec3(2.0f, 2.0f, 0.5f)}).has_value());
}

TEST(CellBoxes, NeighboursShareTheirEdges) {
  GridParameters grid{};
  grid.cellEdge = 1.0f;
  grid.cellCount = ivec3(4);
  const std::vector<BoxCell> cells{{{.cell = ivec3(1), .stored = 3}},
                                   {{.cell = ivec3(2, 1, 1), .stored = 5, .refused = 2, .saturated = true}}};
  const std::vector<BoxEdge> edges = boxEdgesOf(cells, grid, boxMeasures()[0]);
  EXPECT_EQ(edges.size(), 20u);
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const BoxEdge& edge) { return edge.saturated; }), 12);
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const BoxEdge& edge) { return edge.value == 3; }), 8);
}

TEST(CellBoxes, TheNearestInViewAndInRangeAreChosen) {
  GridParameters grid{};
  grid.origin = vec3(-8.0f);
  grid.cellEdge = 1.0f;
  grid.inverseCellEdge = 1.0f;
  grid.cellCount = ivec3(16);
  const CameraParameters camera = testCamera();
  std::vector<BoxCell> cells;
  forEachCell(grid, [&](const ivec3& cell) {
    cells.push_back({{.cell = cell, .stored = uint32_t(cell.z)}, {.read = 100u + uint32_t(cell.x), .empty = 0}});
  });
  Overlays overlays;
  EXPECT_EQ(chooseBoxes(cells, grid, overlays, camera, 10).wanted, 0u) << "nothing is switched on";
  overlays.cellBoxes = true;
  overlays.boxRange = {2, 6};
  const BoxChoice choice = chooseBoxes(cells, grid, overlays, camera, 10);
  ASSERT_EQ(choice.cells.size(), 10u);
  EXPECT_GT(choice.wanted, 10u);
  float last = 0.0f;
  for (const BoxCell& cell : choice.cells) {
    EXPECT_GE(cell.full.tried(), 2u);
    EXPECT_LE(cell.full.tried(), 6u);
    const float distance = glm::length(gridCellCentre(grid, cell.full.cell) - camera.eye);
    EXPECT_GE(distance, last);
    last = distance;
  }
}

TEST(CellBoxes, AMeasureOfRaysChoosesByRays) {
  GridParameters grid{};
  grid.origin = vec3(-8.0f);
  grid.cellEdge = 1.0f;
  grid.inverseCellEdge = 1.0f;
  grid.cellCount = ivec3(16);
  std::vector<BoxCell> cells;
  forEachCell(grid, [&](const ivec3& cell) {
    cells.push_back({{.cell = cell, .stored = 4}, {.read = 100u + uint32_t(cell.x), .empty = 0}});
  });
  Overlays overlays;
  overlays.cellBoxes = true;
  for (size_t i = 0; i < boxMeasures().size(); ++i) {
    if (!boxMeasures()[i].ofRays || boxMeasures()[i].value(cells[0]) == 0) continue;
    overlays.boxMeasure = i;
    overlays.boxRange = {103, 104};
    const BoxChoice choice = chooseBoxes(cells, grid, overlays, testCamera(), 5000);
    EXPECT_FALSE(choice.cells.empty());
    for (const BoxCell& cell : choice.cells) EXPECT_TRUE(cell.full.cell.x == 3 || cell.full.cell.x == 4);
    cells.back().rays.read = 100000;
    EXPECT_EQ(boxTop(boxMeasures()[i], cells, 32), 115.0f) << "the top hundredth is left out";
    EXPECT_EQ(boxEdgesOf(std::span(cells).subspan(0, 1), grid, boxMeasures()[i])[0].value, 100u);
    return;
  }
  FAIL() << "no measure counts rays that read a cell";
}

}  // namespace
}  // namespace gridscope
