// Does a device compute the same bits as C++? Each operation that the exact stages use, and a small build and trace.
#pragma once

#include <string>
#include <vector>

#include "core/gpu/context.h"

namespace gridscope {

struct SelfTestResult {
  struct Item {
    std::string name;  // of the operation or stage
    uint64_t cases = 0;
    uint64_t different = 0;  // words that differ from C++
  };
  std::vector<Item> items;
  bool passed() const;
};

// About a second. Throws Error when the device fails to run at all.
SelfTestResult runSelfTest(GpuContext& gpu);

}  // namespace gridscope
