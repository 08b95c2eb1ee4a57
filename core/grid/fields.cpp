// See fields.h.
#include "core/grid/fields.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/numbers.h"
#include "core/grid/derive.h"
#include "core/scene/scene.h"
#include "shaders/shared/grid/grid.h"

namespace gridscope {

namespace {

void demand(bool fulfilled, const char* fault) {
  if (!fulfilled) throw Error(std::string("grid.") + fault);
}

bool withinLimit(const vec3& v, float limit) { return std::abs(v.x) <= limit && std::abs(v.y) <= limit && std::abs(v.z) <= limit; }

}  // namespace

void checkGridShape(const GridParameters& grid) {
  demand(grid.cellEdge > 0.0f, "cellEdge is not above 0");
  demand(grid.capacity >= 1 && grid.capacity <= 16384, "capacity is not from 1 to 16384");
  demand(grid.reserved >= 0 && grid.reserved <= 2, "reserved is not 0, 1 or 2");
  demand(grid.stretchAxis >= 0 && grid.stretchAxis <= 2, "stretchAxis is not x, y or z");
  for (int axis = 0; axis < 3; ++axis)
    demand(grid.cellCount[axis] >= 1 && grid.cellCount[axis] <= 65535, "cellCount is not from 1 to 65535");
  demand(uint64_t(grid.cellCount.x) * uint64_t(grid.cellCount.y) * uint64_t(grid.cellCount.z) < kNoCell,
         "cellCount makes 4,294,967,295 cells or more");
}

void checkGridParameters(const GridParameters& grid) {
  checkGridShape(grid);
  demand(std::isfinite(grid.cellEdge) && grid.cellEdge > 1e-9f, "cellEdge is not a length above 1e-9");
  demand(grid.stride == grid.capacity + grid.reserved, "stride is not capacity + reserved");

  // A cell must be many floats wide (derive.cpp), or a ray would stand still.
  const float limit = 4.0f * kCoordinateLimit;
  const vec3 high = grid.origin + vec3(grid.cellCount) * grid.cellEdge;
  demand(isFinite(grid.origin) && withinLimit(grid.origin, limit) && isFinite(high) && withinLimit(high, limit),
         "origin and cellEdge lead beyond 4000000");
  float farthest = 0.0f;
  for (int axis = 0; axis < 3; ++axis) farthest = std::max({farthest, std::abs(grid.origin[axis]), std::abs(high[axis])});
  demand(grid.cellEdge >= 4.0f * (std::nextafter(farthest, INFINITY) - farthest), "cellEdge is too small for 32-bit floats at its origin");
  demand(std::abs(double(grid.inverseCellEdge) * grid.cellEdge - 1.0) < 1e-6, "inverseCellEdge is not 1 / cellEdge");

  demand(std::isfinite(grid.planeRadiusSquared) && grid.planeRadiusSquared >= 0.0f, "planeRadiusSquared is not a squared length");
  demand(std::isfinite(grid.boxHalfEdge) && grid.boxHalfEdge >= 0.0f, "boxHalfEdge is not a length");
  demand(grid.overlap <= kOverlapExact && grid.insertion <= kInsertionFirstCome, "overlap or insertion is unknown");
  demand(grid.cellsPerInvocation >= 1 && grid.cellsPerInvocation <= kLoopBudget, "cellsPerInvocation is not from 1 to 65535");
}

void deriveForeignGrid(const GridSettings& settings, GridParameters& grid) {
  grid.stride = grid.capacity + grid.reserved;
  deriveFromEdge(settings, grid);
}

}  // namespace gridscope
