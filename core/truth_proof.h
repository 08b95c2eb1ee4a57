// Proof of a cause by taking it away: the ray is traced again with that one event removed, by the traversal's own hooks (a load that shows
// the refused reference in that one cell, a fill that is skipped once, a cell queried once more). Nothing else changes, and the exact
// hit is never an input of the trace. If the ray then differs with another first event, that one is removed too: a chain.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/truth.h"

namespace gridscope {

inline constexpr size_t kMostProofLinks = 256;

// One removed event.
struct ProofLink {
  uint32_t cause = kCauseNone;
  ivec3 cell{-1};
  uint32_t reference = kBlank;
  int32_t segment = -1;
};

struct Proof {
  bool confirmed = false;              // without the events in `links` the ray agrees
  std::vector<ProofLink> links;        // one: confirmed alone; more: as a chain, in the order in which they were removed
  Hit hit{};                           // what the ray then ends with
};

// `truth`: of this ray, with a cause.
Proof proveRay(const TruthInput& input, const Ray& ray, const Hit& exact, const RayTruth& truth);

// Counted over the rays of a frame that do not agree, by cause.
struct ProofTotals {
  struct Count {
    uint64_t alone = 0;
    uint64_t chain = 0;
    uint64_t total = 0;
    uint64_t controlConfirmed = 0;     // of controlTotal: agreed after removing instead one event drawn from another ray of the same cause
    uint64_t controlTotal = 0;
  };
  std::array<Count, kCauseCount> causes{};
  uint64_t mostLinks = 0;              // of any confirmed chain
  std::vector<uint32_t> notConfirmed;  // rays, rising
  Count sum() const;
};

// On all cores; the control is drawn from a fixed seed. Nothing confirmed and total 0 when abandoned.
ProofTotals proveFrame(const TruthInput& input, const ExactReference& exact, std::span<const Ray> rays, std::span<const RayTruth> truths,
                       const TruthProgress& progress = {});

// The same where the exact hits are known: one a ray.
ProofTotals proveFrame(const TruthInput& input, std::span<const Hit> exact, std::span<const Ray> rays, std::span<const RayTruth> truths,
                       const TruthProgress& progress = {});

}  // namespace gridscope
