// What `check` says of a frame: what must hold after each stage and whether it does, how the order of arrival matters, and the figures that
// budgets are about.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report.h"
#include "core/frame_truth.h"
#include "core/stability.h"

namespace gridscope {

struct CheckedStage {
  std::string stage;                   // "build", "update", "captured", "trace"
  uint32_t frame = 0;
  std::vector<Invariant> invariants;
};

struct CheckReport {
  std::vector<CheckedStage> stages;
  GridTotals grid;                     // of the last frame, likewise the next
  RayTotals rays;
  std::optional<Stability> stability;  // of --stability
  std::optional<TruthTotals> truth;    // where a budget asks for it
  size_t broken() const;               // invariants that do not hold
};

// A line an invariant, then the figures.
void printCheck(std::FILE* out, const Session& session, const CheckReport& report);

nlohmann::ordered_json checkJson(const Session& session, const CheckReport& report);

}  // namespace gridscope
