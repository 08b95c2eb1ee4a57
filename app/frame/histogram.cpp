// See histogram.h.
#include "app/frame/histogram.h"

#include <algorithm>

#include "app/frame/find_next.h"
#include "app/frame/table_rows.h"

namespace gridscope {

uint64_t Histogram::most() const { return counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end()); }

Histogram countValues(std::span<const uint32_t> values, uint32_t reach, uint32_t bars) {
  Histogram histogram;
  if (values.empty() || bars == 0) return histogram;
  histogram.largest = *std::max_element(values.begin(), values.end());
  histogram.total = values.size();
  const uint32_t end = std::min(reach, histogram.largest);
  histogram.width = end / bars + 1;
  histogram.counts.resize(end / histogram.width + 1);
  for (const uint32_t value : values) ++histogram.counts[std::min<size_t>(value / histogram.width, histogram.counts.size() - 1)];
  histogram.lastIsOpen = histogram.largest / histogram.width >= histogram.counts.size();
  return histogram;
}

static std::vector<uint32_t> cellValues(const Grid& grid, bool refusedToo) {
  const ivec3 count = grid.parameters.cellCount;
  std::vector<uint32_t> values;
  for (uint32_t id = 0; id < uint32_t(count.x) * uint32_t(count.y) * uint32_t(count.z); ++id) {
    const CellFacts cell = cellFacts(grid, cellOfId(grid.parameters, id));
    if (cell.tried() > 0) values.push_back(refusedToo ? cell.tried() : cell.stored);
  }
  return values;
}

static std::vector<uint32_t> rayValues(const FrameSnapshot& frame, uint32_t RayCounters::*counter) {
  std::vector<uint32_t> values;
  if (!frame.hits || !frame.counters) return values;
  for (size_t ray = 0; ray < std::min(frame.hits->size(), frame.counters->size()); ++ray)
    if ((*frame.hits)[ray].kind != kHitNoRay) values.push_back((*frame.counters)[ray].*counter);
  return values;
}

std::vector<uint32_t> countedValues(Counted what, const FrameSnapshot& frame) {
  switch (what) {
    case Counted::stored: return frame.grid ? cellValues(*frame.grid, false) : std::vector<uint32_t>{};
    case Counted::tried: return frame.grid ? cellValues(*frame.grid, true) : std::vector<uint32_t>{};
    case Counted::visits: return rayValues(frame, &RayCounters::visits);
    case Counted::tests: return rayValues(frame, &RayCounters::tests);
  }
  return {};
}

uint32_t reachOf(std::vector<uint32_t> values) {
  if (values.empty()) return 1;
  const auto place = values.begin() + std::ptrdiff_t((values.size() - 1) * 99 / 100);
  std::nth_element(values.begin(), place, values.end());
  return std::max(1u, *place);
}

}  // namespace gridscope
