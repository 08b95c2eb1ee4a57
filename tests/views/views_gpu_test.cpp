// Every view, headless: each runs, and what it shows is what the products say.
#include "views/view.h"

#include <bit>
#include <cstring>
#include <optional>
#include <set>

#include "core/pipeline/pipeline.h"
#include "shaders/shared/grid/slice.h"
#include "shaders/shared/scene/triangle.h"
#include "shaders/shared/views/palette.h"
#include "tests/gpu_fixture.h"
#include "tests/grid_words.h"
#include "tests/lesson.h"
#include "views/picture.h"

namespace gridscope {
namespace {

float valueOf(const ViewElement& element) { return std::bit_cast<float>(element.payload); }

// One frame of the saturated cell: triangle hits, voxel hits and misses, all counted.
class ViewsTest : public GpuTest {
 protected:
  ViewsTest() : scene_(makeBuiltInScene("saturated-cell")) {
    pipeline_.emplace(gpu(), scene_, lessonSettings(findBuiltInScene("saturated-cell"), scene_, 96, 54));
    pipeline_->build();
    pipeline_->update(0.0f);
    pipeline_->gather();
    pipeline_->bounce(0);
    pipeline_->trace(true);
  }

  Scene scene_;
  std::optional<Pipeline> pipeline_;
};

TEST_F(ViewsTest, EveryViewOfTheListGivesAPictureThatIsNotOfOneColour) {
  for (const View& view : allViews()) {
    if (view.need != ViewNeed::nothing) continue;
    SCOPED_TRACE(view.name);
    Pipeline::ViewImage image = pipeline_->view(view.name, {}, view.needsGrid);
    ViewPictureSettings settings;
    settings.capacity = pipeline_->settings().grid.capacity;
    settings.frameWidth = 96;
    settings.frameHeight = 54;
    Picture picture = makeViewPicture(view, image.elements, image.width, image.height, settings).picture;
    std::set<uint32_t> colours;
    for (size_t i = 0; i + 3 < picture.rgba.size(); i += 4)
      colours.insert(uint32_t(picture.rgba[i]) | uint32_t(picture.rgba[i + 1]) << 8 | uint32_t(picture.rgba[i + 2]) << 16);
    EXPECT_GT(colours.size(), 2u);
  }
}

TEST_F(ViewsTest, RayViewsShowCountersAndHits) {
  std::vector<RayCounters> counters = pipeline_->counters();
  std::vector<Hit> hits = pipeline_->hits();
  std::vector<ViewElement> visits = pipeline_->view("visits").elements, tests = pipeline_->view("tests").elements;
  std::vector<ViewElement> distance = pipeline_->view("hit-distance").elements, kind = pipeline_->view("hit-kind").elements;
  std::set<uint32_t> kinds;
  for (size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].kind == kHitNoRay) {
      EXPECT_EQ(visits[i].kind, kElementNothing);
      continue;
    }
    kinds.insert(hits[i].kind);
    ASSERT_EQ(valueOf(visits[i]), float(counters[i].visits));
    ASSERT_EQ(valueOf(tests[i]), float(counters[i].tests));
    bool met = hits[i].kind == kHitTriangle || hits[i].kind == kHitVoxel;
    if (met) {
      ASSERT_EQ(valueOf(distance[i]), hits[i].t);
    }
    uint32_t colour = hits[i].kind == kHitTriangle ? kColourTriangleHit : hits[i].kind == kHitVoxel ? kColourVoxelHit : kColourMiss;
    ASSERT_EQ(kind[i].payload, packBytes(unpackColour(colour)));
  }
  EXPECT_EQ(kinds, (std::set<uint32_t>{kHitTriangle, kHitVoxel, kHitMiss})) << "the scene must show all three";
}

TEST_F(ViewsTest, SliceShowsEachCellOfItsLayerAndMarksTheSaturatedOnes) {
  Grid grid = pipeline_->grid();
  ivec3 cells = grid.parameters.cellCount;
  uint32_t marked = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int layer = 0; layer < cells[axis]; ++layer) {
      Pipeline::ViewImage image = pipeline_->view("slice", {axis, layer});
      for (uint32_t i = 0; i < image.elements.size(); ++i) {
        ivec3 cell = sliceCell(cells, axis, layer, i);
        int stored = 0;
        while (stored < grid.parameters.capacity && slotAt(grid, cell, stored) != kNoReference) ++stored;
        bool saturated = refusedAt(grid, cell, false) + refusedAt(grid, cell, true) > 0;
        ASSERT_EQ(valueOf(image.elements[i]), float(stored));
        ASSERT_EQ(image.elements[i].kind, saturated ? kElementMarked : kElementValue);
        marked += saturated;
      }
    }
  EXPECT_EQ(marked, 3 * pipeline_->gridTotals().statistics.saturated);
  EXPECT_GT(marked, 0u);
}

// Does a cell hold the reference, or has it refused some?
bool explains(const Grid& grid, ivec3 cell, uint32_t reference, float occupancy, bool marked) {
  if (!gridContains(grid.parameters, cell)) return false;
  int stored = 0;
  bool holds = false;
  for (; stored < grid.parameters.capacity && slotAt(grid, cell, stored) != kNoReference; ++stored)
    holds = holds || slotAt(grid, cell, stored) == reference;
  bool saturated = refusedAt(grid, cell, false) > 0;
  return (holds || saturated) && occupancy == float(stored) && marked == saturated;
}

TEST_F(ViewsTest, SurfaceViewsShowACellThatHoldsTheSurfacesTriangleOrRefusedIt) {
  Grid grid = pipeline_->grid();
  std::vector<GatherPixel> pixels = pipeline_->gatherPixels();
  std::vector<ViewElement> occupancy = pipeline_->view("occupancy").elements, saturation = pipeline_->view("saturation").elements;
  uint32_t saturatedPixels = 0;
  for (size_t i = 0; i < pixels.size(); ++i) {
    if (pixels[i].reference == kNoReference) continue;
    bool marked = occupancy[i].kind == kElementMarked, explained = false;
    for (float side : {0.0f, -1e-3f, 1e-3f}) {
      vec3 point = pixels[i].position + pixels[i].geometricNormal * (side * grid.parameters.cellEdge);
      explained |= explains(grid, gridCell(grid.parameters, point), pixels[i].reference, valueOf(occupancy[i]), marked);
    }
    EXPECT_TRUE(explained) << "pixel " << i;
    EXPECT_EQ(saturation[i].kind == kElementMarked, marked);
    saturatedPixels += marked;
  }
  EXPECT_GT(saturatedPixels, 0u);
}

TEST_F(ViewsTest, GatheredSurfacesLieOnTheirTriangles) {
  std::vector<Triangle> triangles = pipeline_->worldTriangles();
  for (const GatherPixel& pixel : pipeline_->gatherPixels()) {
    if (pixel.reference == kNoReference) continue;
    const Instance& instance = pipeline_->numbered().instances[referenceInstance(pixel.reference)];
    const Triangle& triangle = triangles[instance.firstWorldTriangle + referenceTriangle(pixel.reference)];
    vec3 normal = glm::normalize(triangleNormal(triangle));
    EXPECT_NEAR(glm::dot(normal, pixel.position - triangle.a), 0.0f, 1e-4f);
    EXPECT_NEAR(std::abs(glm::dot(normal, pixel.geometricNormal)), 1.0f, 1e-4f);
    EXPECT_GE(glm::dot(pixel.shadingNormal, pixel.geometricNormal), 0.0f);
    EXPECT_EQ(pixel.material, instance.material);
  }
}

TEST_F(ViewsTest, BouncedRaysLeaveTheirSurfaces) {
  std::vector<GatherPixel> pixels = pipeline_->gatherPixels();
  std::vector<Ray> rays = pipeline_->rays();
  for (size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(rays[i].valid != 0, pixels[i].reference != kNoReference);
    if (!rays[i].valid) continue;
    EXPECT_NEAR(glm::length(rays[i].direction), 1.0f, 1e-5f);
    EXPECT_GE(glm::dot(rays[i].direction, pixels[i].geometricNormal), 0.0f);
    EXPECT_EQ(rays[i].launchNormal, pixels[i].geometricNormal);
  }
}

TEST_F(ViewsTest, TheSameSeedGivesTheSameRaysAndAnotherDoesNot) {
  std::vector<Ray> first = pipeline_->rays();
  pipeline_->bounce(0);
  std::vector<Ray> again = pipeline_->rays();
  pipeline_->setBounce({.seed = 2});
  pipeline_->bounce(0);
  std::vector<Ray> other = pipeline_->rays();
  EXPECT_EQ(0, std::memcmp(first.data(), again.data(), first.size() * sizeof(Ray)));
  EXPECT_NE(0, std::memcmp(first.data(), other.data(), first.size() * sizeof(Ray)));
}

}  // namespace
}  // namespace gridscope
