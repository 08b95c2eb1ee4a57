// A grid's words by cell and slot, for tests that write into them.
#pragma once

#include "core/grid/grid.h"
#include "shaders/shared/grid/layout.h"

namespace gridscope {

inline size_t wordOf(const GridParameters& grid, ivec3 texel) {
  const ivec3 count = gridTexelCount(grid);
  return (size_t(texel.z) * size_t(count.y) + size_t(texel.y)) * size_t(count.x) + size_t(texel.x);
}

inline uint32_t& slotAt(Grid& grid, ivec3 cell, int slot) {
  return grid.words[wordOf(grid.parameters, gridTexel(grid.parameters, cell, slot))];
}
inline uint32_t slotAt(const Grid& grid, ivec3 cell, int slot) {
  return grid.words[wordOf(grid.parameters, gridTexel(grid.parameters, cell, slot))];
}

// Of grids that count what they refuse.
inline uint32_t& refusedAt(Grid& grid, ivec3 cell, bool isDynamic) {
  return grid.words[wordOf(grid.parameters, gridRefusedTexel(grid.parameters, cell, isDynamic))];
}
inline uint32_t refusedAt(const Grid& grid, ivec3 cell, bool isDynamic) {
  return grid.words[wordOf(grid.parameters, gridRefusedTexel(grid.parameters, cell, isDynamic))];
}

}  // namespace gridscope
