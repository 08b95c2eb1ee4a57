// The command line of a frame says the frame: read back, it gives the same settings.
#include "app/frame/arguments.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/frame/changes.h"
#include "app/session/load_scene.h"

namespace gridscope {
namespace {

FrameSettings readBack(const FrameRequest& request) { return loadScene(optionsFrom(frameArguments(request))).settings; }

TEST(FrameArguments, EverySettingComesBackBitForBit) {
  FrameSettings settings;
  settings.grid = {.cells = 77,
                   .cellEdge = 0.1234567f,
                   .capacity = 9,
                   .bounds = Bounds{vec3(-1.1f, 0.2f, 0.3f), vec3(4.4f, 5.5f, 6.6f)},
                   .stretch = Stretch::z,
                   .builder = Builder::raster,
                   .insertion = kInsertionFirstCome,
                   .overlap = kOverlapExact,
                   .enlargement = 1.1f,
                   .numberBy = NumberBy::area,
                   .update = UpdateMode::moved};
  settings.trace = {
      .traversal = kTraversalDda, .back = 0.7f, .ahead = 1.3f, .tMin = 0.002f, .gapFill = false, .gate = 2.1f, .maxSegments = 55};
  settings.bounce = {.seed = 7, .roughness = 0.33f};
  settings.width = 123, settings.height = 45, settings.textureSize = 256;
  settings.camera = {.eye = vec3(1.1f, 2.2f, 3.3f), .target = vec3(0.1f, 0.2f, 0.3f), .verticalFovDegrees = 51.5f};
  FrameSettings read = readBack({.source = {.scene = "hall"}, .settings = settings});
  EXPECT_EQ(read.grid.cells, 128u);  // the edge replaces it
  read.grid.cells = settings.grid.cells;
  EXPECT_TRUE(sameSettings(read, settings));
}

TEST(FrameArguments, WhatABuiltInSceneBringsIsReplacedByWhatTheFrameHas) {
  for (const BuiltInScene& scene : builtInScenes()) {
    FrameSettings settings;
    settings.camera = {.eye = vec3(1, 2, 3), .target = vec3(4, 5, 6)};
    if (scene.cellEdge != 0.0f) settings.grid.cellEdge = 0.5f;
    EXPECT_TRUE(sameSettings(readBack({.source = {.scene = std::string(scene.name)}, .settings = settings}), settings)) << scene.name;
  }
}

TEST(FrameArguments, ASceneIsSaidWithItsTeapotsAndTimeAndACaptureAlone) {
  const Options options = optionsFrom(
      frameArguments({.source = {.scene = "hall", .teapots = 3, .moving = 2}, .settings = FrameSettings{}, .timeSeconds = 1.25}));
  EXPECT_EQ(options.teapots, 3u);
  EXPECT_EQ(options.moving, 2u);
  EXPECT_EQ(options.time, 1.25);
  EXPECT_EQ(frameArguments({.source = {.scene = "a.gridcap"}, .settings = FrameSettings{}}), std::vector<std::string>{"a.gridcap"});
}

TEST(FrameArguments, AReportIsOfTheFrameThatIsShown) {
  const FrameRequest request{.source = {.scene = "hall"}, .settings = FrameSettings{}, .frame = 46, .timeSeconds = 46 * 0.02};
  const Options options = optionsFrom(reportArguments(request, 0.02));
  EXPECT_EQ(options.frame, 46u);
  EXPECT_NEAR(options.time + double(options.frame) * options.frameStep, request.timeSeconds, 1e-9);
  EXPECT_EQ(reportArguments({.source = {.scene = "a.gridcap"}, .settings = FrameSettings{}, .frame = 3}, 0.02),
            (std::vector<std::string>{"a.gridcap", "--frame", "3"}));
}

}  // namespace
}  // namespace gridscope
