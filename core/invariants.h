// What must hold of a grid after every stage.
#pragma once

#include <string>
#include <vector>

#include "core/grid.h"
#include "core/numbering.h"

namespace gridscope {

// Counted over all cells of a grid.
struct GridTotals {
  GridStatistics statistics{};
  std::vector<uint32_t> occupancyHistogram;  // [k]: cells that hold k references; capacity + 1 entries
  uint64_t stored() const { return uint64_t(statistics.staticStored) + statistics.dynamicStored; }
  uint64_t refused() const { return uint64_t(statistics.staticRefused) + statistics.dynamicRefused; }
};
GridTotals countGrid(const Grid& grid);

// Checks: no blank before a reference, static before dynamic (sorted insertion: strictly rising), no duplicate in a cell, every reference
// in range, a refusal only in a full cell, stored + refused = tried when `tried` is given. One line a broken invariant kind: how many
// cells, and the first with its place; empty when all hold.
std::vector<std::string> checkInvariants(const Grid& grid, const NumberedScene& scene, const uint64_t* tried);

}  // namespace gridscope
