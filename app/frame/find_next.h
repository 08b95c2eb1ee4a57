// Where the jumps lead: the next ray of a verdict or a cause, the rays before and after the selected one. Plain functions over a snapshot;
// all of them go around at the end.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/frame/snapshot.h"

namespace gridscope {

// What a ray must be; what is not given may be anything.
struct RayWanted {
  std::optional<uint32_t> verdict;                        // kVerdict...
  std::optional<uint32_t> cause;                          // kCause...
  std::optional<uint32_t> kind;                           // kHit...
  bool asksForTruth() const { return verdict || cause; }  // then the frame must hold truths
};

// The first such ray behind pixel `from` in `order` (RayOrder::pixels; empty: all pixels, rising), from its beginning when `from` is not in it;
// `from` itself comes last. Where `from` is not given an order begins at its beginning, the picture in its middle. Nothing: there is none, or
// the truth that was asked for has not been told.
std::optional<uint32_t> nextRay(const FrameSnapshot& frame, std::span<const uint32_t> order, std::optional<uint32_t> from,
                                const RayWanted& wanted);

std::optional<uint32_t> nextHole(const FrameSnapshot& frame, std::span<const uint32_t> order, std::optional<uint32_t> from);
std::optional<uint32_t> nextVoxelWrong(const FrameSnapshot& frame, std::span<const uint32_t> order, std::optional<uint32_t> from);

// The ray `places` behind (below 0: before) pixel `from` in `order`, pixels without a ray left out.
std::optional<uint32_t> neighbourRay(const FrameSnapshot& frame, std::span<const uint32_t> order, std::optional<uint32_t> from, int places);

}  // namespace gridscope
