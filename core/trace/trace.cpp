// The trace in C++, fast and counting, and the truth without a grid. core/trace/record.cpp includes the same traversal a third time.
#include "core/trace/trace.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/trace/loads.h"

namespace gridscope {

namespace {

struct FastTrace : TraceLoads {
  using TraceLoads::TraceLoads;
#include "shaders/shared/trace/traverse.h"
};

#define ON_SEGMENT(segment, start, cell, outcome) counters.visits += outcome == kStepEmpty || outcome == kStepRead ? 1u : 0u
#define ON_TEST(slot, reference, test, alphaByte) counters.tests += 1u
struct CountingTrace : TraceLoads {
  using TraceLoads::TraceLoads;
  RayCounters counters{};
#include "shaders/shared/trace/traverse.h"
};

// Rays that a core takes at a time: long enough to be worth a thread's while, short enough that all end together.
constexpr size_t kRaysPerRange = 1024;

}  // namespace

void traceRays(const TraceInput& input, std::span<const Ray> rays, std::span<Hit> hits, std::span<RayCounters> counters) {
  CHECK_EQ(hits.size(), rays.size());
  CHECK(counters.empty() || counters.size() == rays.size());
  forRanges(rays.size(), kRaysPerRange, [&](size_t begin, size_t end) {
    FastTrace fast(input);
    CountingTrace counting(input);
    for (size_t i = begin; i < end; ++i) {
      if (counters.empty()) {
        hits[i] = traceAllPasses(fast, input, rays[i]);
      } else {
        counting.counters = {};
        hits[i] = traceAllPasses(counting, input, rays[i]);
        counters[i] = counting.counters;
      }
    }
  });
}

Hit traceBruteForce(const TraceInput& input, const Ray& ray) {
  FastTrace trace(input);
  if (ray.valid == 0u) return missedHit(kHitNoRay);

  // References in rising order: of equal distances the first, the smaller one, stays.
  float best = kFar;
  uint bestReference = kNoReference;
  for (uint32_t i = 0; i < input.scene.instanceCount(); ++i) {
    const Instance& instance = input.scene.instances[i];
    for (uint32_t k = 0; k < instance.triangleCount; ++k) {
      const Triangle& triangle = input.worldTriangles[instance.firstWorldTriangle + k];
      const TriangleTest test = testTriangle(ray, triangle, input.parameters.tMin, kFar);
      if (test.verdict != kTestHit || test.t >= best) continue;
      uint alphaByte;
      if (!trace.alphaPasses(makeReference(i, k), triangle, rayPoint(ray, test.t), alphaByte)) continue;
      best = test.t;
      bestReference = makeReference(i, k);
    }
  }
  return bestReference == kNoReference ? missedHit(kHitMiss) : trace.finishHit(ray, makeHit(kHitTriangle, best, bestReference));
}

}  // namespace gridscope
