// All that must hold of a frame, as one list for whoever asks: the command check, the report and the window's light.
#pragma once

#include <optional>
#include <span>

#include "core/grid/demand.h"
#include "core/grid/invariants.h"
#include "core/trace/trace.h"

namespace gridscope {

struct GridFacts {
  const Grid& grid;
  const NumberedScene& scene;
  const Demand* demand = nullptr;  // of the present world triangles; may be null where `builtBy` says another program
  std::optional<uint64_t> tried;   // references; nothing: nobody counted
  bool dynamicAdded = true;        // false: after a build, before the first update
  std::string builtBy;             // another program, whose order and overlap test are its own; empty: this one
};

// Of the cells (invariants.h), then that nothing is stale and each triangle is placed (invariants_place.h). What a grid of another program
// need not keep to says why.
std::vector<Invariant> testGrid(const GridFacts& facts);

// Of a trace's, or a capture's, hits (invariants_rays.h).
std::vector<Invariant> testFrameHits(const NumberedScene& scene, const TraceParameters& trace, std::span<const Ray> rays,
                                     std::span<const Hit> hits);

// A line for each that is broken.
std::vector<std::string> faultsOf(std::span<const Invariant> invariants);

}  // namespace gridscope
