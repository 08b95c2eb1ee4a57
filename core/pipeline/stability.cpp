// See stability.h.
#include "core/pipeline/stability.h"

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/grid/demand.h"

namespace gridscope {

namespace {

uint32_t compareCell(const Grid& a, const Grid& b, ivec3 cell) {
  std::vector<uint32_t> inA = storedIn(a, cell), inB = storedIn(b, cell);
  if (inA == inB) return kStable;
  std::ranges::sort(inA);
  std::ranges::sort(inB);
  return inA == inB ? kStableSet : kUnstable;
}

// What a user of the hit gets.
bool sameResult(const Hit& a, const Hit& b) {
  return a.kind == b.kind && a.reference == b.reference && std::memcmp(&a.t, &b.t, sizeof a.t) == 0;
}

}  // namespace

void BuildComparison::add(Grid grid, std::span<const Hit> hits) {
  if (found_.builds++ == 0) {
    first_ = std::move(grid);
    firstHits_.assign(hits.begin(), hits.end());
    found_.cells.assign(cellCountOf(first_.parameters), kStable);
    found_.rays.assign(hits.size(), 0);
    return;
  }
  CHECK_EQ(hits.size(), firstHits_.size());
  const ivec3 count = first_.parameters.cellCount;
  forRanges(size_t(count.z), 1, [&](size_t begin, size_t end) {
    for (ivec3 cell(0, 0, int(begin)); cell.z < int(end); ++cell.z)
      for (cell.y = 0; cell.y < count.y; ++cell.y)
        for (cell.x = 0; cell.x < count.x; ++cell.x) {
          uint32_t& worst = found_.cells[cellNumber(first_.parameters, cell)];
          worst = std::max(worst, compareCell(first_, grid, cell));
        }
  });
  for (size_t i = 0; i < hits.size(); ++i) found_.rays[i] |= sameResult(firstHits_[i], hits[i]) ? 0u : 1u;
}

Stability BuildComparison::result() const {
  Stability result = found_;
  const GridParameters& grid = first_.parameters;
  forCellsOfLayers(grid, 0, grid.cellCount.z, [&](ivec3 cell) { result.occupied += cellOccupied(first_, cell) ? 1 : 0; });
  result.setDiffers = uint64_t(std::ranges::count(result.cells, kUnstable));
  result.orderDiffers = uint64_t(std::ranges::count(result.cells, kStableSet));
  result.raysChange = uint64_t(std::ranges::count(result.rays, 1u));
  return result;
}

Stability compareBuilds(Pipeline& pipeline, uint32_t builds, const std::function<void()>& rebuild) {
  BuildComparison comparison;
  for (uint32_t build = 0; build < builds; ++build) {
    rebuild();
    pipeline.trace(false);
    comparison.add(pipeline.grid(), pipeline.hits());
  }
  return comparison.result();
}

}  // namespace gridscope
