// See scene_places.h.
#include "app/frame/scene_places.h"

#include <algorithm>

#include "app/frame/find_next.h"
#include "shaders/shared/grid/overlap.h"

namespace gridscope {

namespace {

template <typename Accepts>
std::optional<uint32_t> nextTruth(const FrameSnapshot& frame, std::optional<uint32_t> from, const Accepts& accepts) {
  if (!frame.truths || frame.truths->empty()) return std::nullopt;
  const size_t count = frame.truths->size(), start = from && *from < count ? *from : count - 1;
  for (size_t step = 1; step <= count; ++step)
    if (accepts((*frame.truths)[(start + step) % count])) return static_cast<uint32_t>((start + step) % count);
  return std::nullopt;
}

}  // namespace

CellContents cellContents(const FrameSnapshot& frame, const ivec3& cell) {
  const Grid& grid = *frame.grid;
  const CellFacts facts = cellFacts(grid, cell);
  CellContents contents;
  contents.stored = storedIn(grid, cell);
  contents.refusedCount = facts.refused;
  contents.saturated = facts.saturated;
  contents.staticRefused = facts.staticRefused;
  contents.dynamicRefused = facts.dynamicRefused;
  contents.refusedKnown = frame.demand != nullptr;
  if (frame.demand) contents.refused = refusedBy(grid, *frame.demand, cell);
  return contents;
}

TriangleCells cellsOfTriangle(const FrameSnapshot& frame, uint32_t reference) {
  TriangleCells cells;
  cells.refusedKnown = frame.demand != nullptr;
  const Instance& instance = frame.scene->numbered.instances[referenceInstance(reference)];
  const Triangle& triangle = (*frame.worldTriangles)[instance.firstWorldTriangle + referenceTriangle(reference)];
  const CellRange range = triangleCells(frame.grid->parameters, triangle);
  const uint32_t count = cellRangeCount(range);
  for (uint32_t i = 0; i < count; ++i) {
    const ivec3 cell = cellRangeCell(range, i);
    const std::vector<uint32_t> stored = storedIn(*frame.grid, cell);
    if (std::find(stored.begin(), stored.end(), reference) != stored.end())
      cells.stored.push_back(cell);
    else if (frame.demand && frame.demand->wants(cell, reference))
      cells.refused.push_back(cell);
  }
  return cells;
}

const CellLoss* lossOf(const Ledger* ledger, const GridParameters& grid, const ivec3& cell) {
  if (!ledger) return nullptr;
  const auto before = [&](const CellLoss& loss, uint64_t number) { return cellNumber(grid, loss.cell) < number; };
  const auto found = std::lower_bound(ledger->cells.begin(), ledger->cells.end(), cellNumber(grid, cell), before);
  return found != ledger->cells.end() && found->cell == cell ? &*found : nullptr;
}

const TriangleLoss* lossOf(const Ledger* ledger, uint32_t reference) {
  if (!ledger) return nullptr;
  const auto before = [](const TriangleLoss& loss, uint32_t wanted) { return loss.reference < wanted; };
  const auto found = std::lower_bound(ledger->triangles.begin(), ledger->triangles.end(), reference, before);
  return found != ledger->triangles.end() && found->reference == reference ? &*found : nullptr;
}

const GroupLoss* lossOfInstance(const Ledger* ledger, uint32_t sceneInstance) {
  if (!ledger) return nullptr;
  const auto before = [](const GroupLoss& loss, uint32_t wanted) { return loss.index < wanted; };
  const auto found = std::lower_bound(ledger->instances.begin(), ledger->instances.end(), sceneInstance, before);
  return found != ledger->instances.end() && found->index == sceneInstance ? &*found : nullptr;
}

std::optional<uint32_t> nextRayOfCell(const FrameSnapshot& frame, const ivec3& cell, std::optional<uint32_t> from) {
  return nextTruth(frame, from, [&](const RayTruth& truth) { return truth.cause != kCauseNone && truth.cell == cell; });
}

std::optional<uint32_t> nextRayOfTriangle(const FrameSnapshot& frame, uint32_t reference, std::optional<uint32_t> from) {
  return nextTruth(frame, from, [&](const RayTruth& truth) { return truth.cause != kCauseNone && truth.exactReference == reference; });
}

float triangleArea(const Triangle& triangle) { return 0.5f * glm::length(triangleNormal(triangle)); }

}  // namespace gridscope
