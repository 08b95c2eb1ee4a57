// What the mouse takes hold of in the viewport: cells, and handles that are dragged.
#include <gtest/gtest.h>

#include "app/frame/pick_cell.h"
#include "app/model/drag_handle.h"
#include "core/trace/derive.h"
#include "tests/frame/small_frame.h"

namespace gridscope {
namespace {

CameraParameters testCamera() {
  CameraPose pose;
  pose.eye = vec3(2.0f, 2.0f, 9.0f);
  pose.target = vec3(2.0f, 2.0f, 0.0f);
  return deriveCamera(pose, 160, 90, 10.0f);
}

TEST(PickCell, AnEyeRayGoesThroughThePixelOfItsPoint) {
  const CameraParameters camera = testCamera();
  for (const vec2 pixel : {vec2(3, 4), vec2(80, 45), vec2(150, 88)}) {
    const EyeRay ray = eyeRay(camera, pixel);
    EXPECT_NEAR(glm::distance(projectPoint(camera, ray.origin + 4.0f * ray.direction)->pixel, pixel), 0.0f, 1e-3f);
  }
}

TEST(PickCell, ABoxIsEnteredAtItsFrontAndNotFromWithin) {
  const Bounds box{vec3(1, 1, 2), vec3(3, 3, 4)};
  EXPECT_FLOAT_EQ(*boxEntry({vec3(2, 2, 9), vec3(0, 0, -1)}, box), 5.0f);
  EXPECT_FALSE(boxEntry({vec3(2, 2, 9), vec3(0, 0, 1)}, box).has_value());
  EXPECT_FALSE(boxEntry({vec3(2, 2, 3), vec3(0, 0, -1)}, box).has_value());
  EXPECT_FALSE(boxEntry({vec3(4, 2, 9), vec3(0, 0, -1)}, box).has_value());
}

TEST(PickCell, TheNearestDrawnBoxBeforeTheSurfaceElseTheSurfacesCell) {
  SmallFrame small;
  const CameraParameters camera = testCamera();
  const vec2 pixel = projectPoint(camera, vec3(1.5f, 1.5f, 1.5f))->pixel;
  auto gather = std::make_shared<std::vector<GatherPixel>>(size_t(camera.width) * camera.height);
  for (GatherPixel& seen : *gather) seen.reference = kNoReference;
  GatherPixel& seen = (*gather)[size_t(pixel.y) * camera.width + size_t(pixel.x)];
  seen.reference = makeReference(0, 0), seen.position = vec3(1.5f, 1.5f, 1.5f), seen.depth = glm::distance(camera.eye, seen.position);
  small.frame.gather = gather;
  const ivec3 own = gridCell(small.frame.parameters.grid, seen.position);
  EXPECT_EQ(pickCell(small.frame, camera, pixel, {}), own) << "no box is drawn: the surface's cell";

  const std::vector<BoxCell> boxes{{{.cell = own + ivec3(0, 0, 1)}}, {{.cell = own}}, {{.cell = own + ivec3(1, 0, 0)}}};
  EXPECT_EQ(pickCell(small.frame, camera, pixel, boxes), own + ivec3(0, 0, 1)) << "the box before the surface is nearer";
  const std::vector<BoxCell> hidden{{{.cell = own - ivec3(0, 0, 3)}}};
  EXPECT_EQ(pickCell(small.frame, camera, pixel, hidden), own) << "the surface hides that box";
  EXPECT_EQ(pickCell(small.frame, camera, vec2(1, 1), {}), std::nullopt) << "nothing is seen there";
}

TEST(DragHandle, TheCentreFollowsTheMouse) {
  const CameraParameters camera = testCamera();
  const vec3 centre(2.5f, 1.0f, 3.0f), wanted(0.4f, -0.3f, 0.0f);
  const vec2 from = projectPoint(camera, centre)->pixel;
  const vec3 across = dragOffset(camera, centre, DragWay::plane, from, projectPoint(camera, centre + wanted)->pixel);
  EXPECT_NEAR(glm::distance(across, wanted), 0.0f, 1e-3f);
  const vec3 along = dragOffset(camera, centre, DragWay::x, from, projectPoint(camera, centre + vec3(0.7f, 0.0f, 0.0f))->pixel);
  EXPECT_NEAR(glm::distance(along, vec3(0.7f, 0.0f, 0.0f)), 0.0f, 1e-3f);
  const vec3 far = dragOffset(camera, centre, DragWay::z, from, projectPoint(camera, centre + vec3(0.0f, 0.0f, 1.2f))->pixel);
  EXPECT_NEAR(far.z, 1.2f, 1e-2f);
  EXPECT_EQ(dragOffset(camera, vec3(2.0f, 2.0f, 3.0f), DragWay::z, vec2(80, 45), vec2(80, 45)), vec3(0.0f)) << "the axis points at the eye";
}

}  // namespace
}  // namespace gridscope
