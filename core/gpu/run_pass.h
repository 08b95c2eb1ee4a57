// One compute pass over two buffers of its own: for questions to a device.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/gpu/context.h"

namespace gridscope {

struct PassRun {
  std::string stem;
  uint32_t invocations = 0;  // a whole number of workgroups
  int inputBinding = 0;
  std::span<const std::byte> input;
  int outputBinding = 0;
  size_t outputBytes = 0;
};

// What the pass wrote.
std::vector<std::byte> runPass(GpuContext& gpu, const PassRun& run);

}  // namespace gridscope
