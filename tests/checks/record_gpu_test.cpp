// The recording trace: its end is the frame's hit, and its steps are those that C++ records.
#include <cstring>

#include "core/checks/record_check.h"
#include "core/pipeline/pipeline.h"
#include "tests/gpu_fixture.h"
#include "tests/lesson.h"

namespace gridscope {
namespace {

TEST_F(GpuTest, RecordedRaysEndAsTheFrameDidAndEqualCpp) {
  Scene scene = makeBuiltInScene("saturated-cell");
  Pipeline pipeline(gpu(), scene, lessonSettings(findBuiltInScene("saturated-cell"), scene, 96, 54));
  pipeline.build();
  pipeline.update(0.0f);
  pipeline.gather();
  pipeline.bounce(0);
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
    TraceSettings trace;
    trace.traversal = traversal;
    pipeline.setTrace(trace);
    pipeline.trace(false);
    std::vector<Hit> hits = pipeline.hits();
    std::vector<Ray> rays = pipeline.rays();
    Grid grid = pipeline.grid();
    std::vector<Triangle> triangles = pipeline.worldTriangles();
    TraceInput input{grid, pipeline.numbered(), triangles, pipeline.parameters().trace};
    for (uint32_t pixel = 7; pixel < hits.size(); pixel += 61) {
      RayRecord device = pipeline.record(pixel), cpp = recordRay(input, rays[pixel]);
      EXPECT_EQ(0, std::memcmp(&device.hit, &hits[pixel], sizeof(Hit))) << "pixel " << pixel;
      ASSERT_EQ(device.steps.size(), cpp.steps.size());
      for (size_t i = 0; i < device.steps.size(); ++i) {
        EXPECT_EQ(device.steps[i].cell, cpp.steps[i].cell);
        EXPECT_EQ(device.steps[i].outcome, cpp.steps[i].outcome);
        EXPECT_EQ(device.steps[i].saturated, cpp.steps[i].saturated);
        EXPECT_EQ(device.steps[i].travel, cpp.steps[i].travel);
        ASSERT_EQ(device.steps[i].tests.size(), cpp.steps[i].tests.size());
        for (size_t k = 0; k < device.steps[i].tests.size(); ++k) {
          EXPECT_EQ(device.steps[i].tests[k].reference, cpp.steps[i].tests[k].reference);
          EXPECT_EQ(device.steps[i].tests[k].verdict, cpp.steps[i].tests[k].verdict);
          EXPECT_EQ(device.steps[i].tests[k].t, cpp.steps[i].tests[k].t);
        }
      }
    }
  }
}

TEST_F(GpuTest, AThousandRecordedRaysOfTheHallEndAsTheFrameDid) {
  Scene scene = makeBuiltInScene("hall");
  Pipeline pipeline(gpu(), scene, lessonSettings(findBuiltInScene("hall"), scene, 160, 90));
  pipeline.build();
  pipeline.update(0.0f);
  pipeline.gather();
  pipeline.bounce(0);
  pipeline.trace(false);
  const RecordComparison comparison = compareRecords(pipeline, 1000);
  EXPECT_EQ(comparison.compared, 1000u);
  EXPECT_TRUE(comparison.different.empty()) << comparison.different.size() << " differ; the first is pixel "
                                            << comparison.different.front();
}

}  // namespace
}  // namespace gridscope
