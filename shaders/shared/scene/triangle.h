// Triangle arithmetic with the same bits on every device: transform, normal, barycentrics, texture coordinates.
#ifndef GRIDSCOPE_SHARED_TRIANGLE_H
#define GRIDSCOPE_SHARED_TRIANGLE_H

#include "shaders/shared/scene/scene.h"

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
