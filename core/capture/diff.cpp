// See diff.h.
#include "core/capture/diff.h"

#include <algorithm>
#include <cstring>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/capture/manifest.h"

namespace gridscope {
namespace {

// Every value of the two manifests that differs, by its place.
void diffJson(const std::string& place, const nlohmann::json& a, const nlohmann::json& b, std::vector<SettingDifference>& differences) {
  if (a == b) return;
  const auto under = [&](const std::string& key) { return place.empty() ? key : place + "." + key; };
  const bool bits = a.is_object() && a.contains("bits");
  if (a.is_object() && b.is_object() && !bits) {
    nlohmann::json keys = a;
    keys.update(b);
    for (const auto& [key, value] : keys.items())
      diffJson(under(key), a.value(key, nlohmann::json()), b.value(key, nlohmann::json()), differences);
    return;
  }
  const auto text = [](const nlohmann::json& value) {
    return value.is_object() && value.contains("value") ? value["value"].dump() : value.dump();
  };
  differences.push_back({place, text(a), text(b)});
}

// What decides the products. Frames and who wrote the file do not.
nlohmann::json settingsOf(const Capture& capture) {
  nlohmann::json manifest = makeManifest(capture), settings;
  for (const char* key : {"settings", "grid", "trace"}) settings[key] = manifest[key];
  settings["scene"] = {
      {"name", capture.names.scene}, {"instances", capture.scene.instanceCount()}, {"triangles", capture.scene.triangleCount}};
  settings["frames"] = capture.frames.size();
  return settings;
}

void diffCell(const Grid& gridA, const Grid& gridB, ivec3 cell, const Comparison& howA, const Comparison& howB, CellDifferences& result) {
  const CellFacts factsA = cellFacts(gridA, cell), factsB = cellFacts(gridB, cell);
  const std::vector<uint32_t> a = storedIn(gridA, cell), b = storedIn(gridB, cell);
  if (a == b && factsA == factsB) return;
  std::string text;
  if (a == b) {
    ++result.otherRefused;
    text = "other counts of refused references";
  } else {
    ++(b.empty() ? result.onlyA : a.empty() ? result.onlyB : result.otherReferences);
    const auto [inA, inB] = std::ranges::mismatch(a, b);
    const auto text1 = [](const Comparison& how, auto at, auto end) { return at == end ? std::string("blank") : referenceText(how, *at); };
    text = "slot " + std::to_string(inA - a.begin()) + ": A " + text1(howA, inA, a.end()) + ", B " + text1(howB, inB, b.end());
  }
  if (result.first.empty()) result.first = cellText(cell) + ", " + text;
}

CellDifferences diffCells(const Grid& a, const Grid& b, const Comparison& howA, const Comparison& howB) {
  CellDifferences result{.total = cellCountOf(a.parameters)};
  if (a.words == b.words && storedAlike(a.parameters, b.parameters)) return result;
  forCellsOfLayers(a.parameters, 0, a.parameters.cellCount.z, [&](ivec3 cell) { diffCell(a, b, cell, howA, howB, result); });
  return result;
}

HitDifferences diffHits(std::span<const Hit> a, std::span<const Hit> b, uint32_t width, const Comparison& howA, const Comparison& howB) {
  HitDifferences result{.total = a.size()};
  for (size_t i = 0; i < a.size(); ++i) {
    if (!std::memcmp(&a[i], &b[i], sizeof(Hit))) continue;
    ++(a[i].kind != b[i].kind ? result.otherKind : a[i].reference != b[i].reference ? result.otherTriangle : result.otherDistance);
    if (result.first.empty()) result.first = pixelText(i, width) + ": A " + hitText(howA, a[i]) + "; B " + hitText(howB, b[i]);
  }
  return result;
}

Difference diffRays(std::span<const Ray> a, std::span<const Ray> b, uint32_t width) {
  Difference result{.total = a.size()};
  for (size_t i = 0; i < a.size(); ++i) {
    if (!std::memcmp(&a[i], &b[i], sizeof(Ray)) || result.different++ > 0) continue;
    result.firstIndex = i, result.first = pixelText(i, width);
  }
  return result;
}

// Why a product of both can't be compared; empty: it can.
std::string obstacle(const char* name, size_t sizeA, size_t sizeB, bool sameShape) {
  if (sizeA == 0 && sizeB == 0) return std::string(name) + ": in neither";
  if (sizeA == 0 || sizeB == 0) return std::string(name) + (sizeA == 0 ? ": in B alone" : ": in A alone");
  return sameShape ? "" : std::string(name) + ": of different shape";
}

}  // namespace

bool CaptureDifferences::equal() const {
  const bool products = std::ranges::all_of(frames, [](const FrameDifferences& frame) {
    return frame.cells.different() == 0 && frame.hits.different() == 0 && frame.rays.equal() && frame.counters.equal() &&
           frame.exact.equal();
  });
  return settings.empty() && products &&
         std::ranges::all_of(notCompared, [](const std::string& line) { return line.ends_with("in neither"); });
}

CaptureDifferences diffCaptures(const Capture& a, const Capture& b) {
  CaptureDifferences result;
  diffJson("", settingsOf(a), settingsOf(b), result.settings);
  const Comparison howA{"A", "B", a.scene, &a.names}, howB{"A", "B", b.scene, &b.names};
  const uint32_t width = a.settings.width;
  const bool sameSize = width == b.settings.width && a.settings.height == b.settings.height;
  const bool sameCells = a.grid.cellCount == b.grid.cellCount;
  for (size_t i = 0; i < std::min(a.frames.size(), b.frames.size()); ++i) {
    const CaptureFrame &frameA = a.frames[i], &frameB = b.frames[i];
    FrameDifferences frame{.frame = i, .cells = {}, .hits = {}, .rays = {}, .counters = {}, .exact = {}};
    const auto compared = [&](const char* name, size_t sizeA, size_t sizeB, bool sameShape) {
      const std::string line = obstacle(name, sizeA, sizeB, sameShape);
      if (i == 0 && !line.empty()) result.notCompared.push_back(line);
      return line.empty();
    };
    if (compared("grid", frameA.grid.size(), frameB.grid.size(), sameCells))
      frame.cells = diffCells(frameGrid(a, i), frameGrid(b, i), howA, howB);
    if (compared("rays", frameA.rays.size(), frameB.rays.size(), sameSize)) frame.rays = diffRays(frameA.rays, frameB.rays, width);
    if (compared("hits", frameA.hits.size(), frameB.hits.size(), sameSize))
      frame.hits = diffHits(frameA.hits, frameB.hits, width, howA, howB);
    if (compared("counters", frameA.counters.size(), frameB.counters.size(), sameSize))
      frame.counters = compareCounters(frameA.counters, frameB.counters, width, howA);
    if (compared("exact", frameA.exact.size(), frameB.exact.size(), sameSize))
      frame.exact = compareExactHits(frameA.exact, frameB.exact, width, howA);
    result.frames.push_back(std::move(frame));
  }
  return result;
}

}  // namespace gridscope
