// The triangles that a build or an update offers to the grid, and what is counted of those that it does not.
#pragma once

#include <span>

#include "core/grid/build.h"
#include "shaders/shared/grid/overlap.h"

namespace gridscope {

// Calls visit(triangle, reference, range) for every triangle of an instance, rising, that has an area and a cell in its bounding box. Counts
// degenerate triangles, triangles that reach outside, and the cells to walk.
template <typename Visit>
void forCandidates(const NumberedScene& scene, uint32_t instanceIndex, std::span<const Triangle> worldTriangles, const GridParameters& grid,
                   BuildReport& report, Visit visit) {
  const Instance& instance = scene.instances[instanceIndex];
  for (uint32_t k = 0; k < instance.triangleCount; ++k) {
    const Triangle& triangle = worldTriangles[instance.firstWorldTriangle + k];
    if (triangleDegenerate(triangleNormal(triangle))) {
      report.degenerate += 1;
      continue;
    }
    const CellRange range = triangleCells(grid, triangle);
    report.outside += range.clipped ? 1 : 0;
    report.cellsExpected += cellRangeCount(range);
    if (cellRangeCount(range) > 0) visit(triangle, makeReference(instanceIndex, k), range);
  }
}

}  // namespace gridscope
