// The update `moved` leaves the same bits as `all`, in every frame, on the device; and what it leaves alone.
#include "core/pipeline/pipeline.h"
#include "core/scene/built_in_scenes.h"
#include "tests/gpu_fixture.h"

namespace gridscope {
namespace {

constexpr int kFrames = 30;

FrameSettings crowdSettings(const Scene& scene, uint32_t capacity, UpdateMode update) {
  FrameSettings settings;
  settings.grid.cells = 40;
  settings.grid.capacity = capacity;
  settings.grid.update = update;
  settings.width = 8;
  settings.height = 8;
  settings.camera = defaultCamera(scene);
  settings.textureSize = 16;
  return settings;
}

struct Case {
  uint32_t moving;
  uint32_t capacity;
};

class UpdateGpuTest : public GpuTest, public testing::WithParamInterface<Case> {};

TEST_P(UpdateGpuTest, MovedEqualsAllAfterEachOfThirtyFrames) {
  Scene scene = makeMovingCrowd(GetParam().moving);
  Pipeline all(gpu(), scene, crowdSettings(scene, GetParam().capacity, UpdateMode::all));
  Pipeline moved(gpu(), scene, crowdSettings(scene, GetParam().capacity, UpdateMode::moved));
  ASSERT_EQ(all.numbered().dynamicInstanceCount(), kCrowdCount);
  all.build();
  moved.build();
  uint64_t rebuilt = 0, touched = 0, refused = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    float time = 0.11f * float(frame);
    all.update(time);
    moved.update(time);
    ASSERT_EQ(all.grid().words, moved.grid().words) << "frame " << frame;
    refused += all.gridTotals().statistics.dynamicRefused;
    if (frame == 0) continue;  // the first adds all
    rebuilt += moved.updateReport().cellsRebuilt;
    touched += moved.updateReport().cellsTouched;
  }
  EXPECT_GT(touched, 0u);
  if (GetParam().capacity == 4) {
    EXPECT_GT(refused, 0u) << "the case must saturate to say anything";
  }
  std::printf("%u of %u instances moving, capacity %u: %.1f %% of the touched cells rebuilt\n", GetParam().moving, kCrowdCount,
              GetParam().capacity, 100.0 * double(rebuilt) / double(touched));
}

INSTANTIATE_TEST_SUITE_P(Crowd, UpdateGpuTest, testing::Values(Case{1, 4}, Case{3, 4}, Case{11, 4}, Case{1, 32}, Case{3, 32}, Case{11, 32}),
                         [](const auto& info) {
                           return std::to_string(info.param.moving) + "_moving_capacity_" + std::to_string(info.param.capacity);
                         });

TEST_F(GpuTest, UpdateMovedRebuildsNoCellWhileNothingSaturates) {
  Scene scene = makeMovingCrowd(1);
  FrameSettings settings = crowdSettings(scene, 200, UpdateMode::moved);
  settings.grid.cells = 20;
  Pipeline pipeline(gpu(), scene, settings);
  pipeline.build();
  for (int frame = 0; frame < 5; ++frame) {
    pipeline.update(0.2f * float(frame));
    ASSERT_EQ(pipeline.gridTotals().statistics.dynamicRefused, 0u);
    EXPECT_EQ(pipeline.updateReport().cellsRebuilt, 0u);
  }
}

TEST_F(GpuTest, UpdateTouchesNothingWhenNothingMoves) {
  Scene scene = makeMovingCrowd(3);
  Pipeline pipeline(gpu(), scene, crowdSettings(scene, 8, UpdateMode::moved));
  pipeline.build();
  pipeline.update(1.0f);
  pipeline.update(1.0f);
  EXPECT_EQ(pipeline.updateReport().cellsTouched, 0u);
}

TEST_F(GpuTest, ManyBuildsLeaveTheSameBytes) {
  Scene scene = makeMovingCrowd(3);
  Pipeline pipeline(gpu(), scene, crowdSettings(scene, 6, UpdateMode::all));
  pipeline.build();
  pipeline.update(0.4f);
  std::vector<uint32_t> first = pipeline.grid().words;
  for (int run = 0; run < 5; ++run) {
    pipeline.build();
    pipeline.update(0.4f);
    EXPECT_EQ(pipeline.grid().words, first);
  }
}

}  // namespace
}  // namespace gridscope
