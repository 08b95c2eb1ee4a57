// Raster builder, geometry stage: writes the world triangle and offers it to the cells of its box. Nothing is rasterized.
// Source: Abdollah-shamshir-saz, Hybrid Ray/Voxel-Tracing Fixed Capacity Grids, 2020, section 2.1.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#define OPERATION 0
#define WRITES_WORLD_TRIANGLES
#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"
#include "shaders/grid/insertion.glsl"
#include "shaders/grid/big_triangles.glsl"

layout(triangles) in;
layout(points, max_vertices = 1) out;

layout(location = 0) in vec3 inWorld[];
layout(location = 1) flat in uint inInstance[];
layout(location = 2) flat in uint inTriangle[];

void main() {
  Triangle triangle = Triangle(inWorld[0], inWorld[1], inWorld[2]);
  uint worldTriangle = instances[inInstance[0]].firstWorldTriangle + inTriangle[0];
  worldTriangles[worldTriangle] = triangle;
  BuildReport report = emptyReport();
  insertOrAppend(triangle, makeReference(inInstance[0], inTriangle[0]), worldTriangle, report);
  addReport(report);
}
