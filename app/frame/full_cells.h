// Cells and what they were asked to take: how full one is, all that hold something, the next fullest.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/grid/grid.h"

namespace gridscope {

// A cell and what it was asked to take.
struct FullCell {
  ivec3 cell{0};
  uint32_t stored = 0;
  uint32_t refused = 0;  // of a grid that only flags its full cells: 1; that has no reserved texels: 0
  bool saturated = false;
  uint32_t tried() const { return stored + refused; }
};

// What the grid holds and refused in one cell.
FullCell fullnessOf(const Grid& grid, const ivec3& cell);

// All cells that hold or refused a reference, x fastest. Looks at the whole grid: not for the thread of the window.
std::vector<FullCell> occupiedCells(const Grid& grid);

// Of these cells (as occupiedCells() gives them) the saturated one that comes after `from` by falling demand, of equal ones by rising number;
// the fullest one when `from` is not given, not saturated, or the last. Where no cell is saturated: the same among all. Nothing: there are none.
std::optional<ivec3> nextFullCell(std::span<const FullCell> occupied, std::optional<ivec3> from);

}  // namespace gridscope
