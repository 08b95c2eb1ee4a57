// See full_cells.h.
#include "app/frame/full_cells.h"

#include <algorithm>

namespace gridscope {

FullCell fullnessOf(const Grid& grid, const ivec3& cell) {
  const GridParameters& shape = grid.parameters;
  FullCell full{.cell = cell};
  const size_t first = grid.index(gridTexel(shape, cell, 0)), next = shape.capacity > 1 ? grid.index(gridTexel(shape, cell, 1)) - first : 1;
  while (int(full.stored) < shape.capacity && grid.texels[first + full.stored * next] != kBlank) ++full.stored;
  if (shape.reserved == 2) full.refused = grid.at(gridRefusedTexel(shape, cell, false)) + grid.at(gridRefusedTexel(shape, cell, true));
  if (shape.reserved == 1) full.refused = grid.at(gridTexel(shape, cell, shape.capacity)) != 0 ? 1 : 0;
  full.saturated = shape.reserved == 0 ? int(full.stored) == shape.capacity : full.refused > 0;
  return full;
}

std::vector<FullCell> occupiedCells(const Grid& grid) {
  std::vector<FullCell> cells;
  const ivec3 count = grid.parameters.cellCount;
  ivec3 cell;
  for (cell.z = 0; cell.z < count.z; ++cell.z)
    for (cell.y = 0; cell.y < count.y; ++cell.y)
      for (cell.x = 0; cell.x < count.x; ++cell.x)
        if (const FullCell full = fullnessOf(grid, cell); full.tried() > 0) cells.push_back(full);
  return cells;
}

std::optional<ivec3> nextFullCell(std::span<const FullCell> occupied, std::optional<ivec3> from) {
  const bool anySaturated = std::ranges::any_of(occupied, &FullCell::saturated);
  const auto counts = [&](const FullCell& cell) { return cell.saturated || !anySaturated; };
  const FullCell *first = nullptr, *start = nullptr, *next = nullptr;
  for (const FullCell& cell : occupied) {
    if (!counts(cell)) continue;
    if (!first || cell.tried() > first->tried()) first = &cell;
    if (from && cell.cell == *from) start = &cell;
  }
  if (!first) return std::nullopt;
  for (const FullCell& cell : occupied) {
    if (!start || !counts(cell)) continue;
    const bool behind = cell.tried() < start->tried() || (cell.tried() == start->tried() && &cell > start);
    if (behind && (!next || cell.tried() > next->tried())) next = &cell;
  }
  return (next ? next : first)->cell;
}

}  // namespace gridscope
