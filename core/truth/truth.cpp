// Verdicts, names and counts of a frame's truths; see truth.h.
#include "core/truth/truth.h"

#include <atomic>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/truth/cause.h"

namespace gridscope {

namespace {

constexpr TruthName kVerdictNames[kVerdictCount] = {
    {"noRay", "no ray", "The pixel has no ray."},
    {"agree", "agrees", "The ray ends where the exact one does."},
    {"hole", "hole", "A surface is there, and the ray missed everything."},
    {"voxelRight", "voxel right", "A voxel hit within a cell's diagonal of the true surface."},
    {"voxelWrong", "voxel wrong", "A voxel hit farther than a cell's diagonal from the true surface, or where there is none."},
    {"far", "too far", "A triangle hit behind the true surface."},
    {"near", "too near", "A triangle hit before the true surface, or where there is none."},
};

constexpr TruthName kCauseNames[kCauseCount] = {
    {"none", "none", "The ray agrees, or there is none."},
    {"refused", "refused", "The reference of the true surface found no slot in the cell that the hit lies in."},
    {"steppedOver", "stepped over", "No segment starts in the cell that holds the hit: it was never queried."},
    {"revisit", "revisit", "A segment that would have reached the hit was skipped: its cell was the one visited last."},
    {"segmentEnd", "segment end", "The cell was queried, but the hit lies outside the elongated segment."},
    {"acceptedEarly", "accepted early", "A farther hit of an earlier cell was accepted first."},
    {"gate", "gate", "The cell refused the surface, and near the launching surface its gap was not filled."},
    {"filledEarly", "filled early", "A voxel hit of an earlier saturated cell ended the ray."},
    {"alpha", "alpha", "Alpha keying turned a hit down that counts, or let one through that does not."},
    {"selfHit", "self-hit", "The nearest distance that counts hid a hit, or let one through."},
    {"outside", "outside", "The surface or the ray lies outside the grid."},
    {"leftOut", "left out", "A triangle that the build leaves out: without an area, or turned down by the overlap test."},
    {"stale", "stale", "A dynamic reference that the update left behind, or missed."},
    {"notInserted", "not inserted", "The reference is missing though its cell had room: an invariant is broken."},
    {"segmentLimit", "segment limit", "The ray was ended by the limit of segments."},
    {"numeric", "numeric", "An edge within rounding: the rest."},
};

// Calls work(begin, end) over all rays on all cores, and tells the progress; false when it was abandoned.
bool forRays(size_t count, const TruthProgress& progress, const std::function<void(size_t, size_t)>& work) {
  constexpr size_t kRaysPerRange = 256;
  std::atomic<size_t> done{0};
  std::atomic<bool> abandoned{false};
  forRanges(count, kRaysPerRange, [&](size_t begin, size_t end) {
    if (abandoned) return;
    work(begin, end);
    done += end - begin;
    if (progress && !progress(float(done) / float(count))) abandoned = true;
  });
  return !abandoned;
}

// Causes that say how a ray ended, not only where a surface was lost.
bool endsRay(uint32_t cause) { return cause == kCauseFilledEarly || cause == kCauseAcceptedEarly || cause == kCauseSegmentLimit; }

// The ray's record says what happened, where it ends as the hit does or at least is as wrong. Otherwise the hit was made by other rules, and
// is asked itself; then the record, for what it says about the surface and not about its own end.
TruthEvent firstEventOf(const TruthInput& input, const Ray& ray, const Hit& traced, const Hit& exact, uint32_t verdict) {
  const GridParameters& grid = input.trace.grid.parameters;
  const RayRecord record = recordRay(input.trace, ray);
  const uint32_t recorded = judge(record.hit, exact, grid);
  const bool alike = endsAlike(traced, record.hit, grid);
  if (alike || recorded == verdict) {
    const TruthEvent event = findEvent(input, ray, record, exact);
    if (alike || event.cause != kCauseNumeric) return event;
  }
  const TruthEvent foreign = findForeignEvent(input, ray, traced, exact);
  if (foreign.cause != kCauseNumeric || recorded == kVerdictAgrees) return foreign;
  const TruthEvent event = findEvent(input, ray, record, exact);
  return endsRay(event.cause) ? foreign : event;
}

}  // namespace

const TruthName& verdictName(uint32_t verdict) {
  CHECK_LT(verdict, kVerdictCount);
  return kVerdictNames[verdict];
}

const TruthName& causeName(uint32_t cause) {
  CHECK_LT(cause, kCauseCount);
  return kCauseNames[cause];
}

uint32_t judge(const Hit& traced, const Hit& exact, const GridParameters& grid) {
  if (exact.kind == kHitNoRay) return kVerdictNoRay;
  const bool surface = exact.kind == kHitTriangle;
  const float error = traced.t - exact.t;
  if (traced.kind == kHitVoxel)
    return surface && std::abs(error) <= std::sqrt(3.0f) * grid.cellEdge ? kVerdictVoxelRight : kVerdictVoxelWrong;
  if (traced.kind != kHitTriangle) return surface ? kVerdictHole : kVerdictAgrees;
  if (!surface) return kVerdictTooNear;
  if (std::abs(error) <= kAgreement * grid.cellEdge) return kVerdictAgrees;
  return error > 0.0f ? kVerdictTooFar : kVerdictTooNear;
}

bool endsAlike(const Hit& traced, const Hit& recorded, const GridParameters& grid) {
  const auto kindOf = [](const Hit& hit) { return hit.kind == kHitNoRay ? kHitMiss : hit.kind; };
  if (kindOf(traced) != kindOf(recorded)) return false;
  const bool hits = traced.kind == kHitTriangle || traced.kind == kHitVoxel;
  return !hits || std::abs(traced.t - recorded.t) <= kAgreement * grid.cellEdge;
}

ivec3 hitCell(const GridParameters& grid, const Ray& ray, const Hit& hit) { return gridCell(grid, rayPoint(ray, hit.t)); }

RayTruth explainRay(const TruthInput& input, const Ray& ray, const Hit& traced, const Hit& exact) {
  const GridParameters& grid = input.trace.grid.parameters;
  RayTruth truth{};
  truth.verdict = judge(traced, exact, grid);
  truth.exactReference = exact.kind == kHitTriangle ? exact.reference : kNoReference;
  truth.exactT = exact.kind == kHitTriangle ? exact.t : 0.0f;
  truth.reference = kNoReference;
  truth.cell = ivec3(-1);
  truth.segment = -1;
  if (truth.verdict == kVerdictNoRay) return truth;
  const bool hits = traced.kind == kHitTriangle || traced.kind == kHitVoxel;
  if (hits && exact.kind == kHitTriangle) truth.error = (traced.t - exact.t) / grid.cellEdge;
  if (truth.verdict == kVerdictAgrees) return truth;

  const TruthEvent event = firstEventOf(input, ray, traced, exact, truth.verdict);
  truth.cause = event.cause;
  truth.cell = event.cell;
  truth.reference = event.reference;
  truth.segment = event.segment;
  return truth;
}

uint64_t TruthTotals::wrong() const {
  return verdicts[kVerdictHole] + verdicts[kVerdictVoxelWrong] + verdicts[kVerdictTooFar] + verdicts[kVerdictTooNear];
}

uint64_t TruthTotals::differ() const { return wrong() + verdicts[kVerdictVoxelRight]; }

TruthTotals countTruths(std::span<const RayTruth> truths) {
  TruthTotals totals;
  for (const RayTruth& truth : truths) {
    ++totals.verdicts[truth.verdict];
    if (truth.verdict == kVerdictNoRay) continue;
    ++totals.rays;
    if (truth.verdict != kVerdictAgrees)
      ++totals.causes[truth.cause];
    else if (truth.exactReference != kNoReference)
      ++totals.agreeHit;
    else
      ++totals.agreeMiss;
  }
  return totals;
}

std::vector<RayTruth> tellTruth(const TruthInput& input, const ExactReference& exact, std::span<const Ray> rays, std::span<const Hit> hits,
                                const TruthProgress& progress) {
  CHECK_EQ(hits.size(), rays.size());
  std::vector<RayTruth> truths(rays.size());
  const bool done = forRays(rays.size(), progress, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) truths[i] = explainRay(input, rays[i], hits[i], exact.trace(rays[i]));
  });
  return done ? truths : std::vector<RayTruth>{};
}

std::vector<RayTruth> tellTruth(const TruthInput& input, std::span<const Ray> rays, std::span<const Hit> hits, std::span<const Hit> exact,
                                const TruthProgress& progress) {
  CHECK_EQ(hits.size(), rays.size());
  CHECK_EQ(exact.size(), rays.size());
  std::vector<RayTruth> truths(rays.size());
  const bool done = forRays(rays.size(), progress, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) truths[i] = explainRay(input, rays[i], hits[i], exact[i]);
  });
  return done ? truths : std::vector<RayTruth>{};
}

}  // namespace gridscope
