// See cell_rays.h: the traversal once more, with a hook that counts by cell.
#include "core/trace/cell_rays.h"

#include <atomic>

#include "core/base/parallel.h"
#include "core/trace/loads.h"

namespace gridscope {

namespace {

#define ON_SEGMENT(segment, start, cell, outcome) countSegment(grid, cell, outcome)
struct CellCountingTrace : TraceLoads {
  CellCountingTrace(const TraceInput& input, std::span<CellRays> cells) : TraceLoads(input), cells_(cells) {}

  // Other cores count into the same cells.
  void countSegment(const GridParameters& grid, const ivec3& cell, uint outcome) {
    if (outcome != kStepRead && outcome != kStepEmpty) return;
    CellRays& rays = cells_[cellNumber(grid, cell)];
    std::atomic_ref<uint>(outcome == kStepRead ? rays.read : rays.empty).fetch_add(1, std::memory_order_relaxed);
  }
#include "shaders/shared/trace/traverse.h"

 private:
  std::span<CellRays> cells_;
};

constexpr size_t kRaysPerRange = 1024;

}  // namespace

std::vector<CellRays> countCellRays(const TraceInput& input, std::span<const Ray> rays) {
  std::vector<CellRays> cells(cellCountOf(input.grid.parameters));
  forRanges(rays.size(), kRaysPerRange, [&](size_t begin, size_t end) {
    CellCountingTrace trace(input, cells);
    for (size_t i = begin; i < end; ++i) traceAllPasses(trace, input, rays[i]);
  });
  return cells;
}

}  // namespace gridscope
