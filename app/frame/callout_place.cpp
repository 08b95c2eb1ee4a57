// See callout_place.h.
#include "app/frame/callout_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gridscope {

static constexpr float kMargin = 8.0f;                                   // to the pane's edges and to what is avoided, units
static constexpr std::array<float, 3> kDistances{56.0f, 96.0f, 150.0f};  // of the box's edge from the place, units
static constexpr int kDirections = 12;

static bool meet(const Area& a, const Area& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

static float overlap(const Area& a, const Area& b) {
  if (!meet(a, b)) return 0.0f;
  const vec2 size = glm::min(a.high, b.high) - glm::max(a.low, b.low);
  return size.x * size.y;
}

vec2 placeCallout(const Area& pane, vec2 at, vec2 size, std::span<const vec2> points, std::span<const Area> boxes, float unit) {
  const vec2 margin(kMargin * unit), least = pane.low + margin, most = glm::max(pane.high - margin - size, least);
  vec2 best = glm::clamp(at, least, most);
  float bestCost = std::numeric_limits<float>::max();
  for (size_t ring = 0; ring < kDistances.size(); ++ring)
    for (int i = 0; i < kDirections; ++i) {
      // Up and aside first: there the box's leader is short.
      const float angle = 6.2831853f * (float(i) + 0.5f) / float(kDirections);
      const vec2 way(std::sin(angle), -std::cos(angle));
      const vec2 wanted = at + way * (kDistances[ring] * unit + 0.5f * std::abs(way.x) * size.x) - 0.5f * size,
                 low = glm::clamp(wanted, least, most);
      const Area box{low - margin, low + size + margin};
      float cost = float(ring) * 2.0f + 0.02f * glm::length(low - wanted) / unit;
      for (const vec2& point : points)
        cost += point.x > box.low.x && point.y > box.low.y && point.x < box.high.x && point.y < box.high.y ? 3.0f : 0.0f;
      for (const Area& other : boxes) cost += 60.0f * overlap(box, other) / (size.x * size.y);
      if (at.x > box.low.x && at.y > box.low.y && at.x < box.high.x && at.y < box.high.y) cost += 40.0f;
      if (cost < bestCost) bestCost = cost, best = low;
    }
  return vec2(std::floor(best.x), std::floor(best.y));
}

}  // namespace gridscope
