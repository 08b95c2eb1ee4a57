// See cell_boxes.h.
#include "app/frame/cell_boxes.h"

#include <algorithm>
#include <unordered_map>

namespace gridscope {

static constexpr BoxMeasure kMeasures[] = {
    {"references tried", [](const BoxCell& c) { return c.full.tried(); }, true, false},
    {"references stored", [](const BoxCell& c) { return c.full.stored; }, true, false},
    {"references refused", [](const BoxCell& c) { return c.full.refused; }, true, false},
    {"rays that read it", [](const BoxCell& c) { return c.rays.read; }, false, true},
    {"rays that found it empty", [](const BoxCell& c) { return c.rays.empty; }, false, true},
};

std::span<const BoxMeasure> boxMeasures() { return kMeasures; }

const BoxMeasure& boxMeasure(const Overlays& overlays) { return kMeasures[std::min(overlays.boxMeasure, std::size(kMeasures) - 1)]; }

std::vector<BoxCell> occupiedCells(const Grid& grid, std::span<const CellRays> rays) {
  std::vector<BoxCell> cells;
  const ivec3 count = grid.parameters.cellCount;
  size_t number = 0;
  ivec3 cell;
  for (cell.z = 0; cell.z < count.z; ++cell.z)
    for (cell.y = 0; cell.y < count.y; ++cell.y)
      for (cell.x = 0; cell.x < count.x; ++cell.x, ++number) {
        const BoxCell box{cellFacts(grid, cell), number < rays.size() ? rays[number] : CellRays{}};
        if (box.full.tried() > 0 || box.rays.read > 0 || box.rays.empty > 0) cells.push_back(box);
      }
  return cells;
}

float boxTop(const BoxMeasure& measure, std::span<const BoxCell> occupied, int capacity) {
  if (measure.byCapacity) return float(capacity);
  std::vector<uint32_t> values;
  for (const BoxCell& cell : occupied)
    if (const uint32_t value = measure.value(cell); value > 0) values.push_back(value);
  if (values.empty()) return 1.0f;
  const auto at = values.begin() + ptrdiff_t(double(values.size() - 1) * 0.99);
  std::nth_element(values.begin(), at, values.end());
  return float(std::max(*at, 1u));
}

BoxChoice chooseBoxes(std::span<const BoxCell> occupied, const GridParameters& grid, const Overlays& overlays,
                      const CameraParameters& camera, size_t most) {
  struct Candidate {
    float distance;
    uint32_t index;
  };
  const BoxMeasure& measure = boxMeasure(overlays);
  std::vector<Candidate> candidates;
  for (uint32_t i = 0; i < occupied.size(); ++i) {
    const CellFacts& cell = occupied[i].full;
    const int64_t value = measure.value(occupied[i]);
    const bool inRange = value >= overlays.boxRange[0] && value <= overlays.boxRange[1];
    if (!(overlays.cellBoxes && inRange) && !(overlays.saturatedBoxes && cell.saturated)) continue;
    const Bounds bounds = cellBounds(grid, cell.cell);
    const vec3 centre = 0.5f * (bounds.low + bounds.high);
    const bool cut = overlays.clip && !overlays.clipBox.empty() &&
                     (glm::any(glm::lessThan(centre, overlays.clipBox.low)) || glm::any(glm::greaterThan(centre, overlays.clipBox.high)));
    if (!cut && inView(camera, bounds)) candidates.push_back({glm::length(centre - camera.eye), i});
  }

  const size_t kept = std::min(most, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + kept, candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
  });
  BoxChoice choice;
  choice.wanted = candidates.size();
  for (size_t i = 0; i < kept; ++i) choice.cells.push_back(occupied[candidates[i].index]);
  return choice;
}

std::vector<BoxEdge> boxEdgesOf(std::span<const BoxCell> cells, const GridParameters& grid, const BoxMeasure& measure) {
  // An edge is named by its lower lattice point and its axis.
  std::unordered_map<uint64_t, size_t> known;
  std::vector<BoxEdge> edges;
  const uint64_t sideX = uint64_t(grid.cellCount.x) + 1, sideY = uint64_t(grid.cellCount.y) + 1;
  for (const BoxCell& box : cells) {
    const CellFacts& cell = box.full;
    const std::array<WorldLine, 12> lines = boxEdges(cellBounds(grid, cell.cell));
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 4; ++side) {
        ivec3 low = cell.cell;
        low[(axis + 1) % 3] += side & 1;
        low[(axis + 2) % 3] += side >> 1;
        const uint64_t name = (((uint64_t(low.z) * sideY + uint64_t(low.y)) * sideX + uint64_t(low.x)) << 2) | uint64_t(axis);
        const auto [place, isNew] = known.try_emplace(name, edges.size());
        if (isNew) edges.push_back({.line = lines[size_t(axis * 4 + side)]});
        BoxEdge& edge = edges[place->second];
        edge.value = std::max(edge.value, measure.value(box));
        edge.saturated = edge.saturated || cell.saturated;
      }
  }
  return edges;
}

}  // namespace gridscope
