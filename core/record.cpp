// The trace of one ray, step by step: the same traversal, with hooks that write down what happens.
#include "core/trace.h"
#include "core/trace_loads.h"

namespace gridscope {

namespace {

struct RecordingTrace : TraceLoads {
  using TraceLoads::TraceLoads;
  RayRecord record;
#include "core/record_hooks.h"
#include "shaders/shared/traverse.h"
};

}  // namespace

RayRecord recordRay(const TraceInput& input, const Ray& ray) {
  RecordingTrace trace(input);
  trace.record.hit = traceAllPasses(trace, input, ray);
  return std::move(trace.record);
}

}  // namespace gridscope
