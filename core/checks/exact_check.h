// Compares traced rays with the nearest hit among all triangles, found without a grid.
#pragma once

#include <span>
#include <vector>

#include "core/trace/trace.h"

namespace gridscope {

// A ray whose traced hit is not the exact one.
struct ExactDifference {
  uint32_t ray;
  Hit traced;
  Hit exact;
  bool grazes;  // either hit lies within 1e-4 (in barycentrics) of its triangle's edge: rounding decides there
};

struct ExactComparison {
  uint32_t compared = 0;                     // valid rays, evenly spread over all
  std::vector<ExactDifference> differences;  // by rising ray
};

// Agreement: both miss, or a triangle hit with |t - exact| <= 1e-3 cell edges. Takes time in proportion to count * triangles, on all cores.
ExactComparison compareWithExact(const TraceInput& input, std::span<const Ray> rays, std::span<const Hit> hits, uint32_t count);

}  // namespace gridscope
