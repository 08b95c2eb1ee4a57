// The axes of plots: from values to places, and the ticks a person expects. Knows nothing of drawing.
#pragma once

#include <string>
#include <vector>

#include "views/plot.h"

namespace gridscope {

struct PlotScale {
  double low = 0.0;
  double high = 1.0;         // above low
  bool logarithmic = false;  // then low > 0

  double placeOf(double value) const;  // 0 at low, 1 at high; beyond them outside 0..1
  double valueAt(double place) const;
};

// 0 to a round number at or above `highest`, so that the last tick closes the axis. At least 1.
PlotScale scaleFromZero(double highest);

// Powers of ten around all values that count: [lowest, highest], both above 0.
PlotScale scaleOfTens(double lowest, double highest);

// At most `most` ticks, as drawn plots have them.
std::vector<PlotTick> plotTicks(const PlotScale& scale, int most);

// "1,200", "0.05", "2.5".
std::string plotNumber(double value);

}  // namespace gridscope
