// What is said of many rays, triangles or runs in a few numbers. Plain functions over products; nothing here changes what is traced.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shaders/shared/pipeline/parameters.h"

namespace gridscope {

// Of a whole number counted for each ray.
struct Summary {
  double mean = 0.0;
  uint32_t p99 = 0;  // 99 in 100 rays have at most this many
  uint32_t max = 0;
};

// All zero for no values.
Summary summarise(std::span<const uint32_t> values);

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

struct TriangleTotals {
  uint64_t degenerate = 0;  // without area: not inserted
  uint64_t outside = 0;     // the bounding box reaches beyond the grid
};

// Over world triangles, as the stages count them, whatever the update's mode.
TriangleTotals countTriangles(const GridParameters& grid, std::span<const Triangle> worldTriangles);

// Of times, in the unit they come in.
struct Spread {
  double min = 0.0;
  double median = 0.0;
  double max = 0.0;
};

// All zero for no values.
Spread spreadOf(std::vector<double> values);

}  // namespace gridscope
