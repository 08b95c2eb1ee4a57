// Trace: one invocation a ray. COUNTING adds visits and tests; without it the kernel counts nothing.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"
#include "shaders/shared/trace/triangle_test.h"
layout(scalar, set = 0, binding = kBindRays) readonly buffer RaysBuffer { Ray rays[]; };
layout(scalar, set = 0, binding = kBindHits) buffer HitsBuffer { Hit hits[]; };
layout(scalar, set = 0, binding = kBindTraceStates) buffer TraceStatesBuffer { TraceState traceStates[]; };
layout(scalar, set = 0, binding = kBindTraceReport) buffer TraceReportBuffer { uint raysUnfinished; uint raysCut; };
layout(scalar, push_constant) uniform ArgumentsBlock { TraceArguments arguments; };

#ifdef COUNTING
layout(scalar, set = 0, binding = kBindCounters) buffer CountersBuffer { RayCounters counters[]; };
RayCounters counted;
#define ON_SEGMENT(segment, start, cell, outcome) counted.visits += outcome >= kStepEmpty ? 1u : 0u
#define ON_TEST(slot, reference, test, alphaByte) counted.tests += 1u
#endif
#include "shaders/shared/trace/traverse.h"

layout(local_size_x = 64) in;

void main() {
  uint index = arguments.firstRay + gl_GlobalInvocationID.x;
  if (index >= arguments.endRay) return;
  TraceState state = traceBegin();
  if (arguments.continues != 0u) {
    if (hits[index].kind != kHitUnfinished) return;
    state = traceStates[index];
  }
#ifdef COUNTING
  counted = RayCounters(0u, 0u);
  if (arguments.continues != 0u) counted = counters[index];
#endif

  Hit hit = traceRay(gridParameters(), traceParameters(), rays[index], state);

  hits[index] = hit;
  if (hit.kind == kHitUnfinished) {
    traceStates[index] = state;
    atomicAdd(raysUnfinished, 1u);
  }
  if (hit.kind == kHitCut) atomicAdd(raysCut, 1u);
#ifdef COUNTING
  counters[index] = counted;
#endif
}
