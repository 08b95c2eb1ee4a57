// See statistics.h.
#include "core/base/statistics.h"

#include <algorithm>

namespace gridscope {

Summary summarise(std::span<const uint32_t> values) {
  if (values.empty()) return {};
  uint64_t sum = 0;
  for (uint32_t value : values) sum += value;

  // The smallest value that at least 99 % of the values do not exceed.
  std::vector<uint32_t> ranked(values.begin(), values.end());
  const size_t rank = (ranked.size() * 99 + 99) / 100 - 1;
  std::ranges::nth_element(ranked, ranked.begin() + rank);
  return {.mean = double(sum) / double(values.size()), .p99 = ranked[rank], .max = *std::ranges::max_element(values)};
}

Spread spreadOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const size_t middle = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
  return {.min = values.front(), .median = median, .max = values.back()};
}

}  // namespace gridscope
