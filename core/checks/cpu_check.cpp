// See cpu_check.h.
#include "core/checks/cpu_check.h"

#include "core/capture/compare.h"
#include "core/grid/invariants.h"

namespace gridscope {

std::string CpuCheck::compareGrid(const char* stage) {
  Grid grid = pipeline_.grid();
  std::vector<Triangle> triangles = pipeline_.worldTriangles();
  size_t present = std::string_view(stage) == "build" ? pipeline_.numbered().staticTriangleCount : triangles.size();
  std::string difference = compareTriangles(std::span(triangles).first(present), std::span(worldTriangles_).first(present)).text();
  if (!difference.empty()) return std::string(stage) + ": world triangles: " + difference;

  // The race decides the slots of a first-come grid; the C++ path goes on from the device's.
  if (pipeline_.parameters().grid.insertion == kInsertionSorted) {
    difference = compareGrids(grid, grid_, {"device", "C++", pipeline_.numbered()}).text();
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
  const Comparison how{"device", "C++", pipeline_.numbered()};
  const uint32_t width = pipeline_.settings().width;
  std::string difference = compareHits(deviceHits, hits, width, how).text();
  if (!difference.empty()) return "trace: hits: " + difference;
  if (!counted) return "";
  difference = compareCounters(pipeline_.counters(), counters, width, how).text();
  return difference.empty() ? "" : "trace: counters: " + difference;
}

}  // namespace gridscope
