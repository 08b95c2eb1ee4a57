// See compare.h.
#include "core/capture/compare.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "core/base/error.h"

namespace gridscope {
namespace {

// Counts the elements whose bytes differ; describe(index) puts the first into words.
template <typename T, typename Describe>
Difference compareBytes(std::span<const T> a, std::span<const T> b, const Describe& describe) {
  CHECK_EQ(a.size(), b.size());
  Difference difference{.total = a.size()};
  if (a.empty() || !std::memcmp(a.data(), b.data(), a.size_bytes())) return difference;
  for (size_t i = 0; i < a.size(); ++i) {
    if (!std::memcmp(&a[i], &b[i], sizeof(T))) continue;
    if (difference.different++ == 0) difference.firstIndex = i;
  }
  difference.first = describe(difference.firstIndex);
  return difference;
}

const char* kindName(uint32_t kind) {
  static constexpr const char* kNames[] = {"no ray",     "triangle hit", "voxel hit", "miss", "miss (limit of segments)",
                                           "unfinished", "cut short"};
  return kind < std::size(kNames) ? kNames[kind] : "unknown kind";
}

std::string named(const std::vector<std::string>& names, uint32_t index, const char* otherwise) {
  if (index < names.size() && !names[index].empty()) return names[index];
  return otherwise + std::to_string(index);
}

// "refused: captured 3 and 0, replayed 2 and 0".
std::string refusedText(const CellFacts& a, const CellFacts& b, const Comparison& how) {
  const auto counts = [](const CellFacts& cell) {
    return std::to_string(cell.staticRefused) + " and " + std::to_string(cell.dynamicRefused);
  };
  return "refused: " + how.a + " " + counts(a) + ", " + how.b + " " + counts(b);
}

// What the two cells of one place differ in; empty: nothing.
std::string setDifference(const Grid& gridA, const Grid& gridB, ivec3 cell, const Comparison& how) {
  const CellFacts a = cellFacts(gridA, cell), b = cellFacts(gridB, cell);
  if (a.staticRefused != b.staticRefused || a.dynamicRefused != b.dynamicRefused || a.refused != b.refused) return refusedText(a, b, how);
  if (a.stored != b.stored) return how.a + " holds " + std::to_string(a.stored) + " references, " + how.b + " " + std::to_string(b.stored);
  if (a.saturated) return "";
  std::vector<uint32_t> sortedA = storedIn(gridA, cell), sortedB = storedIn(gridB, cell);
  std::ranges::sort(sortedA);
  std::ranges::sort(sortedB);
  const auto [inA, inB] = std::ranges::mismatch(sortedA, sortedB);
  if (inA == sortedA.end()) return "";
  return how.a + " " + referenceText(how, *inA) + ", " + how.b + " " + referenceText(how, *inB);
}

}  // namespace

std::string Difference::text() const {
  return equal() ? "" : std::to_string(different) + " of " + std::to_string(total) + " differ; the first: " + first;
}

Difference compareTriangles(std::span<const Triangle> a, std::span<const Triangle> b) {
  return compareBytes(a, b, [](size_t i) { return "world triangle " + std::to_string(i); });
}

Difference compareGrids(const Grid& a, const Grid& b, const Comparison& how) {
  return compareBytes<uint32_t>(a.words, b.words, [&](size_t i) {
    const bool reference = wordIsReference(a.parameters, i);
    const auto value = [&](uint32_t word) { return reference ? referenceText(how, word) : std::to_string(word); };
    return wordText(a.parameters, i) + ": " + how.a + " " + value(a.words[i]) + ", " + how.b + " " + value(b.words[i]);
  });
}

Difference compareHits(std::span<const Hit> a, std::span<const Hit> b, uint32_t width, const Comparison& how) {
  return compareBytes(a, b, [&](size_t i) {
    return pixelText(i, width) + ": " + how.a + " " + hitText(how, a[i]) + "; " + how.b + " " + hitText(how, b[i]);
  });
}

Difference compareCounters(std::span<const RayCounters> a, std::span<const RayCounters> b, uint32_t width, const Comparison& how) {
  return compareBytes(a, b, [&](size_t i) {
    return pixelText(i, width) + ": " + how.a + " " + std::to_string(a[i].visits) + " visits and " + std::to_string(a[i].tests) +
           " tests, " + how.b + " " + std::to_string(b[i].visits) + " and " + std::to_string(b[i].tests);
  });
}

Difference compareExactHits(std::span<const ExactHit> a, std::span<const ExactHit> b, uint32_t width, const Comparison& how) {
  const auto text = [](const ExactHit& hit, const Comparison& named) {
    char distance[32];
    std::snprintf(distance, sizeof distance, " at t %.9g", double(hit.t));
    return hit.reference == kNoReference ? std::string("nothing") : referenceText(named, hit.reference) + distance;
  };
  return compareBytes(
      a, b, [&](size_t i) { return pixelText(i, width) + ": " + how.a + " " + text(a[i], how) + ", " + how.b + " " + text(b[i], how); });
}

Difference compareGridsAsSets(const Grid& a, const Grid& b, const Comparison& how) {
  Difference difference{.total = cellCountOf(a.parameters)};
  if (a.words == b.words) return difference;
  forCellsOfLayers(a.parameters, 0, a.parameters.cellCount.z, [&](ivec3 cell) {
    const std::string text = setDifference(a, b, cell, how);
    if (text.empty() || difference.different++ > 0) return;
    difference.firstIndex = idOfCell(a.parameters, cell);
    difference.first = cellText(cell) + ": " + text;
  });
  return difference;
}

std::string hexText(uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08X", value);
  return text;
}

std::string pixelText(size_t index, uint32_t width) {
  return "pixel (" + std::to_string(index % width) + ", " + std::to_string(index / width) + ")";
}

std::string referenceText(const Comparison& how, uint32_t reference) {
  if (reference == kNoReference) return "blank";
  const uint32_t instance = referenceInstance(reference);
  std::string text = hexText(reference);
  if (instance >= how.scene.instanceCount() || referenceTriangle(reference) >= how.scene.instances[instance].triangleCount)
    return text + " (no such triangle)";
  const TriangleName name = nameTriangle(how.scene, reference);
  static const CaptureNames kNone;
  const CaptureNames& names = how.names ? *how.names : kNone;
  const std::string mesh = named(names.meshes, name.mesh, "mesh "), of = named(names.instances, name.sceneInstance, "instance ");
  return text + " (" + mesh + (mesh == of ? "" : " of " + of) + ", triangle " + std::to_string(name.triangle) + ")";
}

std::string hitText(const Comparison& how, const Hit& hit) {
  if (hit.kind != kHitTriangle && hit.kind != kHitVoxel) return kindName(hit.kind);
  char text[128];
  std::snprintf(text, sizeof text, ", t %.9g (%s), u %.9g, v %.9g", hit.t, hexText(floatBitsToUint(hit.t)).c_str(), hit.u, hit.v);
  return std::string(kindName(hit.kind)) + " on " + referenceText(how, hit.reference) + text;
}

}  // namespace gridscope
