// The trace in C++: the same traversal files as the shaders', compiled by this language. Reference for every device, the path of
// `--device cpu`, and the brute-force truth that tests compare with.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/grid/grid.h"
#include "core/scene/numbering.h"
#include "shaders/shared/trace/ray.h"

namespace gridscope {

// What a trace reads beside the rays.
struct TraceInput {
  const Grid& grid;
  const NumberedScene& scene;
  std::span<const Triangle> worldTriangles;
  TraceParameters parameters;
};

// Traces all rays over the cores. `counters` may be empty; otherwise one entry a ray.
void traceRays(const TraceInput& input, std::span<const Ray> rays, std::span<Hit> hits, std::span<RayCounters> counters);

// One triangle test of a recorded ray.
struct TestRecord {
  uint32_t slot;
  uint32_t reference;
  uint32_t verdict;    // kTest...
  float t;             // where the ray passes through the triangle
  uint32_t alphaByte;  // byte read by alpha keying; 256: not keyed or not asked
  bool operator==(const TestRecord&) const = default;
};

// One segment (dda: one cell) of a recorded ray.
struct StepRecord {
  int32_t segment;
  float start;  // along the ray, world units
  ivec3 cell;
  uint32_t outcome;  // kStep...
  std::vector<TestRecord> tests;
  int32_t stored = 0;  // references read
  bool saturated = false;
  float travel = 0.0f;  // what the gate compares, world units
  bool operator==(const StepRecord&) const = default;
};

struct RayRecord {
  std::vector<StepRecord> steps;
  Hit hit{};
};

RayRecord recordRay(const TraceInput& input, const Ray& ray);

// Nearest hit among all world triangles, without a grid: alpha keyed and tMin as the trace. Slow; for tests and for the truth of single rays.
Hit traceBruteForce(const TraceInput& input, const Ray& ray);

}  // namespace gridscope
