// See full_cells.h.
#include "app/frame/full_cells.h"

#include <algorithm>

namespace gridscope {

std::vector<CellFacts> occupiedCells(const Grid& grid) {
  std::vector<CellFacts> cells;
  forCells(grid, [&](const CellFacts& cell) {
    if (cell.tried() > 0) cells.push_back(cell);
  });
  return cells;
}

std::optional<ivec3> nextFullCell(std::span<const CellFacts> occupied, std::optional<ivec3> from) {
  const bool anySaturated = std::ranges::any_of(occupied, &CellFacts::saturated);
  const auto counts = [&](const CellFacts& cell) { return cell.saturated || !anySaturated; };
  const CellFacts *first = nullptr, *start = nullptr, *next = nullptr;
  for (const CellFacts& cell : occupied) {
    if (!counts(cell)) continue;
    if (!first || cell.tried() > first->tried()) first = &cell;
    if (from && cell.cell == *from) start = &cell;
  }
  if (!first) return std::nullopt;
  for (const CellFacts& cell : occupied) {
    if (!start || !counts(cell)) continue;
    const bool behind = cell.tried() < start->tried() || (cell.tried() == start->tried() && &cell > start);
    if (behind && (!next || cell.tried() > next->tried())) next = &cell;
  }
  return (next ? next : first)->cell;
}

}  // namespace gridscope
