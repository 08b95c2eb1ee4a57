// See exact_check.h.
#include "core/checks/exact_check.h"

#include <algorithm>
#include <mutex>

#include "core/base/parallel.h"
#include "core/truth/truth.h"

namespace gridscope {
namespace {

constexpr float kGrazing = 1e-4f;  // barycentrics

bool atEdge(const Hit& hit) { return hit.kind == kHitTriangle && std::min({hit.u, hit.v, 1.0f - hit.u - hit.v}) < kGrazing; }

}  // namespace

ExactComparison compareWithExact(const TraceInput& input, std::span<const Ray> rays, std::span<const Hit> hits, uint32_t count) {
  std::vector<uint32_t> valid;
  for (uint32_t i = 0; i < rays.size(); ++i)
    if (rays[i].valid) valid.push_back(i);
  ExactComparison comparison;
  comparison.compared = std::min<uint32_t>(count, uint32_t(valid.size()));

  std::mutex mutex;
  forRanges(comparison.compared, 16, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      uint32_t ray = valid[i * valid.size() / comparison.compared];
      Hit exact = traceBruteForce(input, rays[ray]);
      if (judge(hits[ray], exact, input.grid.parameters) == kVerdictAgrees) continue;
      std::lock_guard lock(mutex);
      comparison.differences.push_back({ray, hits[ray], exact, atEdge(exact) || atEdge(hits[ray])});
    }
  });
  std::sort(comparison.differences.begin(), comparison.differences.end(), [](const auto& a, const auto& b) { return a.ray < b.ray; });
  return comparison;
}

}  // namespace gridscope
