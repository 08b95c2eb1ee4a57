// What is said of a scene's triangles beside a grid in a few numbers.
#pragma once

#include <cstdint>
#include <span>

#include "shaders/shared/grid/parameters.h"

namespace gridscope {

struct TriangleTotals {
  uint64_t degenerate = 0;  // without area: not inserted
  uint64_t outside = 0;     // the bounding box reaches beyond the grid
};

// Over world triangles, as the stages count them, whatever the update's mode.
TriangleTotals countTriangles(const GridParameters& grid, std::span<const Triangle> worldTriangles);

}  // namespace gridscope
