// Sizes the dispatches over the lists of big triangles: class c gets 8^c workgroups a triangle, along x; triangles along y, then z.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"
layout(scalar, set = 0, binding = kBindBigDispatch) buffer BigDispatchBuffer { BigDispatch bigDispatch; };

layout(local_size_x = 1) in;

const uint kMostGroups = 65535u;  // what every device allows along an axis

void main() {
  for (int bigClass = 0; bigClass < kBigClassCount; ++bigClass) {
    uint count = bigDispatch.counts[bigClass];
    bigDispatch.groups[bigClass] = uvec3(1u << (3 * bigClass), min(count, kMostGroups), (count + kMostGroups - 1u) / kMostGroups);
  }
}
