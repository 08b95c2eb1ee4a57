// Which cells a triangle is offered to: the cells of its bounding box, and the two overlap tests.
#ifndef GRIDSCOPE_SHARED_OVERLAP_H
#define GRIDSCOPE_SHARED_OVERLAP_H

#include "shaders/shared/grid/grid.h"
#include "shaders/shared/scene/triangle.h"

BEGIN_SHARED

// Cells of a triangle's bounding box, both ends included; empty when high < low on some axis.
struct CellRange {
  ivec3 low;
  ivec3 high;
  bool clipped;  // the box reaches beyond the grid
};

SHARED CellRange triangleCells(GridParameters grid, Triangle triangle) {
  ivec3 low = gridCell(grid, min(triangle.a, min(triangle.b, triangle.c)));
  ivec3 high = gridCell(grid, max(triangle.a, max(triangle.b, triangle.c)));
  CellRange range;
  range.clipped = !(gridContains(grid, low) && gridContains(grid, high));
  range.low = max(low, ivec3(0, 0, 0));
  range.high = min(high, grid.cellCount - ivec3(1, 1, 1));
  return range;
}

SHARED uint cellRangeCount(CellRange range) {
  ivec3 extent = range.high - range.low + ivec3(1, 1, 1);
  if (extent.x <= 0 || extent.y <= 0 || extent.z <= 0) return 0u;
  return uint(extent.x) * uint(extent.y) * uint(extent.z);
}

// The cell at a place in the range's order: x fastest, then y, then z.
SHARED ivec3 cellRangeCell(CellRange range, uint index) {
  uvec3 extent = uvec3(range.high - range.low + ivec3(1, 1, 1));
  uint row = index / extent.x;
  return range.low + ivec3(int(index % extent.x), int(row % extent.y), int(row / extent.y));
}

// Does the triangle's plane meet the enlarged sphere around a cell's cube? Squared, so that no root is needed.
SHARED bool planeMeetsCell(GridParameters grid, Triangle triangle, vec3 normal, vec3 centre) {
  float distance = dotExact(normal, centre - triangle.a);
  return distance * distance <= grid.planeRadiusSquared * dotExact(normal, normal);
}

// Are the projections of triangle (three values) and cube (-radius..radius) on an axis apart?
SHARED bool projectionsApart(float a, float b, float c, float radius) { return min(a, min(b, c)) > radius || max(a, max(b, c)) < -radius; }

// The three axes edge x (x, y, z unit vectors). a, b, c are the corners relative to the cube's centre.
SHARED bool edgeSeparates(vec3 edge, vec3 a, vec3 b, vec3 c, float halfEdge) {
  vec3 size = abs(edge);
  if (projectionsApart(edge.z * a.y - edge.y * a.z, edge.z * b.y - edge.y * b.z, edge.z * c.y - edge.y * c.z, halfEdge * (size.z + size.y)))
    return true;
  if (projectionsApart(edge.x * a.z - edge.z * a.x, edge.x * b.z - edge.z * b.x, edge.x * c.z - edge.z * c.x, halfEdge * (size.x + size.z)))
    return true;
  return projectionsApart(edge.y * a.x - edge.x * a.y, edge.y * b.x - edge.x * b.y, edge.y * c.x - edge.x * c.y,
                          halfEdge * (size.y + size.x));
}

// Does the triangle meet the enlarged cube? Separating axes: Akenine-Moeller, Fast 3D Triangle-Box Overlap Testing, 2001.
SHARED bool triangleMeetsCell(GridParameters grid, Triangle triangle, vec3 normal, vec3 centre) {
  float halfEdge = grid.boxHalfEdge;
  vec3 a = triangle.a - centre;
  vec3 b = triangle.b - centre;
  vec3 c = triangle.c - centre;
  if (projectionsApart(a.x, b.x, c.x, halfEdge) || projectionsApart(a.y, b.y, c.y, halfEdge) || projectionsApart(a.z, b.z, c.z, halfEdge))
    return false;
  vec3 size = abs(normal);
  if (abs(dotExact(normal, a)) > halfEdge * (size.x + size.y + size.z)) return false;
  return !edgeSeparates(b - a, a, b, c, halfEdge) && !edgeSeparates(c - b, a, b, c, halfEdge) && !edgeSeparates(a - c, a, b, c, halfEdge);
}

SHARED bool cellTakesTriangle(GridParameters grid, Triangle triangle, vec3 normal, ivec3 cell) {
  vec3 centre = gridCellCentre(grid, cell);
  if (grid.overlap == kOverlapExact) return triangleMeetsCell(grid, triangle, normal, centre);
  return planeMeetsCell(grid, triangle, normal, centre);
}

END_SHARED

#endif
