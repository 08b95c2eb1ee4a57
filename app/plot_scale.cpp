// See plot_scale.h.
#include "app/plot_scale.h"

#include <algorithm>
#include <cmath>

#include "app/text.h"

namespace gridscope {

double PlotScale::placeOf(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  return std::log(std::max(value, low * 1e-3) / low) / std::log(high / low);
}

double PlotScale::valueAt(double place) const { return logarithmic ? low * std::pow(high / low, place) : low + place * (high - low); }

// 1, 2 or 5 times a power of ten, the smallest at or above `least`.
static double roundStep(double least) {
  const double ten = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * ten >= least * (1.0 - 1e-9)) return factor * ten;
  return 10.0 * ten;
}

PlotScale scaleFromZero(double highest) {
  const double most = std::max(1.0, highest), step = roundStep(most / 4.0);
  return {.low = 0.0, .high = step * std::ceil(most / step - 1e-9)};
}

PlotScale scaleOfTens(double lowest, double highest) {
  const double low = std::pow(10.0, std::floor(std::log10(lowest) + 1e-9)), high = std::pow(10.0, std::ceil(std::log10(highest) - 1e-9));
  return {.low = low, .high = std::max(high, 10.0 * low), .logarithmic = true};
}

std::string plotNumber(double value) {
  if (value == 0.0) return "0";
  if (std::abs(value) >= 10.0 || value == std::round(value)) return (value < 0.0 ? "-" : "") + grouped(static_cast<uint64_t>(std::llround(std::abs(value))));
  return printed("%.3g", value);
}

static std::vector<PlotTick> linearTicks(const PlotScale& scale, int most) {
  const double step = roundStep((scale.high - scale.low) / std::max(1, most - 1));
  std::vector<PlotTick> ticks;
  for (int64_t index = std::llround(std::ceil(scale.low / step - 1e-9)); double(index) * step <= scale.high + 1e-9 * step; ++index)
    ticks.push_back({double(index) * step, plotNumber(double(index) * step)});
  return ticks;
}

static std::vector<PlotTick> logarithmicTicks(const PlotScale& scale, const std::vector<double>& factors, int everyTen) {
  std::vector<PlotTick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(scale.low) + 1e-9)), last = static_cast<int>(std::ceil(std::log10(scale.high) - 1e-9));
  for (int ten = first; ten <= last; ten += everyTen)
    for (const double factor : factors) {
      const double value = factor * std::pow(10.0, ten);
      if (value >= scale.low * (1.0 - 1e-9) && value <= scale.high * (1.0 + 1e-9)) ticks.push_back({value, plotNumber(value)});
    }
  return ticks;
}

std::vector<PlotTick> plotTicks(const PlotScale& scale, int most) {
  if (!scale.logarithmic) return linearTicks(scale, most);
  for (const std::vector<double>& factors : {std::vector<double>{1.0, 2.0, 5.0}, std::vector<double>{1.0, 3.0}}) {
    std::vector<PlotTick> ticks = logarithmicTicks(scale, factors, 1);
    if (int(ticks.size()) <= most) return ticks;
  }
  for (int everyTen = 1;; ++everyTen) {
    std::vector<PlotTick> ticks = logarithmicTicks(scale, {1.0}, everyTen);
    if (int(ticks.size()) <= std::max(2, most)) return ticks;
  }
}

}  // namespace gridscope
