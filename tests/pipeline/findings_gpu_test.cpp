// Views of what was found out about a frame: each paints what it was given, and nothing where it was given nothing.
#include <bit>
#include <optional>

#include "core/grid/cell_updates.h"
#include "core/pipeline/frame_truth.h"
#include "core/pipeline/stability.h"
#include "core/trace/cell_rays.h"
#include "shaders/shared/grid/slice.h"
#include "shaders/shared/views/truth_colours.h"
#include "tests/gpu_fixture.h"
#include "tests/lesson.h"
#include "views/view.h"

namespace gridscope {
namespace {

constexpr uint32_t kWidth = 96, kHeight = 54;

float valueOf(const ViewElement& element) { return std::bit_cast<float>(element.payload); }

class FindingsTest : public GpuTest {
 protected:
  FindingsTest() : scene_(makeBuiltInScene("saturated-cell")) {
    pipeline_.emplace(gpu(), scene_, lessonSettings(findBuiltInScene("saturated-cell"), scene_, kWidth, kHeight));
    makeFrame();
  }
  void makeFrame() {
    pipeline_->build();
    pipeline_->update(0.0f);
    pipeline_->gather();
    pipeline_->bounce(0);
    pipeline_->trace(true);
  }
  std::vector<ViewElement> view(std::string_view name) { return pipeline_->view(name, {}, findView(name)->needsGrid).elements; }

  Scene scene_;
  std::optional<Pipeline> pipeline_;
};

TEST_F(FindingsTest, WithoutFindingsTheirViewsShowNothingFound) {
  for (const View& one : allViews()) {
    if (one.need == ViewNeed::nothing) continue;
    SCOPED_TRACE(one.name);
    for (const ViewElement& element : view(one.name)) EXPECT_FALSE(element.kind == kElementValue && valueOf(element) != 0.0f);
  }
}

TEST_F(FindingsTest, VerdictCauseErrorAndLostPaintTheTruth) {
  const FrameTruth truth = tellFrame(*pipeline_);
  ASSERT_GT(truth.totals.differ(), 0u) << "the scene must have rays that differ";
  pipeline_->useTruths(truth.truths);
  std::vector<uint32_t> costs;
  for (const TriangleLoss& loss : makeLedger(truth).triangles) costs.push_back(loss.rays);
  pipeline_->useTriangleCosts(costs);

  const std::vector<ViewElement> verdict = view("verdict"), cause = view("cause"), error = view("error"), lost = view("lost");
  const std::vector<GatherPixel> seen = pipeline_->gatherPixels();
  const std::vector<Hit> hits = pipeline_->hits();
  for (size_t i = 0; i < truth.truths.size(); ++i) {
    const RayTruth& ray = truth.truths[i];
    const bool differs = ray.verdict > kVerdictAgrees;
    ASSERT_EQ(verdict[i].shadow, differs ? 0u : 170u) << "a third of the picture's light where rays agree";
    if (differs) {
      EXPECT_EQ(verdict[i].payload, packBytes(unpackColour(verdictColour(ray.verdict))));
    }
    if (differs && ray.cause != kCauseRefused) {
      EXPECT_EQ(cause[i].payload, packBytes(unpackColour(causeColour(ray.cause))));
    }
    ASSERT_EQ(cause[i].kind == kElementMarked, ray.cause == kCauseRefused);
    const bool both = ray.exactReference != kNoReference && (hits[i].kind == kHitTriangle || hits[i].kind == kHitVoxel);
    ASSERT_EQ(error[i].kind, both ? kElementValue : kElementNothing);
    if (both) {
      EXPECT_EQ(valueOf(error[i]), std::abs(ray.error));
    }
    if (seen[i].reference == kNoReference) continue;
    const uint32_t cost = costs[pipeline_->numbered().instances[referenceInstance(seen[i].reference)].firstWorldTriangle +
                                referenceTriangle(seen[i].reference)];
    ASSERT_EQ(lost[i].kind, cost > 0 ? kElementValue : kElementColour);
    if (cost > 0) {
      ASSERT_EQ(valueOf(lost[i]), float(cost));
    }
  }
}

TEST_F(FindingsTest, RaysShowsHowOftenEachCellOfALayerWasAsked) {
  const Grid grid = pipeline_->grid();
  const std::vector<Triangle> triangles = pipeline_->worldTriangles();
  const std::vector<CellRays> rays =
      countCellRays({grid, pipeline_->numbered(), triangles, pipeline_->parameters().trace}, pipeline_->rays());
  pipeline_->useCellRays(rays);
  uint64_t shown = 0, visits = 0;
  for (int layer = 0; layer < grid.parameters.cellCount.y; ++layer) {
    const Pipeline::ViewImage image = pipeline_->view("rays-slice", {1, layer}, false);
    for (uint32_t i = 0; i < image.elements.size(); ++i) {
      const CellRays& cell = rays[cellNumber(grid.parameters, sliceCell(grid.parameters.cellCount, 1, layer, i))];
      ASSERT_EQ(valueOf(image.elements[i]), float(cell.read > 0 ? cell.read : cell.empty));
      shown += cell.read + cell.empty;
    }
  }
  for (const RayCounters& counted : pipeline_->counters()) visits += counted.visits;
  EXPECT_EQ(shown, visits);
  float most = 0.0f;
  for (const ViewElement& element : view("rays")) most = std::max(most, element.kind == kElementValue ? valueOf(element) : 0.0f);
  EXPECT_GT(most, 1.0f);
}

TEST_F(FindingsTest, StabilityPaintsRaysBeforeCells) {
  std::vector<uint32_t> cells(cellCountOf(pipeline_->parameters().grid), kUnstable), rays(kWidth * kHeight, 0);
  rays[5] = 1;
  pipeline_->useStability(cells, rays);
  const std::vector<ViewElement> shown = view("stability");
  EXPECT_EQ(shown[5].payload, packBytes(unpackColour(kColourRayChanges)));
  const std::vector<GatherPixel> seen = pipeline_->gatherPixels();
  for (size_t i = 6; i < shown.size(); ++i) {
    const bool inGrid = gridContains(pipeline_->parameters().grid, gridCell(pipeline_->parameters().grid, seen[i].position));
    if (seen[i].reference == kNoReference || !inGrid) continue;
    ASSERT_EQ(shown[i].payload, packBytes(unpackColour(kColourSetDiffers)));
  }
}

TEST_F(FindingsTest, SortedBuildsAreAllAlikeAndFirstComeOnesKeepTheirCounts) {
  const auto rebuild = [&] { pipeline_->build(), pipeline_->update(0.0f); };
  const Stability sorted = compareBuilds(*pipeline_, 3, rebuild);
  EXPECT_EQ(sorted.builds, 3u);
  EXPECT_EQ(sorted.setDiffers + sorted.orderDiffers + sorted.raysChange, 0u);
  EXPECT_GT(sorted.occupied, 0u);

  FrameSettings settings = pipeline_->settings();
  settings.grid.insertion = kInsertionFirstCome;
  pipeline_.emplace(gpu(), scene_, settings);
  makeFrame();
  const uint64_t stored = pipeline_->gridTotals().stored();
  const Stability raced = compareBuilds(*pipeline_, 4, rebuild);
  EXPECT_EQ(pipeline_->gridTotals().stored(), stored);
  EXPECT_LE(raced.setDiffers + raced.orderDiffers, raced.occupied);
}

TEST_F(GpuTest, UpdatePaintsTheCellsThatTheMovedInstanceLeftAndEntered) {
  Scene scene = makeBuiltInScene("moving-crowd");
  Pipeline pipeline(gpu(), scene, lessonSettings(findBuiltInScene("moving-crowd"), scene, kWidth, kHeight));
  pipeline.build();
  pipeline.update(0.0f);
  const Grid before = pipeline.grid();
  pipeline.update(0.5f);
  pipeline.gather();
  pipeline.bounce(0);
  pipeline.trace(false);
  const std::vector<CellUpdate> updates = compareUpdate(before, pipeline.grid());
  pipeline.useCellUpdates(updates);

  const GridParameters& grid = pipeline.parameters().grid;
  uint32_t filled = 0, cleared = 0;
  for (int layer = 0; layer < grid.cellCount.y; ++layer) {
    const Pipeline::ViewImage image = pipeline.view("update-slice", {1, layer}, false);
    for (uint32_t i = 0; i < image.elements.size(); ++i) {
      const CellUpdate& update = updates[cellNumber(grid, sliceCell(grid.cellCount, 1, layer, i))];
      ASSERT_EQ(image.elements[i].kind, update.instance == kNoReference ? kElementNothing : kElementColour);
      cleared += update.cleared > 0 && update.filled == 0;
      if (update.filled == 0) continue;
      ++filled;
      ASSERT_EQ(image.elements[i].payload, packBytes(idColour(update.instance)));
    }
  }
  EXPECT_GT(filled, 0u);
  EXPECT_GT(cleared, 0u);
}

}  // namespace
}  // namespace gridscope
