// What `check` says of a frame: what must hold after each stage and whether it does, how the order of arrival matters, and the figures that
// budgets are about.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/report.h"
#include "core/pipeline/frame_truth.h"
#include "core/pipeline/stability.h"

namespace gridscope {

struct CheckedStage {
  std::string stage;  // "build", "update", "captured", "trace", "captured hits"
  uint32_t frame = 0;
  std::vector<Invariant> invariants;
};

// The figures of a frame.
struct CheckedFrame {
  GridTotals grid;
  RayTotals rays;                       // as the frame's hits, captured ones where there are, say
  std::optional<uint64_t> foreignHits;  // of captured hits: how many are not what the trace ends with
  std::optional<TruthTotals> truth;     // where a budget asks for it
};

struct CheckReport {
  std::vector<CheckedStage> stages;
  std::vector<CheckedFrame> frames;    // one or more
  std::optional<Stability> stability;  // of --stability, of the last frame
  size_t broken() const;               // invariants that do not hold
};

// A line an invariant, then the figures.
void printCheck(std::FILE* out, const Session& session, const CheckReport& report);

// With the figures of one frame; of several, all of them are in "frames" too.
nlohmann::ordered_json checkJson(const Session& session, const CheckReport& report, size_t frame);

}  // namespace gridscope
