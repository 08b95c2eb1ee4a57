// Proof of a cause by taking it away: the ray is traced again with that one event removed, by the traversal's own hooks (a load that shows
// the refused reference in that one cell, a fill that is skipped once, a cell queried once more). Nothing else changes, and the exact
// hit is never an input of the trace. If the ray then differs with another, later first event, that one is removed too: a chain. A hit that
// this trace does not end with was made by other rules: there the proof is that, with the event's rule changed, the trace ends with it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/truth/cause.h"

namespace gridscope {

inline constexpr size_t kMostProofLinks = 256;

struct Proof {
  bool confirmed = false;         // without the events in `links` the ray agrees, or ends as the foreign hit does
  bool foreign = false;           // the hit was made by other rules: confirmed by making it again
  std::vector<TruthEvent> links;  // one: confirmed alone; more: as a chain, in the order in which they were removed
  Hit hit{};                      // what the ray then ends with
};

// `truth`: of this ray, with a cause. `traced`: the frame's hit that it is about.
Proof proveRay(const TruthInput& input, const Ray& ray, const Hit& traced, const Hit& exact, const RayTruth& truth);

// Counted over the rays of a frame that do not agree, by cause. The control proves each ray with one event drawn from another ray of the same
// cause instead of its own: what that confirms is chance.
struct ProofTotals {
  struct Count {
    uint64_t alone = 0;
    uint64_t chain = 0;
    uint64_t total = 0;
    uint64_t controlConfirmed = 0;  // of controlTotal: alone
    uint64_t controlChained = 0;    // of controlTotal: alone, or as a chain that goes on by the same rules
    uint64_t controlTotal = 0;
  };
  std::array<Count, kCauseCount> causes{};
  uint64_t mostLinks = 0;              // of any confirmed chain
  std::vector<uint32_t> notConfirmed;  // rays, rising
  Count sum() const;
};

// A frame's rays, one of each a ray. What it refers to must outlive the proof.
struct ProofRays {
  std::span<const Ray> rays;
  std::span<const Hit> hits;
  std::span<const Hit> exact;
  std::span<const RayTruth> truths;
};

// On all cores; the control is drawn from a fixed seed. Nothing confirmed and total 0 when abandoned.
ProofTotals proveFrame(const TruthInput& input, const ProofRays& frame, const TruthProgress& progress = {});

}  // namespace gridscope
