// How many rays of a frame ask each cell for its references.
#pragma once

#include <span>
#include <vector>

#include "core/trace/trace.h"
#include "shaders/shared/trace/ray.h"

namespace gridscope {

// Traces all rays again, on all cores, with hooks that count. A ray asks a cell at most once: its way through a cell is one piece,
// and the cell visited last is not asked again. x fastest.
std::vector<CellRays> countCellRays(const TraceInput& input, std::span<const Ray> rays);

}  // namespace gridscope
