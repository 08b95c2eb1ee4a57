// See invariants_rays.h.
#include "core/trace/invariants_rays.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace gridscope {

namespace {

template <typename Breaks>
Invariant testEach(Invariant invariant, std::span<const Hit> hits, const char* text, Breaks breaks) {
  size_t first = hits.size();
  for (size_t i = 0; i < hits.size(); ++i)
    if (breaks(i)) first = std::min(first, i), ++invariant.count;
  if (invariant.count > 0)
    invariant.fault = std::to_string(invariant.count) + " rays " + text + "; the first is ray " + std::to_string(first);
  return invariant;
}

bool namesTriangle(const NumberedScene& scene, uint32_t reference) {
  return referenceInstance(reference) < scene.instanceCount() &&
         referenceTriangle(reference) < scene.instances[referenceInstance(reference)].triangleCount;
}

}  // namespace

Invariant testEnds(std::span<const Ray> rays, std::span<const Hit> hits) {
  CHECK_EQ(rays.size(), hits.size());
  return testEach({.key = "ended", .name = "every ray ended with a reason"}, hits, "ended without a reason", [&](size_t i) {
    const uint32_t kind = hits[i].kind;
    if ((kind == kHitNoRay) != (rays[i].valid == 0)) return true;
    return kind != kHitNoRay && kind != kHitMiss && kind != kHitTriangle && kind != kHitVoxel && kind != kHitLimit;
  });
}

Invariant testHits(const NumberedScene& scene, const TraceParameters& trace, std::span<const Hit> hits) {
  return testEach({.key = "hitsInRange", .name = "hits name triangles of the scene"}, hits, "hit no triangle of the scene, or out of reach",
                  [&](size_t i) {
                    const Hit& hit = hits[i];
                    if (hit.kind != kHitTriangle && hit.kind != kHitVoxel) return false;
                    const float least = hit.kind == kHitTriangle ? trace.tMin : 0.0f;
                    return !namesTriangle(scene, hit.reference) || !std::isfinite(hit.t) || hit.t < least;
                  });
}

Invariant testGridKept(const Grid& before, const Grid& after) {
  Invariant invariant{.key = "gridKept", .name = "the trace left the grid as it was"};
  if (before.words == after.words) return invariant;
  invariant.count = 1;
  invariant.fault = "a word of it changed while rays were traced";
  return invariant;
}

}  // namespace gridscope
