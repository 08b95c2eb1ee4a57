// Build in C++: transform, then insertion with the code that the shaders share.
#include "core/grid/build.h"

#include <algorithm>
#include <mutex>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/grid/candidates.h"
#include "core/grid/slots.h"

namespace gridscope {

namespace {

struct CpuInsert : SlotWriter {
  using SlotWriter::SlotWriter;
#include "shaders/shared/grid/insert.h"
};

// A triangle to insert, and the cells of its bounding box.
struct Candidate {
  const Triangle* triangle;
  uint32_t reference;
  CellRange range;
};

std::vector<Candidate> listCandidates(const NumberedScene& scene, InstanceRange instances, std::span<const Triangle> worldTriangles,
                                      const GridParameters& grid, BuildReport& report) {
  std::vector<Candidate> candidates;
  for (uint32_t i = instances.begin; i < instances.end; ++i)
    forCandidates(scene, i, worldTriangles, grid, report, [&](const Triangle& triangle, uint32_t reference, const CellRange& range) {
      candidates.push_back({&triangle, reference, range});
    });
  return candidates;
}

void addReport(BuildReport& sum, const BuildReport& part) {
  sum.tried += part.tried;
  sum.stored += part.stored;
  sum.refused += part.refused;
  sum.cellsWalked += part.cellsWalked;
  sum.loopsCut += part.loopsCut;
}

// The cells of a range that lie in layers [begin, end) of z; they are consecutive in the range's order.
uvec2 partInLayers(const CellRange& range, int begin, int end) {
  const ivec3 extent = range.high - range.low + ivec3(1, 1, 1);
  const uint layer = uint(extent.x) * uint(extent.y);
  const int first = std::clamp(begin - range.low.z, 0, extent.z), last = std::clamp(end - range.low.z, 0, extent.z);
  return uvec2(uint(first) * layer, uint(last) * layer);
}

}  // namespace

void transformTriangles(const NumberedScene& scene, InstanceRange instances, std::span<Triangle> worldTriangles) {
  CHECK_EQ(worldTriangles.size(), scene.triangleCount);
  forRanges(instances.end - instances.begin, 1, [&](size_t begin, size_t end) {
    for (size_t i = instances.begin + begin; i < instances.begin + end; ++i) {
      const Instance& instance = scene.instances[i];
      for (uint32_t k = 0; k < instance.triangleCount; ++k)
        worldTriangles[instance.firstWorldTriangle + k] = transformTriangle(instance, scene.objectTriangles[instance.firstTriangle + k]);
    }
  });
}

BuildReport insertInstances(const NumberedScene& scene, InstanceRange instances, std::span<const Triangle> worldTriangles, Grid& grid) {
  BuildReport report{};
  const std::vector<Candidate> candidates = listCandidates(scene, instances, worldTriangles, grid.parameters, report);

  // A core owns whole layers of cells and offers them every triangle in rising order: no cell is shared, and the grid is the same for any
  // number of cores, in first-come insertion too.
  std::mutex reportMutex;
  forRanges(size_t(grid.parameters.cellCount.z), 8, [&](size_t begin, size_t end) {
    CpuInsert insert(grid);
    BuildReport part{};
    for (const Candidate& candidate : candidates) {
      if (candidate.range.high.z < int(begin) || candidate.range.low.z >= int(end)) continue;
      insert.insertTriangle(grid.parameters, *candidate.triangle, candidate.reference, candidate.range,
                            partInLayers(candidate.range, int(begin), int(end)), part);
    }
    std::lock_guard lock(reportMutex);
    addReport(report, part);
  });
  return report;
}

Grid buildGrid(const GridParameters& parameters, const NumberedScene& scene, std::span<Triangle> worldTriangles, BuildReport& report) {
  const InstanceRange statics{0, scene.staticInstanceCount};
  Grid grid = makeEmptyGrid(parameters);
  transformTriangles(scene, statics, worldTriangles);
  report = insertInstances(scene, statics, worldTriangles, grid);
  return grid;
}

}  // namespace gridscope
