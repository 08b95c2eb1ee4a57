// Compares two results of a product bit for bit, and says of the first difference what a person needs: cell, slot and both references with
// their meshes, or the pixel with both hits.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/capture/capture.h"
#include "core/grid/grid.h"
#include "core/scene/numbering.h"

namespace gridscope {

// What the two sides are called, and what references are called: `names` may be null, then numbers alone stand there.
struct Comparison {
  std::string a;  // "captured"
  std::string b;  // "replayed"
  const NumberedScene& scene;
  const CaptureNames* names = nullptr;
};

struct Difference {
  uint64_t different = 0;  // elements
  uint64_t total = 0;
  size_t firstIndex = 0;  // of the first different element
  std::string first;      // it, in words; empty: all equal
  bool equal() const { return different == 0; }
  // "3 of 100 differ; the first: ..."; empty: all equal.
  std::string text() const;
};

// Elements: words of the grid, pixels. Both sides hold as many.
Difference compareTriangles(std::span<const Triangle> a, std::span<const Triangle> b);
Difference compareGrids(const Grid& a, const Grid& b, const Comparison& how);
Difference compareHits(std::span<const Hit> a, std::span<const Hit> b, uint32_t width, const Comparison& how);
Difference compareCounters(std::span<const RayCounters> a, std::span<const RayCounters> b, uint32_t width, const Comparison& how);

// Exact hits: distance and reference.
Difference compareExactHits(std::span<const ExactHit> a, std::span<const ExactHit> b, uint32_t width, const Comparison& how);

// Elements: cells. For grids whose slots a race decided: the references of a cell in any order where neither side is saturated, and in a
// saturated cell how many are stored and refused.
Difference compareGridsAsSets(const Grid& a, const Grid& b, const Comparison& how);

// In words.
std::string hexText(uint32_t value);                                   // "0x0001002A"
std::string pixelText(size_t index, uint32_t width);                   // "pixel (3, 4)"
std::string referenceText(const Comparison& how, uint32_t reference);  // "0x0001002A (tuft, triangle 42)", "blank"
std::string hitText(const Comparison& how, const Hit& hit);

}  // namespace gridscope
