// See step_facts.h.
#include "app/frame/step_facts.h"

#include <algorithm>

#include "app/base/text.h"
#include "app/frame/find_next.h"
#include "core/trace/loads.h"
#include "core/truth/cause.h"

namespace gridscope {

namespace {

// The trace's own functions over a frame's products, so that what is worked out again here has the trace's bits.
struct FrameTrace : TraceLoads {
  using TraceLoads::TraceLoads;
#include "shaders/shared/trace/traverse.h"
};

TraceInput traceInput(const FrameSnapshot& frame) {
  return {*frame.grid, frame.scene->numbered, *frame.worldTriangles, frame.parameters.trace};
}

// Where the ray passes through a triangle's plane.
float planeT(const Ray& ray, const Triangle& triangle) {
  const vec3 normal = triangleNormal(triangle);
  const float slope = dotExact(normal, ray.direction);
  return std::abs(slope) < kTiny ? 0.0f : divide(dotExact(normal, triangle.a - ray.origin), slope);
}

// Completes a test: t also where it passes beside, and the barycentrics there.
vec2 completeTest(const Ray& ray, const Triangle& triangle, TestRecord& test) {
  if (test.verdict == kTestParallel) return vec2(0.0f);
  if (test.verdict == kTestOutside) test.t = planeT(ray, triangle);
  return barycentrics(triangle, rayPoint(ray, test.t));
}

bool testedIn(const StepRecord& step, uint32_t reference) {
  return std::any_of(step.tests.begin(), step.tests.end(), [&](const TestRecord& test) { return test.reference == reference; });
}

// The best hit when a step was done. For segments, only a hit of this very step: a hit ends the ray.
std::optional<BestHit> bestAfter(const RayRecord& record, uint32_t step) {
  std::optional<BestHit> best;
  for (uint32_t i = 0; i <= step; ++i)
    for (const TestRecord& test : record.steps[i].tests)
      if (test.verdict == kTestHit) best = BestHit{test.t, test.reference, i};
  return best;
}

// Where a step ends along the ray: a segment is one cell edge long, a walk leaves its cell.
float stepEnd(FrameTrace& trace, const FrameSnapshot& frame, const Ray& ray, const StepRecord& step) {
  const GridParameters& grid = frame.grid->parameters;
  if (frame.parameters.trace.traversal != kTraversalDda) return step.start + grid.cellEdge;
  if (step.outcome == kStepOutside) return step.start;
  const vec3 inverse(trace.inverseOrZero(ray.direction.x), trace.inverseOrZero(ray.direction.y), trace.inverseOrZero(ray.direction.z));
  int axis;
  return trace.leaveCell(grid, ray, step.cell, inverse, axis);
}

void addTests(StepFacts& facts, FrameTrace& trace, const FrameSnapshot& frame, const RecordedRay& ray) {
  const StepRecord& step = ray.record.steps[facts.index];
  for (TestRecord test : step.tests) {
    TestFacts add;
    add.weights = completeTest(ray.ray, trace.loadReferenced(test.reference), test);
    add.test = test;
    add.name = nameTriangle(frame.scene->numbered, test.reference);
    add.isNew = facts.index > 0 && !testedIn(ray.record.steps[facts.index - 1], test.reference);
    add.best = facts.best && facts.best->reference == test.reference && facts.best->step == facts.index && test.verdict == kTestHit;
    facts.tests.push_back(add);
  }
}

// Would a refused reference have been hit in the step's window?
RefusedFacts testRefused(FrameTrace& trace, const StepFacts& facts, const Ray& ray, uint32_t reference) {
  const Triangle triangle = trace.loadReferenced(reference);
  const TriangleTest result = testTriangle(ray, triangle, facts.window.x, facts.window.y);
  RefusedFacts refused;
  refused.test = {.slot = static_cast<uint32_t>(facts.refusedTests.size()),
                  .reference = reference,
                  .verdict = result.verdict,
                  .t = result.t,
                  .alphaByte = 256};
  const bool nearer = !facts.best || result.t < facts.best->t;
  if (result.verdict == kTestHit && !nearer) refused.test.verdict = kTestFarther;
  if (refused.test.verdict == kTestHit && !trace.alphaPasses(reference, triangle, rayPoint(ray, result.t), refused.test.alphaByte))
    refused.test.verdict = kTestAlpha;
  refused.wouldHit = refused.test.verdict == kTestHit;
  refused.weights = completeTest(ray, triangle, refused.test);
  return refused;
}

void addRefused(StepFacts& facts, FrameTrace& trace, const FrameSnapshot& frame, const RecordedRay& ray) {
  facts.refusedKnown = frame.demand != nullptr;
  if (!frame.demand || !facts.inGrid || facts.refused == 0) return;
  for (const uint32_t reference : refusedBy(*frame.grid, *frame.demand, facts.cell)) {
    facts.refusedTests.push_back(testRefused(trace, facts, ray.ray, reference));
    facts.refusedTests.back().name = nameTriangle(frame.scene->numbered, reference);
  }
  // Who would have been hit comes first.
  std::stable_partition(facts.refusedTests.begin(), facts.refusedTests.end(), [](const RefusedFacts& refused) { return refused.wouldHit; });
}

StepChanges changesOf(const FrameSnapshot& frame, const RecordedRay& ray, const StepFacts& facts) {
  StepChanges changes;
  if (facts.index == 0) return changes;
  const StepRecord& before = ray.record.steps[facts.index - 1];
  CellFacts full;
  const bool wasInGrid = gridContains(frame.grid->parameters, before.cell);
  if (wasInGrid) full = cellFacts(*frame.grid, before.cell);
  changes.cell = before.cell != facts.cell;
  changes.stored = full.stored != facts.stored;
  changes.refused = full.refused != facts.refused;
  const bool wasOpen = frame.parameters.trace.gapFill != 0 && stepTravel(frame, ray, facts.index - 1) > facts.gate;
  changes.gate = wasOpen != facts.gateOpen;
  const std::optional<BestHit> best = bestAfter(ray.record, facts.index - 1);
  changes.best = best.has_value() != facts.best.has_value() || (best && best->reference != facts.best->reference);
  return changes;
}

}  // namespace

float stepTravel(const FrameSnapshot& frame, const RecordedRay& ray, uint32_t step) {
  return ray.record.steps[step].start * dotExact(ray.ray.direction, ray.ray.launchNormal) / frame.parameters.grid.cellEdge;
}

StepFacts stepFacts(const FrameSnapshot& frame, const RecordedRay& ray, uint32_t step) {
  const StepRecord& at = ray.record.steps[step];
  const GridParameters& grid = frame.grid->parameters;
  const TraceInput input = traceInput(frame);
  FrameTrace trace(input);

  // Where it lies.
  StepFacts facts;
  facts.index = step;
  facts.kind = stepOutcome(ray.record, step);
  facts.startT = at.start;
  facts.cell = at.cell;
  facts.inGrid = gridContains(grid, at.cell);
  facts.endT = stepEnd(trace, frame, ray.ray, at);
  facts.start = rayPoint(ray.ray, facts.startT);
  facts.end = rayPoint(ray.ray, facts.endT);
  facts.window = stepWindow(frame.parameters.trace, at);

  // Its cell and the gate.
  if (facts.inGrid) {
    const CellFacts full = cellFacts(*frame.grid, at.cell);
    facts.stored = full.stored;
    facts.refused = full.refused;
    facts.saturated = full.saturated;
  }
  facts.travel = stepTravel(frame, ray, step);
  facts.gate = frame.parameters.trace.gate / grid.cellEdge;
  facts.gateOpen =
      frame.parameters.trace.gapFill != 0 && at.start * dotExact(ray.ray.direction, ray.ray.launchNormal) > frame.parameters.trace.gate;
  facts.best = bestAfter(ray.record, step);

  addTests(facts, trace, frame, ray);
  addRefused(facts, trace, frame, ray);
  facts.changes = changesOf(frame, ray, facts);
  facts.read = whyRead(ray, facts);
  facts.went = whyWent(frame, ray, facts);
  return facts;
}

}  // namespace gridscope
