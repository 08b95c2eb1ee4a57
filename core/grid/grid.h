// A grid in memory: the texels as the 3D image holds them (x fastest, then y, then z).
#pragma once

#include <cstdint>
#include <vector>

#include "shaders/shared/grid/grid.h"

namespace gridscope {

struct Grid {
  GridParameters parameters{};
  std::vector<uint32_t> texels;  // gridTexelCount(parameters): x fastest

  size_t index(ivec3 texel) const {
    ivec3 count = gridTexelCount(parameters);
    return (size_t(texel.z) * count.y + texel.y) * count.x + texel.x;
  }
  uint32_t& at(ivec3 texel) { return texels[index(texel)]; }
  uint32_t at(ivec3 texel) const { return texels[index(texel)]; }
};

// Place of a cell in lists with an element for each cell of a grid: x fastest.
inline size_t cellIndex(const GridParameters& grid, ivec3 cell) {
  return (size_t(cell.z) * size_t(grid.cellCount.y) + size_t(cell.y)) * size_t(grid.cellCount.x) + size_t(cell.x);
}

// What a cell holds.
struct CellSlots {
  std::vector<uint32_t> references;  // up to the first blank
  std::vector<uint32_t> reserved;    // its reserved texels
};
CellSlots readCell(const Grid& grid, ivec3 cell);
bool cellSaturated(const GridParameters& grid, const CellSlots& cell);

// All slots blank, all reserved texels zero.
Grid makeEmptyGrid(const GridParameters& parameters);

}  // namespace gridscope
