// See cpu_check.h.
#include "core/cpu_check.h"

#include <cstring>

#include "core/invariants.h"

namespace gridscope {
namespace {

std::string hex(uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08X", value);
  return text;
}

std::string describe(const Hit& hit) {
  char text[128];
  std::snprintf(text, sizeof text, "kind %u, reference %s, t %.9g (0x%08X), u %.9g, v %.9g", hit.kind, hex(hit.reference).c_str(), hit.t,
                floatBitsToUint(hit.t), hit.u, hit.v);
  return text;
}

// "first of N" for the first element whose bytes differ; empty when none does. describe(index) says which.
template <typename T, typename Describe>
std::string firstDifference(std::span<const T> device, std::span<const T> cpp, const Describe& describe) {
  CHECK_EQ(device.size(), cpp.size());
  size_t different = 0, first = 0;
  for (size_t i = 0; i < device.size(); ++i) {
    if (!std::memcmp(&device[i], &cpp[i], sizeof(T))) continue;
    if (different++ == 0) first = i;
  }
  if (!different) return "";
  return std::to_string(different) + " of " + std::to_string(device.size()) + " differ; the first: " + describe(first);
}

// Cell and slot of a texel.
std::string placeOf(const Grid& grid, size_t index) {
  ivec3 count = gridTexelCount(grid.parameters);
  ivec3 texel(int(index % count.x), int(index / count.x % count.y), int(index / (size_t(count.x) * count.y)));
  int axis = grid.parameters.stretchAxis, slot = texel[axis] % grid.parameters.stride;
  texel[axis] /= grid.parameters.stride;
  std::string what = slot < grid.parameters.capacity ? "slot " + std::to_string(slot)
                                                     : slot == grid.parameters.capacity ? "static refused" : "dynamic refused";
  return "cell (" + std::to_string(texel.x) + ", " + std::to_string(texel.y) + ", " + std::to_string(texel.z) + "), " + what;
}

}  // namespace

std::string CpuCheck::compareGrid(const char* stage) {
  Grid grid = pipeline_.grid();
  std::vector<Triangle> triangles = pipeline_.worldTriangles();
  size_t present = std::string_view(stage) == "build" ? pipeline_.numbered().staticTriangleCount : triangles.size();
  std::string difference = firstDifference<Triangle>(std::span(triangles).first(present), std::span(worldTriangles_).first(present),
                                                     [](size_t i) { return "world triangle " + std::to_string(i); });
  if (!difference.empty()) return std::string(stage) + ": world triangles: " + difference;

  // The race decides the slots of a first-come grid; the C++ path goes on from the device's.
  if (pipeline_.parameters().grid.insertion == kInsertionSorted) {
    difference = firstDifference<uint32_t>(grid.texels, grid_.texels, [&](size_t i) {
      return placeOf(grid, i) + ": device " + hex(grid.texels[i]) + ", C++ " + hex(grid_.texels[i]);
    });
    if (!difference.empty()) return std::string(stage) + ": grid: " + difference;
  } else {
    grid_ = grid;
  }
  uint64_t tried = pipeline_.referencesTried();
  std::vector<std::string> broken = checkInvariants(grid, pipeline_.numbered(), &tried);
  return broken.empty() ? "" : std::string(stage) + ": invariant: " + broken.front();
}

std::string CpuCheck::afterBuild() {
  worldTriangles_.assign(pipeline_.numbered().triangleCount, Triangle{});
  BuildReport report;
  grid_ = buildGrid(pipeline_.parameters().grid, pipeline_.numbered(), worldTriangles_, report);
  return compareGrid("build");
}

// The C++ path always updates all: so the device's `moved` is checked against it too.
std::string CpuCheck::afterUpdate() {
  updateAll(pipeline_.numbered(), worldTriangles_, grid_);
  return compareGrid("update");
}

std::string CpuCheck::afterTrace(bool counted) {
  std::vector<Ray> rays = pipeline_.rays();
  std::vector<Hit> hits(rays.size()), deviceHits = pipeline_.hits();
  std::vector<RayCounters> counters(counted ? rays.size() : 0);
  traceRays({grid_, pipeline_.numbered(), worldTriangles_, pipeline_.parameters().trace}, rays, hits, counters);
  uint32_t width = pipeline_.settings().width;
  auto pixel = [&](size_t i) { return "pixel (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ")"; };
  std::string difference = firstDifference<Hit>(deviceHits, hits, [&](size_t i) {
    return pixel(i) + ": device " + describe(deviceHits[i]) + "; C++ " + describe(hits[i]);
  });
  if (!difference.empty()) return "trace: hits: " + difference;
  if (!counted) return "";
  std::vector<RayCounters> deviceCounters = pipeline_.counters();
  difference = firstDifference<RayCounters>(deviceCounters, counters, [&](size_t i) {
    return pixel(i) + ": device " + std::to_string(deviceCounters[i].visits) + " visits and " + std::to_string(deviceCounters[i].tests) +
           " tests, C++ " + std::to_string(counters[i].visits) + " and " + std::to_string(counters[i].tests);
  });
  return difference.empty() ? "" : "trace: counters: " + difference;
}

}  // namespace gridscope
