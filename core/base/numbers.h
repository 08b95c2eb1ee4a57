// Numbers that a person gives, checked.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace gridscope {

inline bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Throws Error, which names the option and the range, for a number outside [low, high] or NaN.
void checkNumber(const char* option, float value, float low, float high);

}  // namespace gridscope
