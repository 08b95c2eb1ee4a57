// Where a frame lies in a pane, and what stands over it: read-outs, callouts, the side that the axes show.
#include <gtest/gtest.h>

#include "app/frame/callout_place.h"
#include "app/frame/camera_moves.h"
#include "app/frame/projection.h"
#include "app/frame/read_out.h"
#include "app/frame/viewport_place.h"
#include "core/trace/derive.h"

namespace gridscope {
namespace {

const vec2 kFrame(640, 360), kPane(1000, 500);

vec2 placeOfPixel(const ViewportPlace& place, vec2 pixel) {
  const PlacedFrame placed = placeFrame(place, kFrame, kPane);
  return placed.origin + pixel * placed.scale;
}

TEST(ViewportPlace, AFittedFrameIsCentredAndWhole) {
  const PlacedFrame placed = placeFrame({}, kFrame, kPane);
  EXPECT_FLOAT_EQ(placed.scale, 500.0f / 360.0f);
  EXPECT_NEAR(placed.origin.y, 0.0f, 1e-3f);
  EXPECT_NEAR(placed.origin.x, 0.5f * (1000.0f - 640.0f * placed.scale), 1e-3f);
}

TEST(ViewportPlace, ZoomingKeepsWhatIsUnderTheMouse) {
  const vec2 mouse(700, 120), pixel = (mouse - placeFrame({}, kFrame, kPane).origin) / placeFrame({}, kFrame, kPane).scale;
  const ViewportPlace zoomed = zoomedAt({}, kFrame, kPane, mouse, 6.0f);
  EXPECT_GT(zoomed.zoom, 3.0f);
  EXPECT_NEAR(glm::distance(placeOfPixel(zoomed, pixel), mouse), 0.0f, 0.01f);
  EXPECT_EQ(zoomedAt(zoomed, kFrame, kPane, mouse, -20.0f).zoom, 0.0f) << "not smaller than fitted";
  EXPECT_LE(zoomedAt(zoomed, kFrame, kPane, mouse, 100.0f).zoom, kMostZoom);
}

TEST(ViewportPlace, APixelOutOfSightComesToTheMiddleAndOneInSightMovesNothing) {
  const ViewportPlace zoomed{8.0f, vec2(0.25f, 0.25f)};
  const vec2 seen = vec2(0.25f) * kFrame + vec2(30, 20), unseen(600.5f, 300.5f);
  EXPECT_EQ(showingPixel(zoomed, kFrame, kPane, seen).centre, zoomed.centre);
  EXPECT_NEAR(glm::distance(placeOfPixel(showingPixel(zoomed, kFrame, kPane, unseen), unseen), 0.5f * kPane), 0.0f, 0.01f);
  EXPECT_EQ(showingPixel({}, kFrame, kPane, unseen).zoom, 0.0f) << "a fitted frame shows every pixel";
}

TEST(ViewportPlace, AFrameOfAnotherSizeCoversTheSamePart) {
  const ViewportPlace place{6.0f, vec2(0.3f, 0.6f)};
  const vec2 other = 0.5f * kFrame;
  const PlacedFrame a = placeFrame(place, kFrame, kPane), b = placeFrame(placeForSize(place, kFrame, other), other, kPane);
  EXPECT_NEAR(glm::distance(a.origin, b.origin), 0.0f, 0.01f);
  EXPECT_FLOAT_EQ(a.scale * kFrame.x, b.scale * other.x);
}

TEST(ReadOut, WhatDoesNotFitGoesToTheNextLineAndThenIsLeftOut) {
  const std::vector<std::string> parts{"pixel 24, 71", "1 cells", "cell 20, 14, 110", "columns, triangle 3,282", "depth 4.84"};
  EXPECT_EQ(readOutLines(parts, 200, 2).size(), 1u);
  const std::vector<std::string> two = readOutLines(parts, 50, 2);
  ASSERT_EQ(two.size(), 2u);
  for (const std::string& line : two) EXPECT_LE(line.size(), 50u);
  EXPECT_TRUE(two[1].starts_with("columns, triangle 3,282"));
  EXPECT_TRUE(two[1].ends_with("depth 4.84"));
  const std::vector<std::string> one = readOutLines(parts, 50, 1);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_TRUE(one[0].ends_with("cell 20, 14, 110")) << one[0];
}

TEST(Callout, StaysInThePaneAndOffTheRay) {
  const Area pane{vec2(0.0f), vec2(900, 500)};
  const vec2 size(130, 46), at(450, 250);
  std::vector<vec2> ray;
  for (int i = 0; i <= 80; ++i) ray.push_back(at + vec2(5.0f, 2.0f) * float(i - 40));
  const vec2 low = placeCallout(pane, at, size, ray, {}, 1.0f);
  for (const vec2& point : ray) EXPECT_FALSE(point.x > low.x && point.y > low.y && point.x < low.x + size.x && point.y < low.y + size.y);
  const std::vector<Area> taken{{low - 10.0f, low + size + 10.0f}};
  const vec2 second = placeCallout(pane, at, size, ray, taken, 1.0f);
  EXPECT_FALSE(second.x < taken[0].high.x && taken[0].low.x < second.x + size.x && second.y < taken[0].high.y &&
               taken[0].low.y < second.y + size.y)
      << "the second callout does not cover the first";
  for (const vec2 corner : {vec2(2, 2), vec2(898, 3), vec2(1, 499), vec2(899, 499)}) {
    const vec2 there = placeCallout(pane, corner, size, ray, {}, 1.0f);
    EXPECT_TRUE(there.x >= 0 && there.y >= 0 && there.x + size.x <= 900 && there.y + size.y <= 500);
  }
}

TEST(Camera, TheEndThatOneLooksFromAlreadyLeadsToTheOther) {
  CameraState camera;
  camera.pose.eye = vec3(3, 2, 5);
  camera.pose.target = vec3(0, 1, 0);
  const auto back = [&] { return glm::normalize(camera.pose.eye - camera.pose.target); };
  lookAlongOrBack(camera, 0, true);
  EXPECT_NEAR(back().x, 1.0f, 1e-5f);
  lookAlongOrBack(camera, 0, true);
  EXPECT_NEAR(back().x, -1.0f, 1e-5f);
  lookAlongOrBack(camera, 2, false);
  EXPECT_NEAR(back().z, -1.0f, 1e-5f);
  lookAlongOrBack(camera, 1, true);
  EXPECT_GT(back().y, 0.99f);
  lookAlongOrBack(camera, 1, true);
  EXPECT_LT(back().y, -0.99f);
}

TEST(Camera, APointThatOneOrbitsAroundStaysInItsPlace) {
  CameraState camera;
  camera.pose.eye = vec3(3, 2, 5);
  camera.pose.target = vec3(0, 1, 0);
  const vec3 pivot(1.0f, 1.4f, 1.0f);
  const auto place = [&] { return projectPoint(deriveCamera(camera.pose, 160, 90, 10.0f), pivot)->pixel; };
  const vec2 before = place();
  const float distance = glm::distance(camera.pose.eye, pivot);
  for (const auto& [turn, rise] : {std::pair{0.7f, 0.2f}, std::pair{-1.9f, -0.6f}, std::pair{0.1f, 3.0f}, std::pair{2.0f, -5.0f}}) {
    orbitAround(camera, pivot, turn, rise);
    EXPECT_NEAR(glm::distance(place(), before), 0.0f, 0.05f);
    EXPECT_NEAR(glm::distance(camera.pose.eye, pivot), distance, 1e-3f);
  }
  CameraState a, b;
  a.pose.eye = b.pose.eye = vec3(3, 2, 5);
  a.pose.target = b.pose.target = vec3(0, 1, 0);
  orbitCamera(a, 0.4f, 0.3f);
  orbitAround(b, b.pose.target, 0.4f, 0.3f);
  EXPECT_NEAR(glm::distance(a.pose.eye, b.pose.eye), 0.0f, 1e-4f);
}

}  // namespace
}  // namespace gridscope
