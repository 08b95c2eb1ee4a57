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

std::string listed(const std::vector<uint32_t>& words) {
  std::string text;
  for (uint32_t word : words) text += (text.empty() ? "" : " and ") + std::to_string(word);
  return text;
}

// What the two cells of one place differ in; empty: nothing.
std::string setDifference(const GridParameters& parameters, const CellSlots& a, const CellSlots& b, const Comparison& how) {
  if (a.reserved != b.reserved) return "refused: " + how.a + " " + listed(a.reserved) + ", " + how.b + " " + listed(b.reserved);
  if (a.references.size() != b.references.size())
    return how.a + " holds " + std::to_string(a.references.size()) + " references, " + how.b + " " + std::to_string(b.references.size());
  if (cellSaturated(parameters, a)) return "";
  std::vector<uint32_t> sortedA = a.references, sortedB = b.references;
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
  const int reserved = a.parameters.reserved;
  return compareBytes<uint32_t>(a.texels, b.texels, [&](size_t i) {
    const std::string place = texelText(a.parameters, i);
    const bool counts = reserved > 0 && place.ends_with("refused");
    const auto value = [&](uint32_t word) { return counts ? std::to_string(word) : referenceText(how, word); };
    return place + ": " + how.a + " " + value(a.texels[i]) + ", " + how.b + " " + value(b.texels[i]);
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
    return hit.reference == kBlank ? std::string("nothing") : referenceText(named, hit.reference) + distance;
  };
  return compareBytes(
      a, b, [&](size_t i) { return pixelText(i, width) + ": " + how.a + " " + text(a[i], how) + ", " + how.b + " " + text(b[i], how); });
}

Difference compareGridsAsSets(const Grid& a, const Grid& b, const Comparison& how) {
  const ivec3 count = a.parameters.cellCount;
  Difference difference{.total = uint64_t(count.x) * uint64_t(count.y) * uint64_t(count.z)};
  if (a.texels == b.texels) return difference;
  size_t index = 0;
  for (ivec3 cell(0); cell.z < count.z; ++cell.z)
    for (cell.y = 0; cell.y < count.y; ++cell.y)
      for (cell.x = 0; cell.x < count.x; ++cell.x, ++index) {
        const std::string text = setDifference(a.parameters, readCell(a, cell), readCell(b, cell), how);
        if (text.empty() || difference.different++ > 0) continue;
        difference.firstIndex = index;
        difference.first = cellText(cell) + ": " + text;
      }
  return difference;
}

std::string hexText(uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08X", value);
  return text;
}

std::string cellText(ivec3 cell) {
  return "cell (" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ", " + std::to_string(cell.z) + ")";
}

std::string texelText(const GridParameters& grid, size_t texel) {
  const ivec3 count = gridTexelCount(grid);
  ivec3 place(int(texel % count.x), int(texel / count.x % count.y), int(texel / (size_t(count.x) * count.y)));
  const int slot = place[grid.stretchAxis] % grid.stride;
  place[grid.stretchAxis] /= grid.stride;
  if (slot < grid.capacity) return cellText(place) + ", slot " + std::to_string(slot);
  return cellText(place) + (slot == grid.capacity ? ", static refused" : ", dynamic refused");
}

std::string pixelText(size_t index, uint32_t width) {
  return "pixel (" + std::to_string(index % width) + ", " + std::to_string(index / width) + ")";
}

std::string referenceText(const Comparison& how, uint32_t reference) {
  if (reference == kBlank) return "blank";
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
