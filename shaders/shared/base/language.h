// What lets one file compile as GLSL and as C++: types, parameter directions and the few functions that are spelled differently.
// In C++ everything lands in namespace gridscope. Rules for code here: no dot(), length(), normalize(), mix(), fma, / on floats or
// sqrt where a result must be the same on every device (design: determinism); quotients go through divide().
#ifndef GRIDSCOPE_SHARED_LANGUAGE_H
#define GRIDSCOPE_SHARED_LANGUAGE_H

#ifdef __cplusplus

#include <bit>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#define SHARED inline
#define INOUT(type) type&
#define OUT(type) type&

namespace gridscope {

using uint = uint32_t;
using glm::abs;
using glm::clamp;
using glm::floor;
using glm::ivec2;
using glm::ivec3;
using glm::max;
using glm::min;
using glm::uvec2;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;

SHARED uint floatBitsToUint(float value) { return std::bit_cast<uint>(value); }
SHARED float uintBitsToFloat(uint bits) { return std::bit_cast<float>(bits); }

}  // namespace gridscope

#define BEGIN_SHARED namespace gridscope {
#define END_SHARED }

#else

#define SHARED
#define INOUT(type) inout type
#define OUT(type) out type
#define BEGIN_SHARED
#define END_SHARED

#endif

BEGIN_SHARED

// Below this a magnitude counts as zero: squared normals, determinants, stored coordinates. It keeps every device away from
// denormal numbers, which some flush.
const float kTiny = 1e-30f;

// Quotient of two floats, rounded once from double: native division differs between devices by up to 2 ulp, this does not.
SHARED float divide(float numerator, float denominator) { return float(double(numerator) / double(denominator)); }

// The value as it is stored: no negative zero, nothing denormal.
SHARED float stored(float value) { return abs(value) < kTiny ? 0.0f : value; }

// Sums written out: the built-in dot() is fused on some devices.
SHARED float dotExact(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
SHARED vec3 crossExact(vec3 a, vec3 b) { return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }

END_SHARED

#endif
