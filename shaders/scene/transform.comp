// Writes the world triangles of a range of instances.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#define WRITES_WORLD_TRIANGLES
#include "shaders/gpu/bindings.glsl"
#include "shaders/scene/instances.glsl"

layout(local_size_x = 64) in;

void main() {
  uint worldTriangle = arguments.firstTriangle + gl_GlobalInvocationID.x;
  if (worldTriangle >= arguments.endTriangle) return;
  uint index = findInstance(worldTriangle);
  if (!instanceTaken(index)) return;
  Instance instance = instances[index];
  Triangle triangle = objectTriangles[instance.firstTriangle + worldTriangle - instance.firstWorldTriangle];
  worldTriangles[worldTriangle] = transformTriangle(instance, triangle);
}
