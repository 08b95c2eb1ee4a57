// Cells by what they were asked to take: all that hold something, the next fullest.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/grid/grid.h"

namespace gridscope {

// All cells that hold or refused a reference, x fastest. Looks at the whole grid: not for the thread of the window.
std::vector<CellFacts> occupiedCells(const Grid& grid);

// Of these cells (as occupiedCells() gives them) the saturated one that comes after `from` by falling demand, of equal ones by rising number;
// the fullest one when `from` is not given, not saturated, or the last. Where no cell is saturated: the same among all. Nothing: there are none.
std::optional<ivec3> nextFullCell(std::span<const CellFacts> occupied, std::optional<ivec3> from);

}  // namespace gridscope
