// What a sweep begins with and what it tries: the frame's own setting, also of a grid whose settings nobody wrote down; and how one setting
// is tried when memory is short or the device dies.
#include "core/tune/settings.h"

#include <gtest/gtest.h>

#include <cstring>
#include <new>

#include "core/base/error.h"
#include "core/tune/attempt.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

struct Frame {
  Scene scene = sceneOf(randomTriangles(50, 1.0f, 0.4f, 3));
  NumberedScene numbered = numberScene(scene, NumberBy::file);
  Bounds bounds = sceneBounds(scene);
  FrameSettings settings;
  FrameParameters parameters{};

  explicit Frame(const GridSettings& made) {
    settings.grid = made;
    parameters.grid = deriveGrid(made, bounds, numbered);
    parameters.trace = deriveTrace(settings.trace, parameters.grid);
  }
  TuneOwn own() const { return ownSettings(settings, parameters, numbered, bounds); }
};

TEST(TuneSettings, TheOwnSettingIsTheFramesWhereItMakesTheGrid) {
  const Frame frame({.cells = 20, .capacity = 6, .overlap = kOverlapExact});
  const TuneOwn own = frame.own();
  EXPECT_EQ(own.grid.cells, 20u);
  EXPECT_EQ(own.grid.cellEdge, 0.0f);
  EXPECT_EQ(own.trace.ahead, frame.settings.trace.ahead);
  EXPECT_EQ(std::memcmp(&own.gridParameters, &frame.parameters.grid, sizeof(GridParameters)), 0);
  EXPECT_EQ(std::memcmp(&own.traceParameters, &frame.parameters.trace, sizeof(TraceParameters)), 0);
}

TEST(TuneSettings, OfAGridWithoutSettingsTheOwnSettingIsItsShape) {
  Frame frame({.cellEdge = 0.25f, .capacity = 4});
  frame.settings.grid = {};  // what a capture of another program says: nothing
  frame.parameters.grid.reserved = 0;
  frame.parameters.grid.stride = 4;
  frame.parameters.trace.gate = 0.5f;
  frame.parameters.trace.traversal = kTraversalDda;
  const TuneOwn own = frame.own();
  EXPECT_EQ(own.grid.cellEdge, 0.25f);
  EXPECT_EQ(own.grid.capacity, 4u);
  EXPECT_EQ(own.trace.gate, 2.0f);
  EXPECT_EQ(own.trace.back, 1.0f);
  EXPECT_EQ(own.trace.ahead, 0.75f);
  EXPECT_EQ(own.trace.traversal, kTraversalDda);
  EXPECT_EQ(own.gridParameters.cellCount, frame.parameters.grid.cellCount);
  EXPECT_EQ(own.gridParameters.origin, frame.parameters.grid.origin);
  EXPECT_EQ(own.gridParameters.reserved, 2);
  EXPECT_EQ(own.gridParameters.stride, 6);
}

TEST(TuneSettings, TheOwnSettingIsNotTriedTwice) {
  const TuneAxes axes{.cells = {8, 16},
                      .capacities = {4, 6},
                      .overlaps = {kOverlapPlane},
                      .numberings = {NumberBy::file, NumberBy::area},
                      .traversals = {kTraversalSegment, kTraversalDda},
                      .backs = {0.5f, 1.0f},
                      .aheads = {0.75f},
                      .gates = {1.75f}};
  const GridSettings own{.cells = 8, .capacity = 6};
  EXPECT_EQ(gridsToTry(axes, own, true).size(), 7u);
  EXPECT_EQ(gridsToTry(axes, own, false).size(), 3u);
  EXPECT_EQ(tracesToTry(axes, {}).size(), 2u) << "dda knows no reach";
}

// What measuring a row may meet.
struct Trial {
  TuneRow row;
  int runs = 0;
  bool freed = false;
  bool lives = true;
  template <class Measure>
  Trial(bool canFree, Measure measure) {
    lives = tryRow(
        row, [&](TuneRow& tried) { measure(tried, ++runs); }, [&] { return freed = canFree; });
  }
};

TEST(TuneAttempt, AMeasuredRowFreesNothing) {
  const Trial trial(true, [](TuneRow& row, int) { row.bytes = 7; });
  EXPECT_TRUE(trial.lives && trial.row.measured() && !trial.freed);
  EXPECT_EQ(trial.row.bytes, 7u);
}

TEST(TuneAttempt, ARowThatDoesNotFitIsTriedAgainOnceThereIsRoom) {
  const Trial trial(true, [](TuneRow& row, int run) {
    row.stored += 5;
    if (run == 1) throw std::bad_alloc();
  });
  EXPECT_TRUE(trial.lives && trial.row.measured() && trial.freed);
  EXPECT_EQ(trial.row.stored, 5u) << "from the start";
}

TEST(TuneAttempt, ARowIsRefusedWhenThereIsNoMoreRoomToMake) {
  const Trial trial(false, [](TuneRow&, int) { throw Error("the device can't hold it", kExitDevice); });
  EXPECT_TRUE(trial.lives);
  EXPECT_EQ(trial.row.refusal, "the device can't hold it");
  EXPECT_EQ(trial.runs, 1);
}

TEST(TuneAttempt, ALostDeviceIsSaidAndNotTriedAgain) {
  const Trial trial(true, [](TuneRow&, int) { throw Error("vkQueueSubmit: VK_ERROR_DEVICE_LOST", kExitDevice); });
  EXPECT_FALSE(trial.lives);
  EXPECT_FALSE(trial.row.measured());
  EXPECT_EQ(trial.runs, 1);
}

}  // namespace
}  // namespace gridscope
