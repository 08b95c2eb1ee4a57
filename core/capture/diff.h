// Two captures by meaning: what was set, which cells hold what, how rays ended.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/capture/capture.h"
#include "core/capture/compare.h"

namespace gridscope {

// A setting that is not the same in both.
struct SettingDifference {
  std::string name;  // "grid.capacity"
  std::string a;
  std::string b;
};

struct CellDifferences {
  uint64_t total = 0;  // cells
  uint64_t onlyA = 0;  // occupied in A alone
  uint64_t onlyB = 0;
  uint64_t otherReferences = 0;  // in both, with other references or another order
  uint64_t otherRefused = 0;     // the same references, but other counts of what was refused
  std::string first;
  uint64_t different() const { return onlyA + onlyB + otherReferences + otherRefused; }
};

struct HitDifferences {
  uint64_t total = 0;  // pixels
  uint64_t otherKind = 0;
  uint64_t otherTriangle = 0;  // of the same kind
  uint64_t otherDistance = 0;  // of the same kind and triangle: t or barycentrics
  std::string first;
  uint64_t different() const { return otherKind + otherTriangle + otherDistance; }
};

struct FrameDifferences {
  size_t frame = 0;
  CellDifferences cells;
  HitDifferences hits;
  Difference rays;
  Difference counters;
  Difference exact;
};

struct CaptureDifferences {
  std::vector<SettingDifference> settings;
  std::vector<std::string> notCompared;  // a line for each product that can't be, with the reason
  std::vector<FrameDifferences> frames;  // of both
  bool equal() const;
};

CaptureDifferences diffCaptures(const Capture& a, const Capture& b);

}  // namespace gridscope
