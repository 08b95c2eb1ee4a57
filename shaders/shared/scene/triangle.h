// Triangle arithmetic with the same bits on every device: transform, cell range, the two overlap tests, the ray test, barycentrics.
#ifndef GRIDSCOPE_SHARED_TRIANGLE_H
#define GRIDSCOPE_SHARED_TRIANGLE_H

#include "shaders/shared/grid/grid.h"

BEGIN_SHARED

SHARED vec3 transformPoint(Instance instance, vec3 p) {
  return vec3(stored(instance.row0.x * p.x + instance.row0.y * p.y + instance.row0.z * p.z + instance.row0.w),
              stored(instance.row1.x * p.x + instance.row1.y * p.y + instance.row1.z * p.z + instance.row1.w),
              stored(instance.row2.x * p.x + instance.row2.y * p.y + instance.row2.z * p.z + instance.row2.w));
}

SHARED Triangle transformTriangle(Instance instance, Triangle triangle) {
  Triangle world;
  world.a = transformPoint(instance, triangle.a);
  world.b = transformPoint(instance, triangle.b);
  world.c = transformPoint(instance, triangle.c);
  return world;
}

// Not normalised: its length is twice the area.
SHARED vec3 triangleNormal(Triangle triangle) { return crossExact(triangle.b - triangle.a, triangle.c - triangle.a); }

SHARED bool triangleDegenerate(vec3 normal) { return !(dotExact(normal, normal) >= kTiny); }

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

// What the ray test says of one triangle; the names are what a person reads in the ray's steps.
const uint kTestHit = 0u;       // inside the triangle and inside the window
const uint kTestParallel = 1u;  // the ray runs along the triangle's plane
const uint kTestOutside = 2u;   // passes beside the triangle
const uint kTestBefore = 3u;    // hits it before the window
const uint kTestBeyond = 4u;    // hits it beyond the window
const uint kTestAlpha = 5u;     // turned down by the alpha map
const uint kTestFarther = 6u;   // hits, but another hit of the cell is nearer

struct TriangleTest {
  uint verdict;
  float t;  // only where the ray passes through the triangle: verdicts Hit, Before, Beyond
};

// Does the ray pass through the triangle at t within [low, high]? No culling. The sign tests run on undivided numerators; one
// quotient, in double, only when the ray passes through. Source: Moeller and Trumbore, Fast, Minimum Storage Ray/Triangle
// Intersection, 1997.
SHARED TriangleTest testTriangle(Ray ray, Triangle triangle, float low, float high) {
  TriangleTest test;
  test.verdict = kTestParallel;
  test.t = 0.0f;
  vec3 edgeB = triangle.b - triangle.a;
  vec3 edgeC = triangle.c - triangle.a;
  vec3 p = crossExact(ray.direction, edgeC);
  float determinant = dotExact(edgeB, p);
  if (!(abs(determinant) >= kTiny)) return test;

  // Barycentric numerators, with the determinant's sign taken out.
  float sign = determinant < 0.0f ? -1.0f : 1.0f;
  vec3 s = ray.origin - triangle.a;
  float u = sign * dotExact(s, p);
  vec3 q = crossExact(s, edgeB);
  float v = sign * dotExact(ray.direction, q);
  test.verdict = kTestOutside;
  if (u < 0.0f || v < 0.0f || u + v > abs(determinant)) return test;

  test.t = divide(dotExact(edgeC, q), determinant);
  test.verdict = test.t < low ? kTestBefore : test.t > high ? kTestBeyond : kTestHit;
  return test;
}

// Barycentric coordinates of corners b and c for a point in the triangle's plane, by Cramer's rule; 0, 0 for a triangle without area.
// Source: Ericson, Real-Time Collision Detection, 2004, section 3.4.
SHARED vec2 barycentrics(Triangle triangle, vec3 point) {
  vec3 edgeB = triangle.b - triangle.a;
  vec3 edgeC = triangle.c - triangle.a;
  vec3 offset = point - triangle.a;
  float bb = dotExact(edgeB, edgeB);
  float bc = dotExact(edgeB, edgeC);
  float cc = dotExact(edgeC, edgeC);
  float ob = dotExact(offset, edgeB);
  float oc = dotExact(offset, edgeC);
  float denominator = bb * cc - bc * bc;
  if (!(abs(denominator) >= kTiny)) return vec2(0.0f, 0.0f);
  return vec2(stored(divide(cc * ob - bc * oc, denominator)), stored(divide(bb * oc - bc * ob, denominator)));
}

// The same, moved into the triangle: for voxel hits, whose point may lie anywhere in the cell.
SHARED vec2 clampedBarycentrics(Triangle triangle, vec3 point) {
  vec2 weights = clamp(barycentrics(triangle, point), vec2(0.0f, 0.0f), vec2(1.0f, 1.0f));
  float sum = weights.x + weights.y;
  if (sum <= 1.0f) return weights;
  return vec2(divide(weights.x, sum), divide(weights.y, sum));
}

SHARED vec3 rayPoint(Ray ray, float t) {
  return vec3(ray.origin.x + ray.direction.x * t, ray.origin.y + ray.direction.y * t, ray.origin.z + ray.direction.z * t);
}

// Texel coordinate of a texture coordinate, in integers after the fraction is taken. `wrap`: 0 repeat, 1 mirror, 2 clamp.
SHARED uint alphaTexel(float coordinate, uint size, uint wrap) {
  if (wrap == 2u) return min(uint(clamp(coordinate, 0.0f, 1.0f) * float(size)), size - 1u);
  float whole = floor(coordinate);
  uint texel = min(uint((coordinate - whole) * float(size)), size - 1u);
  bool mirrored = wrap == 1u && (int(clamp(whole, -1e9f, 1e9f)) & 1) != 0;
  return mirrored ? size - 1u - texel : texel;
}

// Interpolated texture coordinate at barycentrics of corners b and c.
SHARED vec2 interpolateUv(vec2 a, vec2 b, vec2 c, vec2 weights) {
  float rest = 1.0f - weights.x - weights.y;
  return vec2(a.x * rest + b.x * weights.x + c.x * weights.y, a.y * rest + b.y * weights.x + c.y * weights.y);
}

END_SHARED

#endif
