// Offers each small triangle of a range of instances to the cells of its box, one invocation each; big ones go to the lists.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"
#include "shaders/scene/instances.glsl"
#include "shaders/grid/insertion.glsl"
#include "shaders/grid/group_report.glsl"
#include "shaders/grid/big_triangles.glsl"

layout(local_size_x = 64) in;

void main() {
  BuildReport report = emptyReport();
  uint worldTriangle = arguments.firstTriangle + gl_GlobalInvocationID.x;
  if (worldTriangle < arguments.endTriangle) {
    uint instance = findInstance(worldTriangle);
    uint reference = makeReference(instance, worldTriangle - instances[instance].firstWorldTriangle);
    if (instanceTaken(instance)) insertOrAppend(worldTriangles[worldTriangle], reference, worldTriangle, report);
  }
  addGroupReport(report);
}
