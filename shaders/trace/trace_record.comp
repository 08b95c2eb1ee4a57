// Records the steps of one ray: the same traversal, writing down what happens (core/gpu_record.cpp reads it).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"
#include "shaders/shared/trace/triangle_test.h"
layout(scalar, set = 0, binding = kBindRays) readonly buffer RaysBuffer { Ray rays[]; };
layout(scalar, set = 0, binding = kBindRayRecord) buffer RayRecordBuffer { RayRecordHeader header; uint recordWords[]; };
layout(scalar, push_constant) uniform ArgumentsBlock { TraceArguments arguments; };

// Appends; what does not fit is counted, and the host asks again with room for it.
void record(uint word) {
  if (header.wordCount < header.wordCapacity) recordWords[header.wordCount] = word;
  ++header.wordCount;
}

void recordSegment(int segment, float start, ivec3 cell, uint outcome) {
  record(kRecordSegment), record(uint(segment)), record(floatBitsToUint(start));
  record(uint(cell.x)), record(uint(cell.y)), record(uint(cell.z)), record(outcome);
}

void recordTest(int slot, uint reference, TriangleTest test, uint alphaByte) {
  record(kRecordTest), record(uint(slot)), record(reference), record(test.verdict), record(floatBitsToUint(test.t)), record(alphaByte);
}

void recordCell(int storedCount, bool saturated, float travel) {
  record(kRecordCell), record(uint(storedCount)), record(saturated ? 1u : 0u), record(floatBitsToUint(travel));
}

#define ON_SEGMENT(segment, start, cell, outcome) recordSegment(segment, start, cell, outcome)
#define ON_TEST(slot, reference, test, alphaByte) recordTest(slot, reference, test, alphaByte)
#define ON_CELL(storedCount, saturated, travel) recordCell(storedCount, saturated, travel)
#include "shaders/shared/trace/traverse.h"

layout(local_size_x = 1) in;

void main() {
  TraceState state = traceBegin();
  if (arguments.continues != 0u) state = header.state;
  header.hit = traceRay(gridParameters(), traceParameters(), rays[arguments.firstRay], state);
  header.state = state;
}
