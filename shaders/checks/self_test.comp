// The self-test's operations, one invocation for nine numbers (core/checks/self_test.cpp compares with C++).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/shared/checks/self_test.h"
layout(scalar, set = 0, binding = kBindRayRecord) writeonly buffer SelfTestBuffer { SelfTestWords results[]; };

layout(local_size_x = 64) in;

void main() {
  uint index = gl_GlobalInvocationID.x;
  results[index] = selfTest(objectTriangles[index]);
}
