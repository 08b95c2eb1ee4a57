// The truth of a frame: every ray beside the exact answer, with a verdict and, where it does not agree, the one cause: the first event
// along the ray that makes it differ. A cause is found by reading the ray's record (the recording trace) against the exact hit and the
// demand of the cells on the way; proof.h takes events away to prove it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/grid/demand.h"
#include "core/trace/exact.h"
#include "core/trace/trace.h"
#include "shaders/shared/truth/truth.h"

namespace gridscope {

// What all questions about one frame's rays need. What it refers to must outlive it.
struct TruthInput {
  TraceInput trace;
  const Demand& demand;  // of the same triangles and grid parameters
};

// What a verdict or a cause is called: `key` in JSON and on the command line ("steppedOver"), `title` for people ("stepped over"), `about`
// one sentence.
struct TruthName {
  std::string_view key;
  std::string_view title;
  std::string_view about;
};
const TruthName& verdictName(uint32_t verdict);  // kVerdict...
const TruthName& causeName(uint32_t cause);      // kCause...

// kVerdict... of a ray whose hits are these. Whether there is a ray the exact hit says: a traced hit that denies it is a miss.
uint32_t judge(const Hit& traced, const Hit& exact, const GridParameters& grid);

// Does a hit end a ray as this trace does: in the same way, and within kAgreement of the distance? Then the ray's record tells of it, even
// where another device's or another program's rounding made it.
bool endsAlike(const Hit& traced, const Hit& recorded, const GridParameters& grid);

// Verdict, cause and evidence of one ray.
RayTruth explainRay(const TruthInput& input, const Ray& ray, const Hit& traced, const Hit& exact);

// The cell that holds the point where a ray meets a hit; outside the grid some component is -1 or cellCount.
ivec3 hitCell(const GridParameters& grid, const Ray& ray, const Hit& hit);

// Counted over the rays of a frame. agreeHit + agreeMiss + the other verdicts = rays; the causes add up to the rays that do not agree.
struct TruthTotals {
  uint64_t rays = 0;  // valid ones
  uint64_t agreeHit = 0;
  uint64_t agreeMiss = 0;
  std::array<uint64_t, kVerdictCount> verdicts{};
  std::array<uint64_t, kCauseCount> causes{};
  uint64_t wrong() const;   // hole + voxel wrong + too far + too near
  uint64_t differ() const;  // every ray that does not agree, voxel right included
};
TruthTotals countTruths(std::span<const RayTruth> truths);

// Told from time to time what share is done, 0..1, from any thread; false abandons the work. May be empty.
using TruthProgress = std::function<bool(float)>;

// Of all rays, on all cores. Empty when abandoned.
std::vector<RayTruth> tellTruth(const TruthInput& input, const ExactReference& exact, std::span<const Ray> rays, std::span<const Hit> hits,
                                const TruthProgress& progress = {});

// The same where the exact hits are known: one a ray.
std::vector<RayTruth> tellTruth(const TruthInput& input, std::span<const Ray> rays, std::span<const Hit> hits, std::span<const Hit> exact,
                                const TruthProgress& progress = {});

}  // namespace gridscope
