// What must hold of a grid after every stage.
#pragma once

#include <string>
#include <vector>

#include "core/grid/grid.h"
#include "core/scene/numbering.h"

namespace gridscope {

// Counted over all cells of a grid.
struct GridTotals {
  GridStatistics statistics{};
  std::vector<uint32_t> occupancyHistogram;  // [k]: cells that hold k references; capacity + 1 entries
  uint64_t stored() const { return uint64_t(statistics.staticStored) + statistics.dynamicStored; }
  uint64_t refused() const { return uint64_t(statistics.staticRefused) + statistics.dynamicRefused; }
};
GridTotals countGrid(const Grid& grid);

// One thing that must hold, and whether it does.
struct Invariant {
  std::string key;     // in JSON: "noBlankBefore"
  std::string name;    // "no blank before a reference"
  std::string whyNot;  // why it does not apply; empty: it was tested
  uint64_t count = 0;  // cells, or rays, that break it
  std::string fault;   // how many break it, and the first with its place, in words; empty: it holds
  bool holds() const { return fault.empty(); }
};

// Of the grid's cells: no blank before a reference, static before dynamic (sorted insertion: strictly rising), no duplicate in a cell, every
// reference in range, a refusal only in a full cell, stored + refused = tried (where `tried` is given and refusals are counted).
// What needs the triangles too is in invariants_place.h.
std::vector<Invariant> testCells(const Grid& grid, const NumberedScene& scene, const uint64_t* tried);

// Checks: no blank before a reference, static before dynamic (sorted insertion: strictly rising), no duplicate in a cell, every reference
// in range, a refusal only in a full cell, stored + refused = tried when `tried` is given. One line a broken invariant kind: how many
// cells, and the first with its place; empty when all hold.
std::vector<std::string> checkInvariants(const Grid& grid, const NumberedScene& scene, const uint64_t* tried);

}  // namespace gridscope
