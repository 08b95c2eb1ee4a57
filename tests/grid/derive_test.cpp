// Derived parameters: the grid's shape, the loop budget, the camera, and messages that help.
#include "core/grid/derive.h"
#include "core/trace/derive.h"
#include "shaders/shared/grid/grid.h"
#include "shaders/shared/trace/frame.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/base/error.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

GridParameters gridOf(const Bounds& bounds, const GridSettings& settings = {}) { return deriveGrid(settings, bounds, NumberedScene{}); }

// The message of the Error that a function throws; empty when it throws none.
std::string messageOf(const std::function<void()>& function) {
  try {
    function();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void expectMessage(const std::function<void()>& function, const std::string& part) {
  const std::string message = messageOf(function);
  EXPECT_NE(message.find(part), std::string::npos) << '"' << message << "\" does not say " << part;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

const Bounds kRoom{vec3(-4.0f, 0.0f, -2.0f), vec3(4.0f, 3.0f, 2.0f)};

TEST(Derive, TheLongestSideGetsTheCellsAskedForAndOneMoreOnEachEnd) {
  GridSettings settings;
  settings.cells = 128;
  const GridParameters grid = gridOf(kRoom, settings);
  EXPECT_EQ(grid.cellCount, ivec3(130, 50, 66));
  EXPECT_EQ(grid.cellEdge, 0.0625f);
  EXPECT_EQ(grid.inverseCellEdge, 16.0f);
  EXPECT_EQ(grid.origin, kRoom.low - vec3(0.0625f));
}

TEST(Derive, TheBoundsLieInsideWithRoomOnEachSideWhateverTheRounding) {
  std::mt19937 random(5);
  for (int i = 0; i < 20000; ++i) {
    Bounds bounds;
    const float scale = std::exp2(std::uniform_real_distribution<float>(-8.0f, 16.0f)(random));
    bounds.include(randomPoint(random, -1.0f, 1.0f) * scale);
    bounds.include(randomPoint(random, -1.0f, 1.0f) * scale);
    GridSettings settings;
    settings.cells = 1 + random() % 500;
    const GridParameters grid = gridOf(bounds, settings);
    const vec3 low = (bounds.low - grid.origin) / grid.cellEdge, high = (bounds.high - grid.origin) / grid.cellEdge;
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_NEAR(low[axis], 1.0f, 0.1f);
      ASSERT_LE(high[axis], float(grid.cellCount[axis]) - 0.9f);
      ASSERT_GT(high[axis], float(grid.cellCount[axis]) - 2.1f);
    }
    ASSERT_TRUE(gridContains(grid, gridCell(grid, bounds.low)));
    ASSERT_TRUE(gridContains(grid, gridCell(grid, bounds.high)));
    ASSERT_EQ(std::max(grid.cellCount.x, std::max(grid.cellCount.y, grid.cellCount.z)), int(settings.cells) + 2);
  }
}

TEST(Derive, FlatBoundsMakeAGridThatHoldsThem) {
  const Bounds flat{vec3(0.0f, 1.0f, 0.0f), vec3(2.0f, 1.0f, 2.0f)};
  const GridParameters grid = gridOf(flat);
  EXPECT_EQ(grid.cellCount, ivec3(130, 2, 130));
  EXPECT_TRUE(gridContains(grid, gridCell(grid, vec3(1.0f))));
}

TEST(Derive, TheAxisWithTheFewestCellsIsStretchedAndXOnATie) {
  EXPECT_EQ(gridOf(kRoom).stretchAxis, 1);
  EXPECT_EQ(gridOf({vec3(0.0f), vec3(1.0f)}).stretchAxis, 0);
  EXPECT_EQ(gridOf({vec3(0.0f), vec3(2.0f, 1.0f, 1.0f)}).stretchAxis, 1);
  GridSettings settings;
  settings.stretch = Stretch::z;
  EXPECT_EQ(gridOf(kRoom, settings).stretchAxis, 2);
}

TEST(Derive, AnInvocationStaysWithinTheLoopBudgetAtEveryCapacity) {
  GridSettings settings;
  for (uint32_t capacity = 1; capacity <= 16384; ++capacity) {
    settings.capacity = capacity;
    const GridParameters grid = gridOf(kRoom, settings);
    ASSERT_GE(grid.cellsPerInvocation, 1u);
    if (capacity <= 8189) {
      ASSERT_LE(uint64_t(8) * grid.cellsPerInvocation * (capacity + 2), kLoopBudget);
    }
    const TraceParameters trace = deriveTrace({}, grid);
    ASSERT_GE(trace.segmentsPerPass, 1u);
    ASSERT_LT(uint64_t(trace.segmentsPerPass) * (1 + capacity), kLoopBudget);
  }
  settings.capacity = 32;
  EXPECT_EQ(gridOf(kRoom, settings).cellsPerInvocation, 240u);
  settings.capacity = 128;
  EXPECT_EQ(gridOf(kRoom, settings).cellsPerInvocation, 63u);
}

TEST(Derive, LengthsInCellEdgesBecomeWorldUnits) {
  GridSettings settings;
  settings.cellEdge = 0.5f;
  settings.enlargement = 2.0f;
  const GridParameters grid = gridOf(kRoom, settings);
  EXPECT_FLOAT_EQ(grid.planeRadiusSquared, 0.75f);
  EXPECT_FLOAT_EQ(grid.boxHalfEdge, 0.5f);
  const TraceParameters trace = deriveTrace({.back = 1.0f, .ahead = 0.75f, .tMin = 0.01f, .gate = 2.0f}, grid);
  EXPECT_FLOAT_EQ(trace.back, 0.5f);
  EXPECT_FLOAT_EQ(trace.ahead, 0.875f);
  EXPECT_FLOAT_EQ(trace.tMin, 0.005f);
  EXPECT_FLOAT_EQ(trace.gate, 1.0f);
}

TEST(Derive, EnoughSegmentsCrossTheGrid) {
  const GridParameters grid = gridOf({vec3(0.0f), vec3(1.0f)});
  EXPECT_GE(deriveTrace({}, grid).maxSegments, uint32_t(130 * 1.7321));
  EXPECT_GE(deriveTrace({.traversal = kTraversalDda}, grid).maxSegments, 390u);
  EXPECT_EQ(deriveTrace({.maxSegments = 7}, grid).maxSegments, 7u);
}

TEST(Derive, ImpossibleSettingsAreRefusedByTheirOption) {
  auto with = [](auto change) {
    GridSettings settings;
    change(settings);
    return [settings] { gridOf(kRoom, settings); };
  };
  expectMessage(with([](GridSettings& s) { s.capacity = 0; }), "--capacity 0");
  expectMessage(with([](GridSettings& s) { s.capacity = 16385; }), "--capacity 16385");
  expectMessage(with([](GridSettings& s) { s.cells = 0; }), "--cells 0");
  expectMessage(with([](GridSettings& s) { s.cells = 4000000000u; }), "--cells 4000000000");
  expectMessage(with([](GridSettings& s) { s.cellEdge = -1.0f; }), "--cell-edge -1");
  expectMessage(with([](GridSettings& s) { s.cellEdge = NAN; }), "--cell-edge nan");
  expectMessage(with([](GridSettings& s) { s.cellEdge = INFINITY; }), "--cell-edge inf");
  expectMessage(with([](GridSettings& s) { s.cellEdge = 1e-5f; }), "--cell-edge");
  expectMessage(with([](GridSettings& s) { s.cellEdge = 1e-30f; }), "--cell-edge");
  expectMessage(with([](GridSettings& s) { s.enlargement = 0.0f; }), "--enlargement 0");
  expectMessage(with([](GridSettings& s) { s.bounds = Bounds{vec3(1.0f), vec3(0.0f)}; }), "--bounds");
  expectMessage(with([](GridSettings& s) { s.bounds = Bounds{vec3(0.0f), vec3(NAN)}; }), "--bounds");
  expectMessage(with([](GridSettings& s) { s.bounds = Bounds{vec3(0.0f), vec3(1e7f)}; }), "--bounds");
  expectMessage(with([](GridSettings& s) { s.bounds = Bounds{vec3(1.0f), vec3(1.0f)}; }), "--cell-edge");
  expectMessage([] { deriveTrace({.back = -1.0f}, gridOf(kRoom)); }, "--back -1");
  expectMessage([] { deriveTrace({.ahead = NAN}, gridOf(kRoom)); }, "--ahead nan");
  expectMessage([] { deriveTrace({.gate = INFINITY}, gridOf(kRoom)); }, "--gate inf");
}

TEST(Derive, CellsFinerThanTheCoordinatesAreRefused) {
  GridSettings settings;
  settings.cells = 1000;
  expectMessage([&] { gridOf({vec3(9e5f), vec3(9e5f + 10.0f)}, settings); }, "too fine");
}

TEST(Derive, AGridThatDoesNotFitIsRefusedWithSettingsThatFit) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    Bounds bounds;
    bounds.include(vec3(0.0f));
    bounds.include(randomPoint(random, 1.0f, 10.0f));
    GridSettings settings;
    settings.cells = 16 + random() % 200;
    settings.capacity = 1 + random() % 200;
    const GridParameters grid = gridOf(bounds, settings);
    const GridLimits limits{.maxImageSide = 64 + uint32_t(random() % 1000),
                            .maxImageBytes = 10000000,
                            .maxMemoryBytes = 1 + random() % 30000000,
                            .device = "toy"};
    const std::string message = messageOf([&] { checkGridFits(settings, grid, limits); });
    if (message.empty()) continue;

    auto advised = [&](const char* option) {
      const size_t place = message.find(option);
      return place == std::string::npos ? 0u : uint32_t(std::stoul(message.substr(place + std::string(option).size())));
    };
    GridSettings fewerCells = settings, smallerCapacity = settings;
    fewerCells.cells = advised("--cells ");
    smallerCapacity.capacity = advised("--capacity ");
    if (fewerCells.cells > 0) {
      EXPECT_LT(fewerCells.cells, settings.cells);
      EXPECT_EQ(messageOf([&] { checkGridFits(fewerCells, gridOf(bounds, fewerCells), limits); }), "") << message;
    }
    if (smallerCapacity.capacity > 0) {
      EXPECT_EQ(messageOf([&] { checkGridFits(smallerCapacity, gridOf(bounds, smallerCapacity), limits); }), "") << message;
      smallerCapacity.capacity += 1;
      EXPECT_NE(messageOf([&] { checkGridFits(smallerCapacity, gridOf(bounds, smallerCapacity), limits); }), "") << message;
    }
  }
}

TEST(Derive, ADevicesLoopBudgetLimitsTheCapacityAndMemoryAloneThatOfTheCpu) {
  GridSettings settings;
  settings.capacity = 9000;
  settings.cells = 4;
  const GridParameters grid = gridOf(kRoom, settings);
  checkGridFits(settings, grid, {.maxMemoryBytes = 1u << 30});
  expectMessage([&] { checkGridFits(settings, grid, {.maxImageSide = 1u << 20}); }, "--capacity 8189 fits");
}

TEST(Derive, AMisfitIsTheDevicesFaultAndNamesIt) {
  const GridParameters grid = gridOf(kRoom);
  try {
    checkGridFits({}, grid, {.maxImageSide = 100, .device = "toy"});
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), kExitDevice);
    EXPECT_NE(std::string(error.what()).find("toy"), std::string::npos);
  }
  checkGridFits({}, grid, {});
}

TEST(Derive, CameraAxesAreOrthonormalAlsoWhenLookingStraightUp) {
  for (const vec3& target : {vec3(0, 0, -1), vec3(1, 2, 3), vec3(0, 5, 0), vec3(0, -5, 0)}) {
    CameraPose pose;
    pose.target = target;
    const CameraParameters camera = deriveCamera(pose, 640, 360, 10.0f);
    EXPECT_NEAR(glm::length(camera.right), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::length(camera.up), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(camera.right, camera.up), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::distance(glm::cross(camera.right, camera.up), -camera.forward), 0.0f, 1e-5f);
    EXPECT_FLOAT_EQ(camera.tanHalfWidth / camera.tanHalfHeight, 640.0f / 360.0f);
  }
  CameraPose nowhere;
  nowhere.target = nowhere.eye;
  expectMessage([&] { deriveCamera(nowhere, 640, 360, 10.0f); }, "--camera");
  expectMessage([&] { deriveCamera({}, 0, 360, 10.0f); }, "--size 0x360");
}

}  // namespace
}  // namespace gridscope
