// A grid in memory: empty at first, and what a cell of it holds.
#include "core/grid/grid.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/grid/slots.h"

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

CellSlots readCell(const Grid& grid, ivec3 cell) {
  const SlotReader reader(grid);
  CellSlots slots;
  for (int slot = 0; slot < grid.parameters.stride; ++slot) {
    const uint32_t word = reader.slotLoad(gridTexel(grid.parameters, cell, slot));
    if (slot >= grid.parameters.capacity) {
      slots.reserved.push_back(word);
    } else if (word == kBlank) {
      slot = grid.parameters.capacity - 1;
    } else {
      slots.references.push_back(word);
    }
  }
  return slots;
}

bool cellSaturated(const GridParameters& grid, const CellSlots& cell) {
  if (grid.reserved == 0) return cell.references.size() == size_t(grid.capacity);
  return std::ranges::any_of(cell.reserved, [](uint32_t word) { return word != 0; });
}

}  // namespace gridscope
