// The device's build, update and trace against C++, on the built-in scenes.
#include "core/pipeline/pipeline.h"

#include "core/base/error.h"
#include "core/checks/cpu_check.h"
#include "core/checks/self_test.h"
#include "tests/gpu_fixture.h"
#include "tests/lesson.h"

namespace gridscope {
namespace {

// Every product of two frames equals C++.
void expectEqualsCpu(Pipeline& pipeline, bool bothTraversals) {
  CpuCheck check(pipeline);
  pipeline.build();
  EXPECT_EQ(check.afterBuild(), "");
  for (int frame = 0; frame < 2; ++frame) {
    pipeline.update(0.37f * float(frame));
    EXPECT_EQ(check.afterUpdate(), "");
    pipeline.gather();
    pipeline.bounce(uint32_t(frame));
    for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
      if (traversal == kTraversalDda && !bothTraversals) continue;
      TraceSettings trace = pipeline.settings().trace;
      trace.traversal = traversal;
      pipeline.setTrace(trace);
      pipeline.trace(true);
      EXPECT_EQ(check.afterTrace(true), "") << "traversal " << traversal;
    }
  }
}

class LessonTest : public GpuTest, public testing::WithParamInterface<int> {
 protected:
  const BuiltInScene& lesson() const { return builtInScenes()[size_t(GetParam())]; }
};

TEST_P(LessonTest, DeviceEqualsCppInEveryProductWithBothTraversals) {
  Scene scene = lesson().make();
  Pipeline pipeline(gpu(), scene, lessonSettings(lesson(), scene, 160, 90));
  expectEqualsCpu(pipeline, true);
}

TEST_P(LessonTest, RasterBuilderEqualsCpp) {
  if (!gpu().report().geometryStage) GTEST_SKIP() << "no geometry stage";
  Scene scene = lesson().make();
  FrameSettings settings = lessonSettings(lesson(), scene, 160, 90);
  settings.grid.builder = Builder::raster;
  settings.grid.overlap = kOverlapExact;
  Pipeline pipeline(gpu(), scene, settings);
  expectEqualsCpu(pipeline, false);
}

TEST_P(LessonTest, NumberedByAreaWithFewSlotsEqualsCpp) {
  Scene scene = lesson().make();
  FrameSettings settings = lessonSettings(lesson(), scene, 160, 90);
  settings.grid.numberBy = NumberBy::area;
  settings.grid.capacity = 3;
  settings.grid.stretch = Stretch::z;
  Pipeline pipeline(gpu(), scene, settings);
  expectEqualsCpu(pipeline, false);
}

TEST_P(LessonTest, FirstComeKeepsTheInvariantsAndTracesAsCpp) {
  Scene scene = lesson().make();
  FrameSettings settings = lessonSettings(lesson(), scene, 160, 90);
  settings.grid.insertion = kInsertionFirstCome;
  settings.grid.capacity = 5;
  Pipeline pipeline(gpu(), scene, settings);
  CpuCheck check(pipeline);
  pipeline.build();
  EXPECT_EQ(check.afterBuild(), "");
  pipeline.update(0.5f);
  check.afterUpdate();
  pipeline.gather();
  pipeline.bounce(0);
  pipeline.trace(false);
}

std::string lessonName(const testing::TestParamInfo<int>& info) {
  std::string name(builtInScenes()[size_t(info.param)].name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(BuiltIn, LessonTest, testing::Range(0, int(builtInScenes().size())), lessonName);

TEST_F(GpuTest, DevicePassesTheSelfTest) {
  SelfTestResult result = runSelfTest(gpu());
  for (const SelfTestResult::Item& item : result.items) EXPECT_EQ(item.different, 0u) << item.name;
  EXPECT_TRUE(result.passed());
}

// Functions of one device called with another's handles crash in the driver, or go past the validation layer.
TEST_F(GpuTest, ASecondContextThatComesAndGoesLeavesTheFirstAlone) {
  const Scene scene = makeBuiltInScene("saturated-cell");
  FrameSettings settings{.width = 48, .height = 27, .camera = defaultCamera(scene)};
  Pipeline first(gpu(), scene, settings);
  expectEqualsCpu(first, false);
  {
    GpuContext other({.device = ""});
    Pipeline second(other, scene, settings);
    expectEqualsCpu(second, false);
    expectEqualsCpu(first, false);
    expectEqualsCpu(second, false);
  }
  expectEqualsCpu(first, false);
}

TEST_F(GpuTest, AnotherOrderOfReferencesAndUnknownBoundsAreRefusedInWords) {
  const Scene scene = makeBuiltInScene("saturated-cell");
  FrameSettings settings{.width = 16, .height = 9, .camera = defaultCamera(scene)};
  Pipeline pipeline(gpu(), scene, settings);
  GridSettings byArea = settings.grid;
  byArea.numberBy = NumberBy::area;
  EXPECT_THROW(pipeline.setGrid(byArea), Error);
  Pipeline captured(
      gpu(), PipelineInputs{.name = "foreign", .numbered = pipeline.numbered(), .settings = settings, .parameters = pipeline.parameters()});
  GridSettings finer = settings.grid;
  finer.capacity += 1;
  EXPECT_THROW(captured.setGrid(finer), Error);
}

TEST_F(GpuTest, ABuildIsCancelledBeforeAPieceAndRunsAgain) {
  const Scene scene = makeBuiltInScene("saturated-cell");
  FrameSettings settings{.width = 16, .height = 9, .camera = defaultCamera(scene)};
  Pipeline pipeline(gpu(), scene, settings);
  EXPECT_THROW(pipeline.build([](float) { return false; }), Error);
  expectEqualsCpu(pipeline, false);
}

TEST_F(GpuTest, EveryPassOfTheProgramIsTakenByTheDevice) { EXPECT_NO_THROW(tryShaders(gpu())); }

}  // namespace
}  // namespace gridscope
