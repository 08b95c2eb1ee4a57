// What shaders/shared/trace/traverse.h asks its includer for, read from plain memory. Shared by the C++ traces: fast, counting, recording.
#pragma once

#include "core/grid/slots.h"
#include "core/trace/trace.h"
#include "shaders/shared/scene/triangle.h"
#include "shaders/shared/trace/triangle_test.h"

namespace gridscope {

class TraceLoads : public CellReader {
 public:
  explicit TraceLoads(const TraceInput& input) : CellReader(input.grid), input_(input) {}

  const Instance& loadInstance(uint instance) const { return input_.scene.instances[instance]; }
  const TraceMaterial& loadMaterial(uint material) const { return input_.scene.materials[material]; }
  vec2 loadUv(uint objectTriangle, uint corner) const { return input_.scene.corners[3 * objectTriangle + corner].uv; }
  uint loadAlpha(uint byteIndex) const { return (input_.scene.alphaBytes[byteIndex >> 2] >> (8 * (byteIndex & 3))) & 255u; }
  const Triangle& loadWorldTriangle(uint index) const { return input_.worldTriangles[index]; }

 private:
  const TraceInput& input_;
};

// One ray to its end, in as many passes as a device would take.
template <typename Trace>
Hit traceAllPasses(Trace& trace, const TraceInput& input, const Ray& ray) {
  TraceState state = trace.traceBegin();
  Hit hit;
  do hit = trace.traceRay(input.grid.parameters, input.parameters, ray, state);
  while (hit.kind == kHitUnfinished);
  return hit;
}

}  // namespace gridscope
