// See reason.h.
#include "core/truth/reason.h"

#include <algorithm>
#include <cmath>

#include "core/trace/loads.h"
#include "core/truth/cause.h"

namespace gridscope {

namespace {

struct SpanTrace : TraceLoads {
  using TraceLoads::TraceLoads;
#include "shaders/shared/trace/traverse.h"
};

TruthReason refusedReason(const GridParameters& grid) {
  if (!gridAbilities(grid).countsRefusals) return {"full", "The cell is full; this grid does not count what its cells refused."};
  if (grid.insertion == kInsertionSorted)
    return {"largerReference", "Sorted insertion keeps the smallest references: the slots hold smaller ones."};
  return {"cameLater", "The first to come keep the slots: they were taken when it came."};
}

// What the two segments around a cell's stay left between them.
TruthReason steppedOverReason(const TruthInput& input, const Ray& ray, const RayTruth& truth) {
  const GridParameters& grid = input.trace.grid.parameters;
  const float before = std::floor(cellStay(grid, ray, truth.cell).x / grid.cellEdge);
  const auto startIn = [&](float segment) { return gridCell(grid, rayPoint(ray, segment * grid.cellEdge)); };
  const ivec3 crossed = startIn(before + 1.0f) - startIn(before);
  const int axes = (crossed.x != 0) + (crossed.y != 0) + (crossed.z != 0);
  if (axes >= 3) return {"corner", "A corner of the cell was cut."};
  if (axes == 2) return {"edge", "An edge of the cell was cut."};
  return {"face", "The cell was crossed from face to face between two starts."};
}

// On which side of its cell's window the hit lies.
TruthReason segmentEndReason(const TruthInput& input, const Ray& ray, const RayTruth& truth) {
  const RayRecord record = recordRay(input.trace, ray);
  const auto step =
      std::ranges::find_if(record.steps, [&](const StepRecord& one) { return one.segment == truth.segment && one.cell == truth.cell; });
  if (step == record.steps.end()) return {};
  if (truth.exactT < stepWindow(input.trace.parameters, *step).x)
    return {"before", "The hit lies before the part of the ray that the segment tests."};
  return {"behind", "The hit lies behind the part of the ray that the segment tests."};
}

TruthReason alphaReason(const RayTruth& truth) {
  if (truth.reference == truth.exactReference) return {"turnedDown", "By this frame's rules the hit counts, and it was turned down."};
  return {"letThrough", "By this frame's rules its alpha turns the hit down, and it was let through."};
}

TruthReason selfHitReason(const RayTruth& truth) {
  if (truth.reference == truth.exactReference) return {"hidden", "The surface is so near that another nearest distance hides it."};
  return {"made", "The hit is nearer than the nearest distance that counts."};
}

TruthReason outsideReason(const TruthInput& input, const Ray& ray, const RayTruth& truth) {
  const vec2 span = SpanTrace(input.trace).gridSpan(input.trace.grid.parameters, ray);
  if (span.x > span.y) return {"ray", "The ray never meets the grid."};
  if (truth.exactT < span.x) return {"before", "The surface lies before the ray comes into the grid."};
  return {"behind", "The surface lies beyond the grid."};
}

TruthReason leftOutReason(const TruthInput& input, const RayTruth& truth) {
  if (triangleDegenerate(triangleNormal(referencedTriangle(input.trace, truth.reference))))
    return {"noArea", "The triangle has no area: its normal's square is below 1e-30."};
  if (input.demand.wants(truth.cell, truth.reference))
    return {"otherBuilder", "The cell has room, and this tool's overlap test would have put it there: the grid's builder did not."};
  return {"overlapTest", "The overlap test keeps it out of the cell that the hit lies in."};
}

TruthReason staleReason(const TruthInput& input, const RayTruth& truth) {
  if (truth.reference != truth.exactReference) return {"leftBehind", "It is a dynamic reference in a cell where it no longer belongs."};
  const std::vector<uint32_t> stored = storedIn(input.trace.grid, truth.cell);
  if (stored.size() < size_t(input.trace.grid.parameters.capacity))
    return {"missed", "It is a dynamic reference that the update did not add."};
  return {"slotTaken", "A dynamic reference that no longer belongs there holds one of the slots."};
}

TruthReason notInsertedReason(const TruthInput& input, const RayTruth& truth) {
  const std::vector<uint32_t> stored = storedIn(input.trace.grid, truth.cell);
  if (stored.size() < size_t(input.trace.grid.parameters.capacity)) return {"room", "The cell has room for it."};
  return {"smaller", "The cell is full, and holds references that it should have refused instead."};
}

}  // namespace

TruthReason reasonOf(const TruthInput& input, const Ray& ray, const RayTruth& truth) {
  switch (truth.cause) {
    case kCauseRefused: return refusedReason(input.trace.grid.parameters);
    case kCauseSteppedOver: return steppedOverReason(input, ray, truth);
    case kCauseSegmentEnd: return segmentEndReason(input, ray, truth);
    case kCauseAlpha: return alphaReason(truth);
    case kCauseSelfHit: return selfHitReason(truth);
    case kCauseOutside: return outsideReason(input, ray, truth);
    case kCauseLeftOut: return leftOutReason(input, truth);
    case kCauseStale: return staleReason(input, truth);
    case kCauseNotInserted: return notInsertedReason(input, truth);
    default: return {};
  }
}

}  // namespace gridscope
