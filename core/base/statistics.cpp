// See statistics.h.
#include "core/base/statistics.h"

#include <algorithm>

#include "core/base/error.h"
#include "shaders/shared/scene/triangle.h"

namespace gridscope {

Summary summarise(std::span<const uint32_t> values) {
  if (values.empty()) return {};
  uint64_t sum = 0;
  for (uint32_t value : values) sum += value;

  // The smallest value that at least 99 % of the values do not exceed.
  std::vector<uint32_t> ranked(values.begin(), values.end());
  const size_t rank = (ranked.size() * 99 + 99) / 100 - 1;
  std::ranges::nth_element(ranked, ranked.begin() + rank);
  return {.mean = double(sum) / double(values.size()), .p99 = ranked[rank], .max = *std::ranges::max_element(values)};
}

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

TriangleTotals countTriangles(const GridParameters& grid, std::span<const Triangle> worldTriangles) {
  TriangleTotals totals;
  for (const Triangle& triangle : worldTriangles) {
    if (triangleDegenerate(triangleNormal(triangle)))
      totals.degenerate += 1;
    else if (triangleCells(grid, triangle).clipped)
      totals.outside += 1;
  }
  return totals;
}

Spread spreadOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const size_t middle = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
  return {.min = values.front(), .median = median, .max = values.back()};
}

}  // namespace gridscope
