// Raster builder, vertex stage: the common transform, with instance and triangle passed on flat. One draw an instance.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"

layout(location = 0) out vec3 outWorld;
layout(location = 1) flat out uint outInstance;
layout(location = 2) flat out uint outTriangle;

void main() {
  uint objectTriangle = uint(gl_VertexIndex) / 3u;
  uint corner = uint(gl_VertexIndex) % 3u;
  Instance instance = instances[gl_InstanceIndex];
  Triangle triangle = objectTriangles[objectTriangle];
  outWorld = transformPoint(instance, corner == 0u ? triangle.a : corner == 1u ? triangle.b : triangle.c);
  outInstance = uint(gl_InstanceIndex);
  outTriangle = objectTriangle - instance.firstTriangle;
}
