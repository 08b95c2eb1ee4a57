// The trace of one ray, step by step: the same traversal, with hooks that write down what happens.
#include "core/trace.h"
#include "core/trace_loads.h"

namespace gridscope {

namespace {

#define ON_SEGMENT(segment, start, cell, outcome) record.steps.push_back({segment, start, cell, outcome, {}})
#define ON_TEST(slot, reference, test, alphaByte) \
  record.steps.back().tests.push_back({uint(slot), reference, test.verdict, test.t, alphaByte})
#define ON_CELL(storedCount, isSaturated, travelled) \
  record.steps.back().stored = storedCount, record.steps.back().saturated = isSaturated, record.steps.back().travel = travelled
struct RecordingTrace : TraceLoads {
  using TraceLoads::TraceLoads;
  RayRecord record;
#include "shaders/shared/traverse.h"
};

}  // namespace

RayRecord recordRay(const TraceInput& input, const Ray& ray) {
  RecordingTrace trace(input);
  trace.record.hit = traceAllPasses(trace, input, ray);
  return std::move(trace.record);
}

}  // namespace gridscope
