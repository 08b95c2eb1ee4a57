// See statistics.h.
#include "core/grid/statistics.h"

#include "shaders/shared/grid/overlap.h"

namespace gridscope {

TriangleTotals countTriangles(const GridParameters& grid, std::span<const Triangle> worldTriangles) {
  TriangleTotals totals;
  for (const Triangle& triangle : worldTriangles) {
    if (triangleDegenerate(triangleNormal(triangle)))
      totals.degenerate += 1;
    else if (triangleCells(grid, triangle).clipped)
      totals.outside += 1;
  }
  return totals;
}

}  // namespace gridscope
