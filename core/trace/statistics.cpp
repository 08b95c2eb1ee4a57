// See statistics.h.
#include "core/trace/statistics.h"

#include "core/base/error.h"

namespace gridscope {

RayTotals countRays(std::span<const Hit> hits) {
  RayTotals totals;
  for (const Hit& hit : hits) {
    if (hit.kind == kHitNoRay) continue;
    totals.count += 1;
    if (hit.kind == kHitTriangle)
      totals.triangleHits += 1;
    else if (hit.kind == kHitVoxel)
      totals.voxelHits += 1;
    else
      totals.misses += 1;
  }
  return totals;
}

CounterTotals summariseCounters(std::span<const RayCounters> counters, std::span<const Hit> hits) {
  CHECK_EQ(counters.size(), hits.size());
  std::vector<uint32_t> visits, tests;
  for (size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].kind == kHitNoRay) continue;
    visits.push_back(counters[i].visits);
    tests.push_back(counters[i].tests);
  }
  return {.visits = summarise(visits), .tests = summarise(tests)};
}

}  // namespace gridscope
