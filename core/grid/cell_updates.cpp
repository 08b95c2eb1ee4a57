// See cell_updates.h.
#include "core/grid/cell_updates.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace gridscope {

namespace {

std::vector<uint32_t> dynamicIn(const Grid& grid, ivec3 cell) {
  std::vector<uint32_t> references = storedIn(grid, cell);
  std::erase_if(references, [&](uint32_t reference) { return reference < firstDynamicReference(grid.parameters); });
  std::ranges::sort(references);
  return references;
}

CellUpdate compareCell(const std::vector<uint32_t>& before, const std::vector<uint32_t>& after) {
  std::vector<uint32_t> changed, kept;
  std::ranges::set_symmetric_difference(before, after, std::back_inserter(changed));
  std::ranges::set_intersection(before, after, std::back_inserter(kept));
  CellUpdate update{};
  update.kept = uint32_t(kept.size());
  update.cleared = uint32_t(before.size()) - update.kept;
  update.filled = uint32_t(after.size()) - update.kept;
  update.instance = !changed.empty() ? referenceInstance(changed.front()) : !kept.empty() ? referenceInstance(kept.front()) : kNoReference;
  return update;
}

}  // namespace

std::vector<CellUpdate> compareUpdate(const Grid& before, const Grid& after) {
  const GridParameters& grid = after.parameters;
  CHECK(before.parameters.cellCount == grid.cellCount);
  std::vector<CellUpdate> updates(cellCountOf(grid));
  forRanges(size_t(grid.cellCount.z), 1, [&](size_t begin, size_t end) {
    forCellsOfLayers(grid, int(begin), int(end),
                     [&](ivec3 cell) { updates[cellNumber(grid, cell)] = compareCell(dynamicIn(before, cell), dynamicIn(after, cell)); });
  });
  return updates;
}

}  // namespace gridscope
