// The plots of a sweep: memory and trace time against the share of wrong rays, a point a setting, with their fronts.
#pragma once

#include "core/tune/tune.h"
#include "views/plot.h"

namespace gridscope {

// points[i] is the i-th measured row of result.rows.
ScatterPlot tuneMemoryPlot(const TuneResult& result);
ScatterPlot tuneTimePlot(const TuneResult& result);

// Both, side by side.
Drawing drawTune(const TuneResult& result, PlotSize each = {.width = 640, .height = 460});

}  // namespace gridscope
