// Offers the big triangles of one class to their cells: many invocations a triangle, each a run of its cells.
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
  uint entry = gl_WorkGroupID.z * gl_NumWorkGroups.y + gl_WorkGroupID.y;
  if (entry < bigDispatch.counts[arguments.bigClass]) {
    uint worldTriangle = bigTriangles[arguments.bigClass * gridParameters().triangleCount + entry];
    uint instance = findInstance(worldTriangle);
    uint reference = makeReference(instance, worldTriangle - instances[instance].firstWorldTriangle);
    Triangle triangle = worldTriangles[worldTriangle];
    CellRange range = triangleCells(gridParameters(), triangle);

    // This invocation's run of the cells.
    uint cellCount = cellRangeCount(range);
    uint invocations = bigClassInvocations(int(arguments.bigClass));
    uint share = (cellCount + invocations - 1u) / invocations;
    uint begin = min(gl_GlobalInvocationID.x * share, cellCount);
    walkCells(triangle, reference, range, uvec2(begin, min(begin + share, cellCount)), report);
  }
  addGroupReport(report);
}
