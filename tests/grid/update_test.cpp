// Update: `moved` leaves the bits of `all`, refusals included, and touches no more than it must.
#include <gtest/gtest.h>

#include "core/grid/build.h"
#include "core/grid/invariants.h"
#include "core/scene/built_in_scenes.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

struct CrowdSettings {
  uint32_t movingCount;
  uint32_t capacity;
};

void PrintTo(const CrowdSettings& settings, std::ostream* stream) {
  *stream << settings.movingCount << " moving, capacity " << settings.capacity;
}

class CrowdUpdate : public testing::TestWithParam<CrowdSettings> {};

// Cells as large as it takes for some to be full.
GridSettings crowdGrid(uint32_t capacity) {
  GridSettings settings;
  settings.cells = capacity <= 4 ? 48 : 12;
  settings.capacity = capacity;
  return settings;
}

TEST_P(CrowdUpdate, MovedEqualsAllAfterEachOf30Frames) {
  const Scene scene = makeMovingCrowd(GetParam().movingCount);
  BuiltScene byMoved(scene, crowdGrid(GetParam().capacity));
  BuiltScene byAll = byMoved;
  ASSERT_EQ(byMoved.numbered.dynamicInstanceCount(), 12u);
  uint64_t touched = 0, rebuilt = 0, frames = 0;
  for (int frame = 1; frame <= 30; ++frame) {
    const float time = 0.1f * float(frame);
    const std::vector<uint32_t> moved = setTransforms(byMoved.numbered, scene, time);
    setTransforms(byAll.numbered, scene, time);
    EXPECT_EQ(moved.size(), GetParam().movingCount);
    const UpdateReport report = updateMoved(byMoved.numbered, moved, byMoved.worldTriangles, byMoved.grid);
    updateAll(byAll.numbered, byAll.worldTriangles, byAll.grid);
    ASSERT_EQ(byMoved.grid.words, byAll.grid.words) << "frame " << frame;
    ASSERT_EQ(checkInvariants(byMoved.grid, byMoved.numbered, nullptr), std::vector<std::string>{}) << "frame " << frame;
    EXPECT_EQ(report.added.cellsWalked, report.added.cellsExpected);
    EXPECT_GT(report.cellsTouched, 0u);
    touched += report.cellsTouched, rebuilt += report.cellsRebuilt, frames += 1;
  }
  EXPECT_GT(rebuilt, 0u);
  EXPECT_LT(rebuilt, touched);
  const GridStatistics statistics = countGrid(byMoved.grid).statistics;
  RecordProperty("cellsTouched", std::to_string(touched / frames));
  RecordProperty("cellsRebuilt", std::to_string(rebuilt / frames));
  std::printf("%u moving, capacity %u: %.1f cells touched a frame, %.2f %% of them rebuilt; %u dynamic references refused at last\n",
              GetParam().movingCount, GetParam().capacity, double(touched) / double(frames), 100.0 * double(rebuilt) / double(touched),
              statistics.dynamicRefused);
}

INSTANTIATE_TEST_SUITE_P(Update, CrowdUpdate,
                         testing::Values(CrowdSettings{1, 4}, CrowdSettings{3, 4}, CrowdSettings{11, 4}, CrowdSettings{1, 32},
                                         CrowdSettings{3, 32}, CrowdSettings{11, 32}));

// Dynamic instances of random triangles that drift through each other and through a static cloud.
Scene driftingScene(uint32_t dynamicCount, uint32_t seed) {
  Scene scene = emptyScene();
  placeMesh(scene, addMesh(scene, meshOf(randomTriangles(60, 1.0f, 0.4f, seed))));
  std::mt19937 random(seed + 1);
  Animation animation{"drift", 10.0f, {}};
  for (uint32_t i = 0; i < dynamicCount; ++i) {
    const uint32_t instance = placeMesh(scene, addMesh(scene, meshOf(randomTriangles(30, 0.4f, 0.3f, seed + 2 + i))), vec3(0.0f), true);
    Channel channel{scene.instances[instance].node, ChannelPath::translation, Interpolation::step, {}, {}};
    for (int key = 0; key <= 10; ++key) {
      channel.times.push_back(float(key));
      channel.values.push_back(vec4(randomPoint(random, -0.6f, 0.6f), 0.0f));
    }
    animation.channels.push_back(channel);
  }
  scene.animations.push_back(animation);
  return scene;
}

TEST(Update, MovedEqualsAllForAnySubsetOfInstancesAndAnyCapacity) {
  std::mt19937 random(21);
  for (int round = 0; round < 12; ++round) {
    const Scene scene = driftingScene(6, 100u * uint32_t(round));
    GridSettings settings = crowdGrid(1 + random() % 24);
    settings.cells = 6 + random() % 6;
    settings.overlap = round % 2 == 0 ? kOverlapPlane : kOverlapExact;
    settings.stretch = Stretch(round % 3);
    BuiltScene byMoved(scene, settings);
    for (int frame = 1; frame < 10; ++frame) {
      // Only some of the instances take their new transforms.
      NumberedScene next = byMoved.numbered;
      std::vector<uint32_t> moved;
      for (uint32_t i : setTransforms(next, scene, float(frame) + 0.5f)) {
        if (random() % 2 == 0) continue;
        byMoved.numbered.instances[i] = next.instances[i];
        moved.push_back(i);
      }
      BuiltScene byAll = byMoved;
      updateMoved(byMoved.numbered, moved, byMoved.worldTriangles, byMoved.grid);
      updateAll(byAll.numbered, byAll.worldTriangles, byAll.grid);
      ASSERT_EQ(byMoved.grid.words, byAll.grid.words) << "round " << round << ", frame " << frame;
    }
  }
}

TEST(Update, NothingIsTouchedWhenNothingMoved) {
  const Scene scene = makeMovingCrowd(3);
  BuiltScene built(scene, crowdGrid(4));
  const std::vector<uint32_t> before = built.grid.words;
  const UpdateReport report = updateMoved(built.numbered, {}, built.worldTriangles, built.grid);
  EXPECT_EQ(report.cellsTouched, 0u);
  EXPECT_EQ(report.cellsRebuilt, 0u);
  EXPECT_EQ(report.added.tried, 0u);
  EXPECT_EQ(built.grid.words, before);
}

TEST(Update, NoCellIsRebuiltWhereNothingWasRefused) {
  const Scene scene = makeMovingCrowd(1);
  BuiltScene built(scene, crowdGrid(512));
  ASSERT_EQ(countGrid(built.grid).statistics.saturated, 0u);
  for (int frame = 1; frame <= 5; ++frame) {
    const UpdateReport report =
        updateMoved(built.numbered, setTransforms(built.numbered, scene, 0.2f * float(frame)), built.worldTriangles, built.grid);
    EXPECT_GT(report.cellsTouched, 0u);
    EXPECT_EQ(report.cellsRebuilt, 0u);
  }
}

TEST(Update, AllForgetsThePreviousDynamicReferencesAndKeepsTheStaticOnes) {
  const Scene scene = driftingScene(4, 7);
  GridSettings settings = crowdGrid(6);
  settings.cells = 8;
  BuiltScene built(scene, settings);
  setTransforms(built.numbered, scene, 4.5f);
  updateAll(built.numbered, built.worldTriangles, built.grid);

  // The same as a build of the scene as it is now.
  BuiltScene fresh = built;
  fresh.grid = buildGrid(built.grid.parameters, fresh.numbered, fresh.worldTriangles, fresh.staticReport);
  const UpdateReport report = updateAll(fresh.numbered, fresh.worldTriangles, fresh.grid);
  EXPECT_EQ(built.grid.words, fresh.grid.words);
  const uint64_t tried = uint64_t(fresh.staticReport.tried) + report.added.tried;
  EXPECT_EQ(checkInvariants(built.grid, built.numbered, &tried), std::vector<std::string>{});
}

TEST(Update, FirstComeInsertionKeepsTheInvariantsInBothWays) {
  const Scene scene = driftingScene(5, 31);
  GridSettings settings = crowdGrid(5);
  settings.cells = 8;
  settings.insertion = kInsertionFirstCome;
  BuiltScene byMoved(scene, settings);
  BuiltScene byAll = byMoved;
  for (int frame = 1; frame < 10; ++frame) {
    const float time = float(frame) + 0.5f;
    updateMoved(byMoved.numbered, setTransforms(byMoved.numbered, scene, time), byMoved.worldTriangles, byMoved.grid);
    setTransforms(byAll.numbered, scene, time);
    const uint64_t tried = uint64_t(byAll.staticReport.tried) + updateAll(byAll.numbered, byAll.worldTriangles, byAll.grid).added.tried;
    EXPECT_EQ(checkInvariants(byMoved.grid, byMoved.numbered, &tried), std::vector<std::string>{});
    EXPECT_EQ(checkInvariants(byAll.grid, byAll.numbered, &tried), std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace gridscope
