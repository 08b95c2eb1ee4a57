// A slider with two handles on a plot's scale.
#pragma once

#include <array>

#include "app/frame/plot_scale.h"

namespace gridscope {

// From (x, y), `width` pixels of this window long, 14 high. Handles are dragged one by one, the bar between them as a whole. True when
// `range` changed; it stays within the scale with its low end below its high end.
bool rangeSlider(const char* id, const std::array<float, 3>& placeAndWidth, const PlotScale& scale, std::array<float, 2>& range,
                 bool enabled);

// Its height, pixels of this window.
float rangeSliderHeight();

}  // namespace gridscope
