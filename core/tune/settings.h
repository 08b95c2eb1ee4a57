// Which settings a sweep tries: the frame's own, and every combination of the axes.
#pragma once

#include <vector>

#include "core/tune/tune.h"

namespace gridscope {

// A frame's grid and trace, as settings and as the parameters that the stages read.
struct TuneOwn {
  GridSettings grid;
  TraceSettings trace;
  GridParameters gridParameters{};  // of a build here: it counts refusals
  TraceParameters traceParameters{};
};

// A frame's own. Where its parameters are not what its settings make of the bounds (a capture that another program wrote says the grid's
// shape, not the settings), settings are made from them: edge, capacity, overlap test, and the trace's lengths in cell edges.
TuneOwn ownSettings(const FrameSettings& settings, const FrameParameters& parameters, const NumberedScene& scene, const Bounds& bounds);

// Grids to try, without the frame's own. Cells are the outermost: exact hits are made anew for each cell edge.
std::vector<GridSettings> gridsToTry(const TuneAxes& axes, const GridSettings& own, bool canNumber);

// Trace settings to try, without the frame's own.
std::vector<TraceSettings> tracesToTry(const TuneAxes& axes, const TraceSettings& own);

// Equal in what a sweep varies.
bool triesSame(const GridSettings& a, const GridSettings& b);
bool triesSame(const TraceSettings& a, const TraceSettings& b);

}  // namespace gridscope
