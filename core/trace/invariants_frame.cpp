// See invariants_frame.h.
#include "core/trace/invariants_frame.h"

#include "core/base/error.h"
#include "core/grid/invariants_place.h"
#include "core/trace/invariants_rays.h"

namespace gridscope {

// What every grid must keep to, whoever built it.
static std::vector<Invariant> testForeignGrid(const GridFacts& facts) {
  const std::string by = "the grid was built by " + facts.builtBy;
  std::vector<Invariant> invariants = testCells(facts.grid, facts.scene, nullptr);
  for (Invariant& invariant : invariants)
    if (invariant.key == "staticFirst")
      invariant = {.key = invariant.key, .name = "static before dynamic", .whyNot = by + ": its order is its own"};
  invariants.push_back({.key = "nothingStale", .name = "nothing stale", .whyNot = by + ": its overlap test is not known"});
  invariants.push_back(
      {.key = "placed", .name = "each triangle is where the overlap test puts it", .whyNot = by + ": its overlap test is not known"});
  return invariants;
}

std::vector<Invariant> testGrid(const GridFacts& facts) {
  if (!facts.builtBy.empty()) return testForeignGrid(facts);
  CHECK(facts.demand != nullptr);
  std::vector<Invariant> invariants = testCells(facts.grid, facts.scene, facts.tried ? &*facts.tried : nullptr);
  const PlaceInput places{facts.grid, *facts.demand, facts.dynamicAdded};
  invariants.push_back(testStale(places));
  invariants.push_back(testPlacement(places));
  return invariants;
}

std::vector<Invariant> testFrameHits(const NumberedScene& scene, const TraceParameters& trace, std::span<const Ray> rays,
                                     std::span<const Hit> hits) {
  return {testEnds(rays, hits), testHits(scene, trace, hits)};
}

std::vector<std::string> faultsOf(std::span<const Invariant> invariants) {
  std::vector<std::string> lines;
  for (const Invariant& invariant : invariants)
    if (!invariant.holds()) lines.push_back(invariant.name + ": " + invariant.fault);
  return lines;
}

}  // namespace gridscope
