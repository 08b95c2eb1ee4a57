// See settings.h.
#include "core/tune/settings.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/grid/derive.h"
#include "core/trace/derive.h"

namespace gridscope {
namespace {

template <class Value>
std::vector<Value> orOwn(const std::vector<Value>& axis, Value own) {
  return axis.empty() ? std::vector<Value>{own} : axis;
}

bool sameShape(const GridParameters& a, const GridParameters& b) {
  return a.origin == b.origin && a.cellEdge == b.cellEdge && a.cellCount == b.cellCount && a.capacity == b.capacity &&
         a.overlap == b.overlap && a.insertion == b.insertion && a.boxHalfEdge == b.boxHalfEdge;
}

// Do the settings make this shape of the bounds? Settings that make no grid at all do not.
bool makes(const GridSettings& settings, const Bounds& bounds, const NumberedScene& scene, const GridParameters& shape) {
  try {
    return sameShape(deriveGrid(settings, bounds, scene), shape);
  } catch (const Error&) {
    return false;
  }
}

// A length in cell edges without the noise of having been a 32-bit length in the world.
float inEdges(float length, float edge) { return float(std::round(double(length) / edge * 1e5) / 1e5); }

GridSettings settingsOf(const GridParameters& grid, GridSettings settings) {
  settings.cellEdge = grid.cellEdge;
  settings.capacity = uint32_t(grid.capacity);
  settings.overlap = grid.overlap;
  settings.insertion = grid.insertion;
  settings.enlargement = inEdges(2.0f * grid.boxHalfEdge, grid.cellEdge);
  settings.stretch = stretchOf(grid);
  return settings;
}

TraceSettings settingsOf(const TraceParameters& trace, float edge, TraceSettings settings) {
  settings.traversal = trace.traversal;
  settings.back = inEdges(trace.back, edge);
  settings.ahead = std::max(0.0f, inEdges(trace.ahead - edge, edge));
  settings.tMin = inEdges(trace.tMin, edge);
  settings.gapFill = trace.gapFill != 0;
  settings.gate = inEdges(trace.gate, edge);
  return settings;
}

}  // namespace

bool triesSame(const GridSettings& a, const GridSettings& b) {
  return a.cells == b.cells && a.cellEdge == b.cellEdge && a.capacity == b.capacity && a.overlap == b.overlap && a.numberBy == b.numberBy;
}

bool triesSame(const TraceSettings& a, const TraceSettings& b) {
  const bool reachMatters = a.traversal == kTraversalSegment;
  return a.traversal == b.traversal && a.gate == b.gate && (!reachMatters || (a.back == b.back && a.ahead == b.ahead));
}

TuneOwn ownSettings(const FrameSettings& settings, const FrameParameters& parameters, const NumberedScene& scene, const Bounds& bounds) {
  TuneOwn own{
      .grid = settings.grid, .trace = settings.trace, .gridParameters = laidOutHere(parameters.grid), .traceParameters = parameters.trace};
  if (!makes(settings.grid, bounds, scene, own.gridParameters)) own.grid = settingsOf(parameters.grid, settings.grid);
  const TraceParameters derived = deriveTrace(settings.trace, parameters.grid);
  if (std::memcmp(&derived, &parameters.trace, sizeof derived) != 0)
    own.trace = settingsOf(parameters.trace, parameters.grid.cellEdge, settings.trace);
  return own;
}

std::vector<GridSettings> gridsToTry(const TuneAxes& axes, const GridSettings& own, bool canNumber) {
  const std::vector<NumberBy> numberings = canNumber ? orOwn(axes.numberings, own.numberBy) : std::vector<NumberBy>{own.numberBy};
  std::vector<GridSettings> grids;
  for (uint32_t cells : orOwn(axes.cells, own.cells))
    for (uint32_t overlap : orOwn(axes.overlaps, own.overlap))
      for (NumberBy numberBy : numberings)
        for (uint32_t capacity : orOwn(axes.capacities, own.capacity)) {
          GridSettings grid = own;
          grid.cells = cells;
          if (!axes.cells.empty()) grid.cellEdge = 0.0f;
          grid.overlap = overlap;
          grid.numberBy = numberBy;
          grid.capacity = capacity;
          if (!triesSame(grid, own)) grids.push_back(grid);
        }
  return grids;
}

std::vector<TraceSettings> tracesToTry(const TuneAxes& axes, const TraceSettings& own) {
  std::vector<TraceSettings> traces;
  auto add = [&](const TraceSettings& trace) {
    auto same = [&](const TraceSettings& other) { return triesSame(trace, other); };
    if (!same(own) && std::ranges::none_of(traces, same)) traces.push_back(trace);
  };
  for (uint32_t traversal : orOwn(axes.traversals, own.traversal))
    for (float back : orOwn(axes.backs, own.back))
      for (float ahead : orOwn(axes.aheads, own.ahead))
        for (float gate : orOwn(axes.gates, own.gate)) {
          TraceSettings trace = own;
          trace.traversal = traversal;
          if (traversal == kTraversalSegment) trace.back = back, trace.ahead = ahead;
          trace.gate = gate;
          add(trace);
        }
  return traces;
}

}  // namespace gridscope
