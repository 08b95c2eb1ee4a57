// See self_test.h.
#include "core/checks/self_test.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/checks/cpu_check.h"
#include "core/gpu/run_pass.h"
#include "core/scene/built_in_scenes.h"
#include "shaders/shared/checks/self_test.h"
#include "shaders/shared/gpu/bindings.h"

namespace gridscope {
namespace {

constexpr uint32_t kCases = 65536;  // a whole number of workgroups

// Names of SelfTestWords::words.
constexpr const char* kWordNames[kSelfTestWords] = {"add",
                                                    "subtract",
                                                    "multiply",
                                                    "multiply and add, apart",
                                                    "divide in double",
                                                    "floor to int",
                                                    "min and max",
                                                    "dot product",
                                                    "cross product x",
                                                    "cross product y",
                                                    "int to float",
                                                    "triangle test verdict",
                                                    "triangle test t",
                                                    "barycentric b",
                                                    "barycentric c",
                                                    "alpha texel"};

uint32_t nextRandom(uint32_t& state) {
  state ^= state << 13;
  state ^= state >> 17;
  return state ^= state << 5;
}

// Numbers of all magnitudes from 2^-20 to 2^20, both signs.
float randomFloat(uint32_t& state) {
  uint32_t bits = nextRandom(state);
  int exponent = int(nextRandom(state) % 41) - 20;
  float mantissa = 1.0f + float(bits & 0x7FFFFF) / 8388608.0f;
  return std::ldexp(bits >> 31 ? -mantissa : mantissa, exponent);
}

std::vector<Triangle> randomTriangles() {
  uint32_t state = 0x9E3779B9u;
  std::vector<Triangle> triangles(kCases);
  for (Triangle& triangle : triangles)
    for (vec3* corner : {&triangle.a, &triangle.b, &triangle.c})
      for (int axis = 0; axis < 3; ++axis) (*corner)[axis] = randomFloat(state);
  return triangles;
}

std::vector<SelfTestWords> runOperations(GpuContext& gpu, std::span<const Triangle> triangles) {
  const std::vector<std::byte> bytes = runPass(gpu, {.stem = "self_test",
                                                     .invocations = uint32_t(triangles.size()),
                                                     .inputBinding = kBindObjectTriangles,
                                                     .input = std::as_bytes(triangles),
                                                     .outputBinding = kBindRayRecord,
                                                     .outputBytes = triangles.size() * sizeof(SelfTestWords)});
  std::vector<SelfTestWords> results(triangles.size());
  std::memcpy(results.data(), bytes.data(), bytes.size());
  return results;
}

void compareOperations(GpuContext& gpu, SelfTestResult& result) {
  std::vector<Triangle> triangles = randomTriangles();
  std::vector<SelfTestWords> device = runOperations(gpu, triangles);
  for (const char* name : kWordNames) result.items.push_back({name, kCases, 0});
  for (uint32_t i = 0; i < kCases; ++i) {
    SelfTestWords expected = selfTest(triangles[i]);
    for (int word = 0; word < kSelfTestWords; ++word) result.items[word].different += device[i].words[word] != expected.words[word];
  }
}

// A small scene through build, update and trace, with both traversals.
void compareStages(GpuContext& gpu, SelfTestResult& result) {
  Scene scene = makeMovingCrowd(3);
  FrameSettings settings;
  settings.grid.cells = 24;
  settings.grid.capacity = 6;
  settings.width = 48;
  settings.height = 32;
  settings.camera = defaultCamera(scene);
  Pipeline pipeline(gpu, scene, settings);
  CpuCheck check(pipeline);
  auto note = [&](const char* name, const std::string& difference) {
    result.items.push_back({std::string(name) + (difference.empty() ? "" : ": " + difference), 1, difference.empty() ? 0u : 1u});
  };
  pipeline.build();
  note("build of a small scene", check.afterBuild());
  pipeline.update(0.25f);
  note("update", check.afterUpdate());
  pipeline.gather();
  pipeline.bounce(0);
  for (uint32_t traversal : {kTraversalSegment, kTraversalDda}) {
    TraceSettings trace;
    trace.traversal = traversal;
    pipeline.setTrace(trace);
    pipeline.trace(false);
    note(traversal == kTraversalSegment ? "trace by segments" : "trace by cells", check.afterTrace(false));
  }
}

}  // namespace

bool SelfTestResult::passed() const {
  return std::all_of(items.begin(), items.end(), [](const Item& item) { return item.different == 0; });
}

SelfTestResult runSelfTest(GpuContext& gpu) {
  SelfTestResult result;
  compareOperations(gpu, result);
  compareStages(gpu, result);
  return result;
}

}  // namespace gridscope
