// See cell_boxes.h.
#include "app/cell_boxes.h"

#include <algorithm>
#include <unordered_map>

namespace gridscope {

std::vector<FullCell> occupiedCells(const Grid& grid) {
  std::vector<FullCell> cells;
  const ivec3 count = grid.parameters.cellCount;
  ivec3 cell;
  for (cell.z = 0; cell.z < count.z; ++cell.z)
    for (cell.y = 0; cell.y < count.y; ++cell.y)
      for (cell.x = 0; cell.x < count.x; ++cell.x)
        if (const FullCell full = fullnessOf(grid, cell); full.tried() > 0) cells.push_back(full);
  return cells;
}

BoxChoice chooseBoxes(std::span<const FullCell> occupied, const GridParameters& grid, const Overlays& overlays, const CameraParameters& camera, size_t most) {
  struct Candidate {
    float distance;
    uint32_t index;
  };
  std::vector<Candidate> candidates;
  for (uint32_t i = 0; i < occupied.size(); ++i) {
    const FullCell& cell = occupied[i];
    const bool inRange = int64_t(cell.tried()) >= overlays.occupancy[0] && int64_t(cell.tried()) <= overlays.occupancy[1];
    if (!(overlays.cellBoxes && inRange) && !(overlays.saturatedBoxes && cell.saturated)) continue;
    const Bounds bounds = cellBounds(grid, cell.cell);
    const vec3 centre = 0.5f * (bounds.low + bounds.high);
    const bool cut = overlays.clip && !overlays.clipBox.empty() &&
                     (glm::any(glm::lessThan(centre, overlays.clipBox.low)) || glm::any(glm::greaterThan(centre, overlays.clipBox.high)));
    if (!cut && inView(camera, bounds)) candidates.push_back({glm::length(centre - camera.eye), i});
  }

  const size_t kept = std::min(most, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + kept, candidates.end(),
                    [](const Candidate& a, const Candidate& b) { return a.distance != b.distance ? a.distance < b.distance : a.index < b.index; });
  BoxChoice choice;
  choice.wanted = candidates.size();
  for (size_t i = 0; i < kept; ++i) choice.cells.push_back(occupied[candidates[i].index]);
  return choice;
}

std::vector<BoxEdge> boxEdgesOf(std::span<const FullCell> cells, const GridParameters& grid) {
  // An edge is named by its lower lattice point and its axis.
  std::unordered_map<uint64_t, size_t> known;
  std::vector<BoxEdge> edges;
  const uint64_t sideX = uint64_t(grid.cellCount.x) + 1, sideY = uint64_t(grid.cellCount.y) + 1;
  for (const FullCell& cell : cells) {
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
        edge.tried = std::max(edge.tried, cell.tried());
        edge.saturated = edge.saturated || cell.saturated;
      }
  }
  return edges;
}

}  // namespace gridscope
