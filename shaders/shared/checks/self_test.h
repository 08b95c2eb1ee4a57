// The operations that the exact stages are made of, on one triangle of numbers: what C++ and a device must agree on to the bit.
#ifndef GRIDSCOPE_SHARED_SELF_TEST_H
#define GRIDSCOPE_SHARED_SELF_TEST_H

#include "shaders/shared/trace/triangle_test.h"

BEGIN_SHARED

const int kSelfTestWords = 16;

// Results for the nine numbers of `input`, as bits.
struct SelfTestWords {
  uint words[kSelfTestWords];
};

SHARED SelfTestWords selfTest(Triangle numbers) {
  SelfTestWords result;
  vec3 a = numbers.a;
  vec3 b = numbers.b;
  vec3 c = numbers.c;
  result.words[0] = floatBitsToUint(stored(a.x + b.x));
  result.words[1] = floatBitsToUint(stored(a.y - b.y));
  result.words[2] = floatBitsToUint(stored(a.z * b.z));
  result.words[3] = floatBitsToUint(stored(a.x * b.x + c.x));  // must not be fused
  result.words[4] = floatBitsToUint(stored(divide(a.y, b.y)));
  result.words[5] = uint(int(floor(clamp(c.z, -1e6f, 1e6f))));
  result.words[6] = floatBitsToUint(stored(min(a.x, b.x)) + stored(max(a.y, b.y)));
  result.words[7] = floatBitsToUint(stored(dotExact(a, b)));
  vec3 cross = crossExact(a, c);
  result.words[8] = floatBitsToUint(stored(cross.x));
  result.words[9] = floatBitsToUint(stored(cross.y));
  result.words[10] = floatBitsToUint(float(int(clamp(a.x, -1e6f, 1e6f))) + 0.5f);

  // A ray through the middle of the triangle, from beside it.
  Ray ray;
  ray.origin = vec3(c.z, a.z, b.x);
  ray.direction = (a + b + c) * 0.25f - ray.origin;
  ray.launchNormal = vec3(0.0f, 0.0f, 0.0f);
  ray.valid = 1u;
  TriangleTest test = testTriangle(ray, numbers, -kFar, kFar);
  result.words[11] = test.verdict;
  result.words[12] = floatBitsToUint(stored(test.t));
  vec2 weights = clampedBarycentrics(numbers, rayPoint(ray, test.t));
  result.words[13] = floatBitsToUint(weights.x);
  result.words[14] = floatBitsToUint(weights.y);
  result.words[15] = alphaTexel(a.x, 37u, 1u);
  return result;
}

END_SHARED

#endif
