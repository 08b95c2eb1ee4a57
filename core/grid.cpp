// A grid in memory, empty at first.
#include "core/grid.h"

#include <algorithm>

#include "core/parallel.h"

namespace gridscope {

Grid makeEmptyGrid(const GridParameters& parameters) {
  const ivec3 count = gridTexelCount(parameters);
  Grid grid{parameters, std::vector<uint32_t>(size_t(count.x) * count.y * count.z, kBlank)};

  // Zero the reserved texels; those of all cells lie `stride` apart along the stretched axis.
  const int axis = parameters.stretchAxis;
  forRanges(size_t(parameters.cellCount.z), 8, [&](size_t begin, size_t end) {
    ivec3 cell;
    for (cell.z = int(begin); cell.z < int(end); ++cell.z)
      for (cell.y = 0; cell.y < parameters.cellCount.y; ++cell.y)
        for (cell.x = 0; cell.x < parameters.cellCount.x; ++cell.x) {
          ivec3 texel = gridTexel(parameters, cell, parameters.capacity);
          for (int i = 0; i < parameters.reserved; ++i, ++texel[axis]) grid.at(texel) = 0;
        }
  });
  return grid;
}

}  // namespace gridscope
