// See cause.h. The words home cell, home step, ended before are TRUTH.md's.
#include "core/truth/cause.h"

#include <algorithm>
#include <cmath>

#include "core/trace/loads.h"

namespace gridscope {

namespace {

// A hit this near to a cell, in cell edges, lies in it: floors and walls like to lie on cell faces, and rounding decides on which side.
const float kHomeTolerance = kAgreement;

bool nearCell(const GridParameters& grid, ivec3 cell, const vec3& point) {
  const float reach = kHomeTolerance * grid.cellEdge;
  for (int axis = 0; axis < 3; ++axis)
    if (point[axis] < gridFace(grid, axis, cell[axis]) - reach || point[axis] > gridFace(grid, axis, cell[axis] + 1) + reach) return false;
  return true;
}

const TestRecord* findTest(const StepRecord& step, uint32_t reference) {
  const auto found = std::ranges::find(step.tests, reference, &TestRecord::reference);
  return found == step.tests.end() ? nullptr : &*found;
}

bool anyHit(const StepRecord& step) {
  return std::ranges::any_of(step.tests, [](const TestRecord& test) { return test.verdict == kTestHit; });
}

// Reads one record against the exact hit.
struct Reading {
  const TruthInput& input;
  const Ray& ray;
  const RayRecord& record;
  const Hit& exact;
  const GridParameters& grid = input.trace.grid.parameters;
  const TraceParameters& trace = input.trace.parameters;
  const vec3 point = rayPoint(ray, exact.t);
  const ivec3 home = homeCell();

  // The cell that the hit lies in: of two that share a face the one that wants the triangle, its own before its neighbours.
  ivec3 homeCell() const {
    const ivec3 own = gridCell(grid, point);
    if (exact.kind != kHitTriangle || input.demand.wants(own, exact.reference)) return own;
    for (int i = 0; i < 27; ++i) {
      const ivec3 cell = own + ivec3(i % 3, i / 3 % 3, i / 9) - ivec3(1);
      if (nearCell(grid, cell, point) && input.demand.wants(cell, exact.reference)) return cell;
    }
    return own;
  }

  bool dda() const { return trace.traversal == kTraversalDda; }
  bool endedIn(const StepRecord& step, uint32_t kind) const { return record.hit.kind == kind && &step == &record.steps.back(); }

  TruthEvent at(uint32_t cause, const StepRecord& step, uint32_t reference) const {
    return {cause, step.cell, reference, step.segment, step.start};
  }

  // Was the surface looked for in a cell that it lies in?
  bool isHomeStep(const StepRecord& step) const {
    if (step.outcome != kStepRead && step.outcome != kStepEmpty) return false;
    return step.cell == home || (nearCell(grid, step.cell, point) && input.demand.wants(step.cell, exact.reference));
  }

  // A dynamic reference in a cell that does not want it: an update should have taken it out.
  bool isLeftBehind(ivec3 cell, uint32_t reference) const {
    return reference >= firstDynamicReference(grid) && reference != kNoReference && !input.demand.wants(cell, reference);
  }

  // May a full cell have refused the surface? Sorted insertion keeps the smallest references of those that it wants.
  bool rightlyRefused(const StepRecord& step) const {
    if (step.stored < grid.capacity) return false;
    if (!gridAbilities(grid).countsRefusals) return true;
    const std::span<const uint32_t> wanted = input.demand.wanted(step.cell);
    if (grid.insertion != kInsertionSorted) return int64_t(wanted.size()) > grid.capacity;
    return std::lower_bound(wanted.begin(), wanted.end(), exact.reference) - wanted.begin() >= grid.capacity;
  }

  // Would the cell's gap have been filled, but for the gate?
  bool heldBack(const StepRecord& step) const {
    if (!step.saturated || trace.gapFill == 0u || step.travel > trace.gate || endedIn(step, kHitVoxel)) return false;
    return std::none_of(record.steps.data(), &step + 1, anyHit);
  }

  // The surface's reference is not in a cell that the surface lies in.
  TruthEvent missingIn(const StepRecord& step) const {
    const uint32_t reference = exact.reference;
    if (!input.demand.wants(step.cell, reference)) return at(kCauseLeftOut, step, reference);
    if (rightlyRefused(step)) return at(heldBack(step) ? kCauseGate : kCauseRefused, step, reference);
    const bool intruder = std::ranges::any_of(step.tests, [&](const TestRecord& test) { return isLeftBehind(step.cell, test.reference); });
    const bool missed = step.stored < grid.capacity && reference >= firstDynamicReference(grid);
    if (intruder || missed) return at(kCauseStale, step, reference);
    // With room, and without this tool's counts: another builder's overlap test may have turned it down.
    return at(gridAbilities(grid).countsRefusals ? kCauseNotInserted : kCauseLeftOut, step, reference);
  }

  // The cell was asked, and the hit lay outside the window.
  TruthEvent beyondWindow(const StepRecord& step) const {
    for (const StepRecord& skipped : record.steps) {
      const vec2 window = stepWindow(trace, skipped);
      if (skipped.outcome == kStepRevisit && skipped.cell == step.cell && exact.t >= window.x && exact.t <= window.y)
        return at(kCauseRevisit, skipped, exact.reference);
    }
    return at(kCauseSegmentEnd, step, exact.reference);
  }

  // What was lost in a home step; numeric: nothing.
  TruthEvent lostIn(const StepRecord& step) const {
    const TestRecord* test = findTest(step, exact.reference);
    if (!test) return missingIn(step);
    if (test->verdict == kTestBefore || test->verdict == kTestBeyond) return beyondWindow(step);
    if (test->verdict == kTestAlpha) return at(kCauseAlpha, step, exact.reference);
    return {};
  }

  // A triangle was hit before the exact hit, or where there is none: both apply the same test to the same triangles.
  TruthEvent hitTooNear() const {
    if (record.steps.empty()) return {.reference = record.hit.reference};
    return at(kCauseNumeric, record.steps.back(), record.hit.reference);
  }

  // The ray ended in its last step before it came to the surface.
  TruthEvent endedEarly() const {
    const StepRecord& last = record.steps.back();
    if (record.hit.kind == kHitVoxel) return at(kCauseFilledEarly, last, record.hit.reference);
    if (record.hit.kind == kHitLimit) return at(kCauseSegmentLimit, last, exact.reference);
    if (isLeftBehind(last.cell, record.hit.reference)) return at(kCauseStale, last, record.hit.reference);
    if (dda()) return at(kCauseNumeric, last, exact.reference);
    return at(kCauseAcceptedEarly, last, record.hit.reference);
  }

  // No home step: the ray ended before, the surface lies outside, or its cell was cut.
  TruthEvent neverAsked() const {
    const bool ended = record.hit.kind == kHitTriangle || record.hit.kind == kHitVoxel || record.hit.kind == kHitLimit;
    if (ended && !record.steps.empty() && record.steps.back().start <= exact.t) return endedEarly();
    if (!gridContains(grid, home)) return {.cause = kCauseOutside, .reference = exact.reference, .along = exact.t};
    TruthEvent event{.cause = dda() ? kCauseNumeric : kCauseSteppedOver, .cell = home, .reference = exact.reference};
    for (const StepRecord& step : record.steps)
      if (step.start <= exact.t) event.segment = step.segment, event.along = step.start;
    return event;
  }

  TruthEvent firstEvent() const {
    const bool surface = exact.kind == kHitTriangle;
    if (record.hit.kind == kHitTriangle && (!surface || record.hit.t < exact.t)) return hitTooNear();
    if (!surface) return record.hit.kind == kHitVoxel ? at(kCauseFilledEarly, record.steps.back(), record.hit.reference) : TruthEvent{};
    bool asked = false;
    for (const StepRecord& step : record.steps) {
      if (!isHomeStep(step)) continue;
      asked = true;
      const TruthEvent event = lostIn(step);
      if (event.cause != kCauseNumeric) return event;
    }
    if (!asked) return neverAsked();
    if (record.hit.kind == kHitLimit) return at(kCauseSegmentLimit, record.steps.back(), exact.reference);
    return {.cause = kCauseNumeric, .cell = home, .reference = exact.reference};
  }
};

// Alpha keying alone, with the trace's own loads.
struct AlphaTrace : TraceLoads {
  using TraceLoads::TraceLoads;
#include "shaders/shared/trace/alpha.h"
};

// The byte that alpha keying reads at a hit, and whether it lets the hit through; 256: not keyed.
struct AlphaRead {
  uint byte;
  bool passes;
};

AlphaRead readAlpha(const TraceInput& input, const Ray& ray, const Hit& hit) {
  AlphaTrace loads(input);
  AlphaRead read{};
  read.passes = loads.alphaPasses(hit.reference, referencedTriangle(input, hit.reference), rayPoint(ray, hit.t), read.byte);
  return read;
}

}  // namespace

const Triangle& referencedTriangle(const TraceInput& input, uint32_t reference) {
  return input.worldTriangles[input.scene.instances[referenceInstance(reference)].firstWorldTriangle + referenceTriangle(reference)];
}

vec2 cellStay(const GridParameters& grid, const Ray& ray, ivec3 cell) {
  double low = 0.0, high = kFar;
  for (int axis = 0; axis < 3; ++axis) {
    const double first = double(gridFace(grid, axis, cell[axis])) - ray.origin[axis];
    const double second = double(gridFace(grid, axis, cell[axis] + 1)) - ray.origin[axis];
    if (std::abs(ray.direction[axis]) < kTiny) continue;
    low = std::max(low, std::min(first / ray.direction[axis], second / ray.direction[axis]));
    high = std::min(high, std::max(first / ray.direction[axis], second / ray.direction[axis]));
  }
  return vec2(float(low), float(high));
}

vec2 stepWindow(const TraceParameters& trace, const StepRecord& step) {
  if (trace.traversal == kTraversalDda) return vec2(trace.tMin, kFar);
  return vec2(std::max(trace.tMin, step.start - trace.back), step.start + trace.ahead);
}

TruthEvent findEvent(const TruthInput& input, const Ray& ray, const RayRecord& record, const Hit& exact) {
  return Reading{input, ray, record, exact}.firstEvent();
}

TruthEvent findForeignEvent(const TruthInput& input, const Ray& ray, const Hit& traced, const Hit& ruled) {
  const GridParameters& grid = input.trace.grid.parameters;
  const auto atHit = [&](uint32_t cause, const Hit& hit) { return TruthEvent{cause, hitCell(grid, ray, hit), hit.reference, -1, hit.t}; };

  // A hit that this trace would not accept.
  if (traced.kind == kHitTriangle) {
    if (traced.t < input.trace.parameters.tMin) return atHit(kCauseSelfHit, traced);
    if (!readAlpha(input.trace, ray, traced).passes) return atHit(kCauseAlpha, traced);
  }

  // A surface that it did not accept: keyed, or so near that another tMin hides it.
  if (ruled.kind != kHitTriangle) return {};
  if (readAlpha(input.trace, ray, ruled).byte <= 255u) return atHit(kCauseAlpha, ruled);
  if (ruled.t < grid.cellEdge) return atHit(kCauseSelfHit, ruled);
  return {};
}

}  // namespace gridscope
