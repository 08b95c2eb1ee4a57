// What is said of many rays in a few numbers.
#pragma once

#include <span>

#include "core/base/statistics.h"
#include "shaders/shared/trace/ray.h"

namespace gridscope {

struct RayTotals {
  uint64_t count = 0;  // valid rays: the three below
  uint64_t triangleHits = 0;
  uint64_t voxelHits = 0;
  uint64_t misses = 0;  // left the grid, never met it, or reached the limit of segments
};

// Pixels without a ray are not counted.
RayTotals countRays(std::span<const Hit> hits);

struct CounterTotals {
  Summary visits;
  Summary tests;
};

// Over the valid rays. One counter a hit.
CounterTotals summariseCounters(std::span<const RayCounters> counters, std::span<const Hit> hits);

}  // namespace gridscope
