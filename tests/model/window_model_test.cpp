// What the window makes of a person's wishes: a kept frame beside the live one, the ray held while the camera goes on, steps, edits of instances.
#include <gtest/gtest.h>

#include "app/frame/instance_edits.h"
#include "app/model/comparison.h"
#include "app/model/flow.h"
#include "app/model/held_ray.h"
#include "app/model/ray_stepping.h"
#include "app/model/stale_values.h"
#include "core/trace/derive.h"
#include "tests/frame/small_frame.h"
#include "views/view.h"

namespace gridscope {
namespace {

// A model that shows the small frame, with a record of pixel 1.
struct SmallModel {
  SmallFrame small;
  WindowModel model;

  SmallModel() {
    small.frame.parameters.trace = deriveTrace({}, small.frame.parameters.grid);
    small.frame.record = std::make_shared<const RecordedRay>(record());
    model.request = small.frame.request;
    model.camera.pose = small.frame.request.settings->camera;
    model.selection.selectPixel(1);
    show();
  }
  RecordedRay record() const {
    RecordedRay ray{.pixel = 1, .ray = {vec3(1.5f, 1.55f, 2.9f), vec3(0, 0, -1), vec3(0, 0, -1), 1}};
    ray.record =
        recordRay({*small.frame.grid, small.frame.scene->numbered, *small.frame.worldTriangles, small.frame.parameters.trace}, ray.ray);
    return ray;
  }
  std::shared_ptr<FrameSnapshot> copy() const { return std::make_shared<FrameSnapshot>(small.frame); }
  void show() { model.frame = copy(); }
};

std::shared_ptr<const Pipeline::ViewImage> someImage() { return std::make_shared<const Pipeline::ViewImage>(); }

TEST(Comparison, TheKeptFrameTakesTheViewsThatItLacksAndThenAsksForNoMore) {
  SmallModel m;
  m.small.frame.views["final"] = someImage();
  m.show();
  keepFrame(m.model);
  EXPECT_EQ(m.model.layout, ViewportLayout::compare);
  EXPECT_TRUE(requestOf(m.model).views.contains("depth"));
  EXPECT_FALSE(requestOf(m.model).views.contains("verdict")) << "the truth was not told: it is not asked for";
  for (const std::string& name : viewsToKeep(m.model)) m.small.frame.views[name] = someImage();
  takeFrame(m.model, m.copy());
  EXPECT_FALSE(m.model.comparison.completing);
  EXPECT_TRUE(m.model.comparison.kept->views.contains("depth"));
  EXPECT_FALSE(requestOf(m.model).views.contains("depth"));
}

TEST(Comparison, AnotherFramesViewsDoNotEnterTheKeptOne) {
  SmallModel m;
  keepFrame(m.model);
  ASSERT_TRUE(m.model.comparison.completing);
  m.small.frame.views["depth"] = someImage();
  m.small.frame.request.settings->grid.capacity = 7;
  takeFrame(m.model, m.copy());
  EXPECT_FALSE(m.model.comparison.completing);
  EXPECT_FALSE(m.model.comparison.kept->views.contains("depth"));
}

TEST(Comparison, TheKeptFrameOutlivesItsScene) {
  SmallModel m;
  keepFrame(m.model);
  const auto kept = m.model.comparison.kept;
  m.small.frame.request.source.scene = "another";
  takeFrame(m.model, m.copy());
  EXPECT_EQ(m.model.comparison.kept, kept);
}

TEST(Comparison, ALabelNamesWhatDiffers) {
  SmallFrame a, b;
  a.frame.request.settings->grid.capacity = 32;
  b.frame.request.settings->grid.capacity = 16;
  b.frame.request.settings->trace.gapFill = false;
  EXPECT_EQ(frameLabel(b.frame, a.frame), "capacity 16, gap-fill off");
  EXPECT_EQ(frameLabel(b.frame, a.frame, 1), "capacity 16, 1 more");
  EXPECT_EQ(frameLabel(a.frame, a.frame), "");
  auto facts = std::make_shared<SceneFacts>(*b.frame.scene);
  facts->path = "hall.gridcap", facts->name = "hall.gridcap";
  b.frame.scene = facts;
  EXPECT_EQ(frameLabel(b.frame, a.frame), "hall.gridcap, capacity 16, gap-fill off");
}

TEST(Comparison, APixelKeepsItsPlaceInAnotherSize) {
  EXPECT_EQ(pixelInSize({5, 3}, {640, 360}, {640, 360}), 3u * 640 + 5);
  EXPECT_EQ(pixelInSize({320, 180}, {640, 360}, {320, 180}), 90u * 320 + 160);
  EXPECT_EQ(pixelInSize({639, 359}, {640, 360}, {16, 9}), 16u * 9 - 1);
}

TEST(HeldRay, StaysWhenTheCameraMovesAndGoesWithAnotherPixel) {
  SmallModel m;
  holdRay(m.model);
  EXPECT_FALSE(rayIsHeld(m.model));
  const auto own = shownRay(m.model);
  ASSERT_NE(own, nullptr);

  m.model.camera.pose.eye += vec3(1, 0, 0);
  m.small.frame.record.reset();
  m.small.frame.request.settings->camera = m.model.camera.pose;
  m.show();
  holdRay(m.model);
  EXPECT_TRUE(rayIsHeld(m.model));
  EXPECT_EQ(shownRay(m.model), own);
  EXPECT_FALSE(requestOf(m.model).recordPixel.has_value()) << "the pixel of the present camera has another ray";

  returnToRay(m.model);
  EXPECT_FALSE(rayIsHeld(m.model));
  EXPECT_EQ(requestOf(m.model).recordPixel, 1u);

  m.model.camera.pose.eye += vec3(1, 0, 0);
  m.model.selection.selectPixel(2);
  holdRay(m.model);
  EXPECT_FALSE(rayIsHeld(m.model));
  EXPECT_EQ(shownRay(m.model), nullptr);
}

TEST(HeldRay, GoesThroughAnotherGridAgain) {
  SmallModel m;
  holdRay(m.model);
  m.model.camera.pose.eye += vec3(1, 0, 0);
  const size_t tests = shownRay(m.model)->record.steps.size();
  ASSERT_GT(tests, 0u);
  auto grid = std::make_shared<Grid>(*m.small.frame.grid);
  std::fill(grid->words.begin(), grid->words.end(), kNoReference);
  m.small.frame.grid = grid;
  m.show();
  holdRay(m.model);
  ASSERT_TRUE(rayIsHeld(m.model));
  for (const StepRecord& step : shownRay(m.model)->record.steps) EXPECT_NE(step.outcome, kStepRead) << "the grid is empty now";
}

TEST(RayStepping, ASearchThatFindsNoneSaysSo) {
  SmallModel m;
  holdRay(m.model);
  stepLast(m.model);
  const Selection before = m.model.selected();
  EXPECT_FALSE(stepToNext(m.model, StepSearch::tested));
  EXPECT_EQ(m.model.selected(), before);
  ASSERT_FALSE(m.model.log.empty());
  EXPECT_EQ(m.model.log.back().text, noSuchStep(StepSearch::tested));
}

TEST(RayStepping, TheCameraFollowsTheStepsAndTheRayIsHeld) {
  SmallModel m;
  holdRay(m.model);
  m.model.followStep = true;
  const float distance = glm::distance(m.model.camera.pose.eye, m.model.camera.pose.target);
  stepLast(m.model);
  followStep(m.model);
  const auto ray = shownRay(m.model);
  const vec3 start = ray->ray.origin + ray->ray.direction * ray->record.steps.back().start;
  EXPECT_NEAR(glm::distance(m.model.camera.pose.target, start), 0.0f, 1e-5f);
  EXPECT_NEAR(glm::distance(m.model.camera.pose.eye, m.model.camera.pose.target), distance, 1e-4f);
  EXPECT_TRUE(rayIsHeld(m.model));
}

TEST(StaleValues, AreThoseWhoseStagesRunAgain) {
  SmallModel m;
  m.small.frame.demand =
      std::make_shared<const Demand>(m.small.frame.parameters.grid, m.small.frame.scene->numbered, *m.small.frame.worldTriangles);
  m.show();
  EXPECT_FALSE(staleValues(m.model).grid || staleValues(m.model).rays);
  m.model.request.settings->trace.gate = 3.0f;
  EXPECT_TRUE(staleValues(m.model).rays && staleValues(m.model).steps);
  EXPECT_FALSE(staleValues(m.model).grid);
  m.model.request.settings->grid.capacity = 5;
  EXPECT_TRUE(staleValues(m.model).grid);
  m.model.request.settings = m.small.frame.request.settings;
  m.small.frame.stale = true;
  m.show();
  EXPECT_TRUE(staleValues(m.model).rays);
  EXPECT_FALSE(staleValues(m.model).grid) << "the trace alone goes on";
  m.model.now = 5.0, m.model.freshAt = 4.9;
  noteStale(m.model);
  EXPECT_FALSE(m.model.stale.rays) << "not for a moment";
  m.model.now = 5.3;
  noteStale(m.model);
  EXPECT_TRUE(m.model.stale.rays);
  m.model.playing = true;
  noteStale(m.model);
  EXPECT_FALSE(m.model.stale.rays);
}

TEST(InstanceEdits, OneInstanceHasOneEntry) {
  using Kind = InstanceEdit::Kind;
  std::vector<InstanceEdit> edits;
  setEdit(edits, {.sceneInstance = 3, .kind = Kind::remove});
  setEdit(edits, {.sceneInstance = 5, .kind = Kind::makeDynamic});
  EXPECT_TRUE(isTakenOut(editOf(edits, 3)));
  EXPECT_TRUE(isMadeDynamic(editOf(edits, 5)));
  EXPECT_FALSE(isTakenOut(editOf(edits, 4)) || isMadeDynamic(editOf(edits, 4)));
  setEdit(edits, {.sceneInstance = 5, .kind = Kind::hide});
  EXPECT_EQ(edits.size(), 2u);
  EXPECT_TRUE(isTakenOut(editOf(edits, 5)));
  dropEdit(edits, 5);
  EXPECT_EQ(editOf(edits, 5), nullptr);
}

}  // namespace
}  // namespace gridscope
