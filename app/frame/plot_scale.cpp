// See plot_scale.h.
#include "app/frame/plot_scale.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"

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
  if (std::abs(value) >= 10.0 || value == std::round(value))
    return (value < 0.0 ? "-" : "") + grouped(static_cast<uint64_t>(std::llround(std::abs(value))));
  return printed("%.3g", value);
}

std::vector<PlotTick> plotTicks(const PlotScale& scale, int most) {
  return axisTicks({.title = "", .low = scale.low, .high = scale.high, .logarithmic = scale.logarithmic}, most);
}

}  // namespace gridscope
