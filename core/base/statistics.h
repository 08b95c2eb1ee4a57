// What is said of many numbers in a few.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace gridscope {

// Of a whole number counted for each of many things.
struct Summary {
  double mean = 0.0;
  uint32_t p99 = 0;  // 99 in 100 have at most this many
  uint32_t max = 0;
};

// All zero for no values.
Summary summarise(std::span<const uint32_t> values);

// Of times, in the unit they come in.
struct Spread {
  double min = 0.0;
  double median = 0.0;
  double max = 0.0;
};

// All zero for no values.
Spread spreadOf(std::vector<double> values);

}  // namespace gridscope
