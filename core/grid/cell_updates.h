// What an update changed in each cell, found by comparing the grids before and after.
#pragma once

#include <vector>

#include "core/grid/grid.h"
#include "shaders/shared/grid/findings.h"

namespace gridscope {

// Both grids of the same parameters. x fastest.
std::vector<CellUpdate> compareUpdate(const Grid& before, const Grid& after);

}  // namespace gridscope
