// The lines of the log that tell what happened, driven by changes of the model and of the frame.
#pragma once

#include "app/model/window_model.h"

namespace gridscope {

// What was told last.
struct LoggedState {
  std::string scene;  // path; empty: none yet
  uint32_t loads = 0;
  uint64_t traceNumber = 0;
  const void* truths = nullptr;
  std::optional<uint32_t> recordedPixel;
  uint64_t recordedTrace = 0;
  const void* proofs = nullptr;
  GridTotals totals;
  std::optional<uint32_t> stepPixel;
  uint32_t step = ~0u;
  bool held = false;
  std::string views;
  std::optional<ivec3> cell;
  std::string shaderFault;
  uint32_t shaderReloads = 0;
};

void logChanges(WindowModel& model, LoggedState& logged);

}  // namespace gridscope
