// The trace of one ray, step by step: the same traversal, with hooks that write down what happens.
#include "core/trace/loads.h"
#include "core/trace/trace.h"

namespace gridscope {

namespace {

struct RecordingTrace : TraceLoads {
  using TraceLoads::TraceLoads;
  RayRecord record;
#include "core/trace/record_hooks.h"
#include "shaders/shared/trace/traverse.h"
};

}  // namespace

RayRecord recordRay(const TraceInput& input, const Ray& ray) {
  RecordingTrace trace(input);
  trace.record.hit = traceAllPasses(trace, input, ray);
  return std::move(trace.record);
}

}  // namespace gridscope
