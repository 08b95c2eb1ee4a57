// Does a ray pass through a triangle? The same bits on every device.
#ifndef GRIDSCOPE_SHARED_TRIANGLE_TEST_H
#define GRIDSCOPE_SHARED_TRIANGLE_TEST_H

#include "shaders/shared/scene/triangle.h"
#include "shaders/shared/trace/ray.h"

BEGIN_SHARED

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

END_SHARED

#endif
