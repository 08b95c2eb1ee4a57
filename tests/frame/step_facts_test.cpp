// Steps of recorded rays: what they are called, what is worked out again, and going through them forward and back.
#include <gtest/gtest.h>

#include "app/frame/step_facts.h"
#include "app/model/ray_stepping.h"
#include "shaders/shared/trace/triangle_test.h"
#include "shaders/shared/views/palette.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

// A row of upright triangles across the x axis, in cells of edge 1 and capacity 2: cell (4, ...) is asked to take 3, so that the last of
// them, the only one that the ray along x hits, is refused.
struct SteppedFrame {
  WindowModel model;
  std::shared_ptr<FrameSnapshot> frame = std::make_shared<FrameSnapshot>();
  std::unique_ptr<BuiltScene> built;

  explicit SteppedFrame(TraceSettings trace = {}) {
    const auto upright = [](float x, float y, float z) { return Triangle{{x, y, z}, {x, y + 0.3f, z}, {x, y, z + 0.3f}}; };
    Scene scene = emptyScene();
    placeMesh(scene, addMesh(scene, meshOf({upright(3.5f, 0.6f, 0.6f), upright(4.4f, 0.6f, 0.6f), upright(4.5f, 0.6f, 0.6f),
                                            upright(4.6f, 0.4f, 0.4f)})));
    GridSettings settings{.cellEdge = 1.0f, .capacity = 2, .overlap = kOverlapExact, .enlargement = 1.0f};
    settings.bounds = Bounds{vec3(0.0f), vec3(8.0f, 2.0f, 2.0f)};
    built = std::make_unique<BuiltScene>(scene, settings);

    auto facts = std::make_shared<SceneFacts>();
    facts->names = {.scene = "small", .meshes = {"row"}, .instances = {"the row"}, .materials = {"grey"}};
    facts->numbered = built->numbered;
    frame->scene = facts;
    frame->parameters.grid = built->grid.parameters;
    frame->parameters.trace = deriveTrace(trace, built->grid.parameters);
    frame->grid = std::make_shared<const Grid>(built->grid);
    frame->worldTriangles = std::make_shared<const std::vector<Triangle>>(built->worldTriangles);
    frame->demand = std::make_shared<const Demand>(built->grid.parameters, built->numbered, built->worldTriangles);
    frame->request.settings = FrameSettings{.grid = settings, .width = 4, .height = 2};
    record(trace, makeRay({0.5f, 0.5f, 0.5f}, {1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}));
    model.frame = frame;
    model.selection.selectPixel(3);
  }

  void record(const TraceSettings& trace, const Ray& ray) {
    auto recorded = std::make_shared<RecordedRay>();
    recorded->pixel = 3;
    recorded->ray = ray;
    recorded->record = recordRay(built->traceInput(trace), ray);
    recorded->frameHit = recorded->record.hit;
    recorded->equalsFrame = true;
    frame->record = recorded;
  }
  const RecordedRay& ray() const { return *frame->record; }
  StepFacts facts(uint32_t step) const { return stepFacts(*frame, ray(), step); }
};

TEST(StepFacts, EveryStepHasTheKindOfWhatBecameOfIt) {
  SteppedFrame scene;
  std::vector<StepOutcome> kinds;
  for (uint32_t step = 0; step < scene.ray().record.steps.size(); ++step) kinds.push_back(stepOutcome(scene.ray().record, step));
  EXPECT_EQ(kinds, (std::vector<StepOutcome>{StepOutcome::empty, StepOutcome::empty, StepOutcome::empty, StepOutcome::tested,
                                             StepOutcome::voxelHit}));
}

TEST(StepFacts, AGateThatIsNotReachedIsSaidWithItsNumbers) {
  SteppedFrame scene({.gate = 100.0f});
  const StepFacts facts = scene.facts(4);
  EXPECT_EQ(facts.kind, StepOutcome::held);
  EXPECT_FALSE(facts.gateOpen);
  EXPECT_NEAR(facts.travel, 4.0f, 1e-5f);
  EXPECT_NEAR(facts.gate, 100.0f, 1e-3f);
  EXPECT_NE(facts.went.find("100.00 cells"), std::string::npos) << facts.went;
}

TEST(StepFacts, ASegmentIsOneCellLongAndItsWindowIsElongated) {
  SteppedFrame scene;
  const StepFacts facts = scene.facts(3);
  EXPECT_NEAR(facts.startT, 3.0f, 1e-6f);
  EXPECT_NEAR(facts.endT, 4.0f, 1e-6f);
  EXPECT_NEAR(facts.start.x, 3.5f, 1e-6f);
  EXPECT_NEAR(facts.end.x, 4.5f, 1e-6f);
  EXPECT_NEAR(facts.window.x, 2.0f, 1e-6f);
  EXPECT_NEAR(facts.window.y, 4.75f, 1e-6f);
}

TEST(StepFacts, ATriangleBesideTheRayHasThePlacesInItsPlane) {
  SteppedFrame scene;
  const StepFacts facts = scene.facts(3);
  ASSERT_EQ(facts.tests.size(), 1u);
  EXPECT_EQ(facts.tests[0].test.verdict, kTestOutside);
  EXPECT_NEAR(facts.tests[0].test.t, 3.0f, 1e-5f);
  EXPECT_NEAR(facts.tests[0].weights.x, -1.0f / 3.0f, 1e-4f);
  EXPECT_NEAR(facts.tests[0].weights.y, -1.0f / 3.0f, 1e-4f);
}

TEST(StepFacts, OfTheRefusedTheOneThatWouldBeHitComesFirst) {
  SteppedFrame scene;
  const StepFacts facts = scene.facts(4);
  EXPECT_EQ(facts.stored, 2u);
  EXPECT_EQ(facts.refused, 1u);
  EXPECT_TRUE(facts.saturated);
  ASSERT_EQ(facts.refusedTests.size(), 1u);
  EXPECT_TRUE(facts.refusedTests[0].wouldHit);
  EXPECT_EQ(facts.refusedTests[0].name.triangle, 3u);
  EXPECT_NEAR(facts.refusedTests[0].test.t, 4.1f, 1e-5f);
}

TEST(StepFacts, ChangedValuesAreMarkedAgainstTheStepBefore) {
  SteppedFrame scene;
  EXPECT_FALSE(scene.facts(0).changes.cell);
  EXPECT_TRUE(scene.facts(1).changes.cell);
  EXPECT_FALSE(scene.facts(1).changes.stored);
  EXPECT_TRUE(scene.facts(3).changes.stored);
  EXPECT_FALSE(scene.facts(3).changes.refused);
  EXPECT_TRUE(scene.facts(4).changes.refused);
  EXPECT_TRUE(scene.facts(2).changes.gate) << "2.0 cells from the launch plane is the first above 1.75";
  EXPECT_FALSE(scene.facts(3).changes.gate);
  for (const TestFacts& test : scene.facts(4).tests) EXPECT_TRUE(test.isNew);
}

TEST(StepFacts, TheSentenceNamesCellCountsAndTheTriangleThatWasRefused) {
  SteppedFrame scene;
  const Sentence sentence = explainStep(*scene.frame, scene.ray(), scene.facts(4));
  const std::string text = plainText(sentence);
  EXPECT_NE(text.find("Voxel hit: cell "), std::string::npos) << text;
  EXPECT_NE(text.find("is saturated: 3 references tried, 2 stored; triangle 3 of row was refused and would be hit."), std::string::npos)
      << text;
  int links = 0;
  for (const SentencePart& part : sentence) links += part.link != SentencePart::Link::none;
  EXPECT_EQ(links, 3);
}

TEST(StepFacts, AHitIsTheBestSoFarAndStopsTheRay) {
  SteppedFrame scene;
  scene.record({}, makeRay({0.5f, 0.7f, 0.7f}, {1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}));
  const uint32_t last = static_cast<uint32_t>(scene.ray().record.steps.size()) - 1;
  const StepFacts facts = scene.facts(last);
  EXPECT_EQ(facts.kind, StepOutcome::hit);
  ASSERT_TRUE(facts.best.has_value());
  EXPECT_EQ(facts.best->t, scene.ray().record.hit.t);
  EXPECT_TRUE(facts.changes.best);
  EXPECT_EQ(facts.went.rfind("Stopped", 0), 0u) << facts.went;
}

TEST(StepFacts, AWalkEndsAStepWhereItLeavesTheCell) {
  SteppedFrame scene({.traversal = kTraversalDda});
  const StepFacts facts = scene.facts(0);
  EXPECT_NEAR(facts.startT, 0.0f, 1e-6f);
  EXPECT_EQ(facts.window.y, kFar);
  const float face = gridFace(scene.frame->grid->parameters, 0, facts.cell.x + 1);
  EXPECT_NEAR(facts.end.x, face, 1e-5f);
  for (uint32_t step = 0; step + 1 < scene.ray().record.steps.size(); ++step)
    EXPECT_EQ(scene.facts(step).endT, scene.ray().record.steps[step + 1].start) << "step " << step;
}

TEST(RayStepping, BackIsTheExactInverseOfForward) {
  SteppedFrame scene;
  std::vector<Selection> way;
  stepFirst(scene.model);
  for (int i = 0; i < 4; ++i) {
    way.push_back(scene.model.selected());
    stepForward(scene.model);
  }
  EXPECT_EQ(shownStep(scene.model), 4u);
  for (; !way.empty(); way.pop_back()) {
    stepBack(scene.model);
    EXPECT_EQ(scene.model.selected(), way.back());
  }
}

TEST(RayStepping, BothEndsHold) {
  SteppedFrame scene;
  stepBack(scene.model);
  EXPECT_EQ(shownStep(scene.model), 0u);
  stepLast(scene.model);
  EXPECT_EQ(shownStep(scene.model), 4u);
  stepForward(scene.model);
  EXPECT_EQ(shownStep(scene.model), 4u);
  stepFirst(scene.model);
  EXPECT_EQ(shownStep(scene.model), 0u);
}

TEST(RayStepping, RunsToTheNextOfAKindInBothDirections) {
  SteppedFrame scene;
  const RayRecord& record = scene.ray().record;
  EXPECT_EQ(nextStep(record, 0, StepSearch::nonEmpty), 3u);
  EXPECT_EQ(nextStep(record, 3, StepSearch::tested), 4u);
  EXPECT_EQ(nextStep(record, 0, StepSearch::saturated), 4u);
  EXPECT_EQ(nextStep(record, 0, StepSearch::voxelHit), 4u);
  EXPECT_EQ(nextStep(record, 0, StepSearch::revisit), std::nullopt);
  EXPECT_EQ(nextStep(record, 4, StepSearch::nonEmpty, -1), 3u);
  EXPECT_EQ(nextStep(record, 4, StepSearch::voxelHit), std::nullopt);
  EXPECT_TRUE(stepToNext(scene.model, StepSearch::saturated));
  EXPECT_EQ(shownStep(scene.model), 4u);
  EXPECT_FALSE(stepToNext(scene.model, StepSearch::saturated));
  EXPECT_EQ(shownStep(scene.model), 4u);
}

TEST(RayStepping, ASlantedRayThatStaysInACellRevisitsIt) {
  SteppedFrame scene;
  scene.record({}, makeRay({0.05f, 0.05f, 0.05f}, {1.0f, 1.0f, 1.0f}));
  const auto revisit = nextStep(scene.ray().record, 0, StepSearch::revisit);
  ASSERT_TRUE(revisit.has_value());
  EXPECT_EQ(stepOutcome(scene.ray().record, *revisit), StepOutcome::revisit);
  EXPECT_EQ(scene.ray().record.steps[*revisit].cell, scene.ray().record.steps[*revisit - 1].cell);
}

TEST(RayStepping, PlayGoesOnInTimeAndStopsAtTheEnd) {
  SteppedFrame scene;
  scene.model.stepsPerSecond = 10.0f;
  double due = 0.0;
  togglePlay(scene.model);
  for (int i = 0; i < 100 && scene.model.stepsPlaying; ++i) {
    scene.model.now = 0.05 * i;
    advancePlay(scene.model, due);
  }
  EXPECT_FALSE(scene.model.stepsPlaying);
  EXPECT_EQ(shownStep(scene.model), 4u);
  EXPECT_NEAR(scene.model.now, 0.4, 0.11);
  togglePlay(scene.model);
  EXPECT_EQ(shownStep(scene.model), 0u) << "from the end it starts again";
}

TEST(RayStepping, WithoutARecordNothingHappens) {
  WindowModel model;
  stepForward(model);
  stepLast(model);
  togglePlay(model);
  nextRay(model, 1);
  EXPECT_FALSE(stepToNext(model, StepSearch::tested));
  EXPECT_EQ(model.selected(), Selection{});
  EXPECT_FALSE(model.stepsPlaying);
}

}  // namespace
}  // namespace gridscope
