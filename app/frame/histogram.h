// How often each number occurs: what the plots of cells and rays show.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "app/frame/snapshot.h"

namespace gridscope {

// Bar k counts the values from k * width to (k + 1) * width - 1; the last one also everything above.
struct Histogram {
  uint32_t width = 1;
  std::vector<uint64_t> counts;
  uint32_t largest = 0;  // value that occurs
  uint64_t total = 0;
  bool lastIsOpen = false;  // the last bar holds more than its width

  uint64_t most() const;  // the highest bar
};

// As many bars as reach `reach`, or the largest value if that comes earlier, but at most `bars`.
Histogram countValues(std::span<const uint32_t> values, uint32_t reach, uint32_t bars);

enum class Counted { stored, tried, visits, tests };

// The values of a snapshot: of every cell with a reference (stored, tried), or of every ray (visits, tests). Empty: the snapshot has none.
std::vector<uint32_t> countedValues(Counted what, const FrameSnapshot& frame);

// The value that 99 in 100 do not exceed, at least 1.
uint32_t reachOf(std::vector<uint32_t> values);

}  // namespace gridscope
