// The stage times of the last frames, and which settings changed between two of them.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "app/frame/snapshot.h"

namespace gridscope {

struct StageMoment {
  StageTimes times;
  std::string change;  // of the settings since the frame before: "capacity 24 to 48"; empty: none
};

class StageHistory {
 public:
  static constexpr size_t kMost = 200;

  // Keeps a frame with new hits; nothing when they are known already, or when its stages are running again.
  void note(const FrameSnapshot& frame);

  const std::deque<StageMoment>& moments() const { return moments_; }  // the last at the end

 private:
  std::deque<StageMoment> moments_;
  uint64_t traceNumber_ = 0;  // of the last snapshot that was kept
  std::optional<FrameSettings> settings_;
};

// What differs, in a few words: the first change that matters, "and more" when there are others; empty when nothing does.
std::string settingsChange(const FrameSettings& before, const FrameSettings& after);

}  // namespace gridscope
