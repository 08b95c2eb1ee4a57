// Gather, vertex stage: world triangles through the camera, with reversed infinite depth. One draw an instance.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/shared/trace/alpha.h"

layout(location = 0) flat out uint outReference;
layout(location = 1) out vec2 outUv;

void main() {
  uint worldTriangle = uint(gl_VertexIndex) / 3u;
  uint corner = uint(gl_VertexIndex) % 3u;
  Instance instance = instances[gl_InstanceIndex];
  uint triangleNumber = worldTriangle - instance.firstWorldTriangle;
  Triangle triangle = worldTriangles[worldTriangle];

  CameraParameters camera = parameters.camera;
  vec3 offset = (corner == 0u ? triangle.a : corner == 1u ? triangle.b : triangle.c) - camera.eye;
  gl_Position = vec4(dot(offset, camera.right) / camera.tanHalfWidth, -dot(offset, camera.up) / camera.tanHalfHeight, camera.nearPlane,
                     dot(offset, camera.forward));
  outReference = makeReference(uint(gl_InstanceIndex), triangleNumber);
  outUv = loadUv(instance.firstTriangle + triangleNumber, corner);
}
