// Drivers that cut loops short (lavapipe after 65,535 iterations of a group) must lose no reference and end no ray.
#include <cmath>

#include "core/base/error.h"
#include "core/checks/cpu_check.h"
#include "core/pipeline/pipeline.h"
#include "tests/gpu_fixture.h"

namespace gridscope {
namespace {

constexpr float kEdge = 0.125f;

Scene sceneOf(std::vector<vec3> positions) {
  Scene scene;
  scene.name = "limits";
  scene.materials.emplace_back();
  scene.meshes.push_back({.name = "triangles", .positions = std::move(positions)});
  makeFlatNormals(scene.meshes[0]);
  scene.nodes.emplace_back();
  scene.instances.push_back({.name = "triangles"});
  return scene;
}

FrameSettings settingsFor(const Scene& scene, uint32_t capacity) {
  FrameSettings settings;
  settings.grid.cellEdge = kEdge;
  settings.grid.capacity = capacity;
  settings.width = 8;
  settings.height = 8;
  settings.camera = defaultCamera(scene);
  return settings;
}

// Eight neighbouring triangles, each with a bounding box of the given cells.
Scene boxesOf(ivec3 cells) {
  std::vector<vec3> positions;
  vec3 size = vec3(cells) * kEdge - vec3(0.01f);
  for (int i = 0; i < 8; ++i) {
    vec3 low(kEdge * 0.02f * float(i), 0.0f, 0.0f);
    positions.insert(positions.end(), {low, low + size, low + vec3(size.x, 0.0f, size.z * 0.5f)});
  }
  return sceneOf(std::move(positions));
}

void expectNothingLost(GpuContext& gpu, const Scene& scene, const FrameSettings& settings) {
  Pipeline pipeline(gpu, scene, settings);
  CpuCheck check(pipeline);
  pipeline.build();
  EXPECT_EQ(check.afterBuild(), "");
  EXPECT_EQ(pipeline.buildReport().cellsWalked, pipeline.buildReport().cellsExpected);
  EXPECT_EQ(pipeline.buildReport().tried, pipeline.buildReport().stored + pipeline.buildReport().refused);
  EXPECT_GT(pipeline.buildReport().stored, 0u);
}

TEST_F(GpuTest, NeighbouringTrianglesOf256CellsInAllShapesLoseNoReference) {
  for (uint32_t capacity : {16u, 32u, 64u, 128u})
    for (int x = 1; x <= 256; x *= 4)
      for (int y = 1; x * y <= 256; y *= 4)
        for (Builder builder : {Builder::compute, Builder::raster}) {
          if (builder == Builder::raster && !gpu().report().geometryStage) continue;
          SCOPED_TRACE("capacity " + std::to_string(capacity) + ", box " + std::to_string(x) + " x " + std::to_string(y));
          Scene scene = boxesOf({x, y, 256 / (x * y)});
          FrameSettings settings = settingsFor(scene, capacity);
          settings.grid.builder = builder;
          expectNothingLost(gpu(), scene, settings);
        }
}

TEST_F(GpuTest, ATriangleAcrossTheDiagonalOfALargeGridLosesNoReference) {
  // 402 cells a side at capacity 1: 65 million cells, 780 MB; what lavapipe's 2 GiB images allow within CI's memory and time.
  Scene scene = sceneOf({vec3(0.0f), vec3(50.0f, 50.0f, 25.0f), vec3(50.0f, 0.0f, 50.0f)});
  expectNothingLost(gpu(), scene, settingsFor(scene, 1));
}

// Rays along a corridor, from inside it: half of them to its far end, half into its near one.
std::vector<Ray> corridorRays(uint32_t count) {
  std::vector<Ray> rays(count);
  for (uint32_t i = 0; i < count; ++i) {
    float x = 0.09f * float(i % 16) / 16.0f, y = 0.09f * float(i / 16 % 16) / 16.0f, side = i % 2 ? 1.0f : -1.0f;
    rays[i] = {.origin = {x, y, 0.5f}, .direction = {0.0f, 0.0f, side}, .launchNormal = {0.0f, 0.0f, side}, .valid = 1};
  }
  return rays;
}

TEST_F(GpuTest, RaysThroughDeepCellsGoOnInFurtherDispatches) {
  // 600 triangles in the corridor's first cell: cells so deep that one dispatch may take few segments.
  std::vector<vec3> positions;
  for (int i = 0; i < 600; ++i) {
    float z = 0.1f * float(i) / 600.0f;
    positions.insert(positions.end(), {vec3(0, 0, z), vec3(0.1f, 0, z), vec3(0, 0.1f, z)});
  }
  positions.insert(positions.end(), {vec3(0, 0, 8), vec3(0.1f, 0, 8), vec3(0, 0.1f, 8)});
  Scene scene = sceneOf(std::move(positions));
  FrameSettings settings = settingsFor(scene, 1290);
  settings.width = 16;
  settings.height = 16;
  settings.camera = {.eye = {0.0f, 0.0f, 4.0f}, .target = {0.0f, 0.0f, 0.0f}};
  Pipeline pipeline(gpu(), scene, settings);
  ASSERT_LT(pipeline.parameters().trace.segmentsPerPass, 60u) << "one pass must not reach the far end";
  CpuCheck check(pipeline);
  pipeline.build();
  EXPECT_EQ(check.afterBuild(), "");
  pipeline.update(0.0f);
  EXPECT_EQ(check.afterUpdate(), "");
  pipeline.gather();
  pipeline.useRays(corridorRays(pipeline.rayCount()));
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
    TraceSettings trace;
    trace.traversal = traversal;
    pipeline.setTrace(trace);
    pipeline.trace(true);
    EXPECT_EQ(check.afterTrace(true), "");
    EXPECT_EQ(pipeline.hits()[1].kind, kHitTriangle) << "the far end is seen";
  }
}

TEST_F(GpuTest, AGridBeyondTheDeviceIsRefusedWithNumbersBeforeAnythingIsAllocated) {
  Scene scene = boxesOf({4, 4, 16});
  FrameSettings settings = settingsFor(scene, 32);
  settings.grid.cellEdge = 0.0f;
  settings.grid.cells = 20000;
  try {
    Pipeline pipeline(gpu(), scene, settings);
    FAIL() << "was not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), kExitDevice);
    EXPECT_NE(std::string(error.what()).find("--cells"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gridscope
