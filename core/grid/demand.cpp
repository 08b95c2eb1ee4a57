// See demand.h.
#include "core/grid/demand.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/grid/candidates.h"

namespace gridscope {

namespace {

// A triangle that may be wanted, and the cells of its bounding box.
struct Candidate {
  const Triangle* triangle;
  uint32_t reference;
  CellRange range;
};

std::vector<Candidate> listCandidates(const GridParameters& grid, const NumberedScene& scene, std::span<const Triangle> worldTriangles) {
  std::vector<Candidate> candidates;
  BuildReport counted{};
  for (uint32_t i = 0; i < scene.instanceCount(); ++i)
    forCandidates(scene, i, worldTriangles, grid, counted, [&](const Triangle& triangle, uint32_t reference, const CellRange& range) {
      candidates.push_back({&triangle, reference, range});
    });
  return candidates;
}

// What the cells of one layer want: pairs (cell of the layer, reference), references rising.
struct Wish {
  uint32_t cell;
  uint32_t reference;
};

void addWishes(const GridParameters& grid, const Candidate& candidate, int z, std::vector<Wish>& wishes) {
  const vec3 normal = triangleNormal(*candidate.triangle);
  ivec3 cell(0, 0, z);
  for (cell.y = candidate.range.low.y; cell.y <= candidate.range.high.y; ++cell.y)
    for (cell.x = candidate.range.low.x; cell.x <= candidate.range.high.x; ++cell.x)
      if (cellTakesTriangle(grid, *candidate.triangle, normal, cell))
        wishes.push_back({uint32_t(cell.y) * uint32_t(grid.cellCount.x) + uint32_t(cell.x), candidate.reference});
}

}  // namespace

Demand::Demand(const GridParameters& grid, const NumberedScene& scene, std::span<const Triangle> worldTriangles) : grid_(grid) {
  const std::vector<Candidate> candidates = listCandidates(grid, scene, worldTriangles);
  const size_t layerCells = size_t(grid.cellCount.x) * size_t(grid.cellCount.y), layerCount = size_t(grid.cellCount.z);
  std::vector<std::vector<uint32_t>> layers(layerCount);
  first_.assign(layerCells * layerCount + 1, 0);

  // A core owns whole layers: it asks the candidates in rising order, then sorts the wishes by cell, keeping that order.
  forRanges(layerCount, 1, [&](size_t begin, size_t end) {
    std::vector<Wish> wishes;
    for (size_t z = begin; z < end; ++z) {
      wishes.clear();
      for (const Candidate& candidate : candidates)
        if (candidate.range.low.z <= int(z) && int(z) <= candidate.range.high.z) addWishes(grid, candidate, int(z), wishes);
      uint64_t* counts = &first_[z * layerCells + 1];
      for (const Wish& wish : wishes) ++counts[wish.cell];
      std::vector<uint32_t> next(layerCells);
      for (size_t cell = 1; cell < layerCells; ++cell) next[cell] = next[cell - 1] + uint32_t(counts[cell - 1]);
      layers[z].resize(wishes.size());
      for (const Wish& wish : wishes) layers[z][next[wish.cell]++] = wish.reference;
    }
  });

  // One list of all layers.
  for (size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  references_.reserve(first_.back());
  for (std::vector<uint32_t>& layer : layers) {
    references_.insert(references_.end(), layer.begin(), layer.end());
    std::vector<uint32_t>().swap(layer);
  }
}

std::span<const uint32_t> Demand::wanted(ivec3 cell) const {
  if (first_.empty() || !gridContains(grid_, cell)) return {};
  const size_t index = idOfCell(grid_, cell);
  return std::span(references_).subspan(first_[index], first_[index + 1] - first_[index]);
}

bool Demand::wants(ivec3 cell, uint32_t reference) const {
  const std::span<const uint32_t> references = wanted(cell);
  return std::binary_search(references.begin(), references.end(), reference);
}

std::vector<uint32_t> refusedBy(const Grid& grid, const Demand& demand, ivec3 cell) {
  if (!gridContains(grid.parameters, cell)) return {};
  const CellFacts facts = cellFacts(grid, cell);
  if (facts.stored < uint32_t(grid.parameters.capacity) || !facts.saturated) return {};
  std::vector<uint32_t> stored = storedIn(grid, cell), refused;
  std::sort(stored.begin(), stored.end());
  const std::span<const uint32_t> wanted = demand.wanted(cell);
  std::set_difference(wanted.begin(), wanted.end(), stored.begin(), stored.end(), std::back_inserter(refused));
  return refused;
}

}  // namespace gridscope
