// See frame_truth.h.
#include "core/pipeline/frame_truth.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace gridscope {

namespace {

// Share of the work that is done when the exact hits are known; the demand comes before them.
constexpr float kDemandShare = 0.1f, kExactShare = 0.5f;

// Traces in pieces, so that the progress is told and work can be abandoned; empty then.
std::vector<Hit> traceExactly(const FrameTruth& frame, const TruthProgress& progress) {
  constexpr size_t kRaysPerPiece = 32768;
  const ExactReference exact(frame.traceInput());
  std::vector<Hit> hits;
  hits.reserve(frame.rays.size());
  const std::span<const Ray> rays(frame.rays);
  for (size_t first = 0; first < rays.size(); first += kRaysPerPiece) {
    const float done = float(first) / float(rays.size());
    if (progress && !progress(kDemandShare + (kExactShare - kDemandShare) * done)) return {};
    const std::vector<Hit> piece = exact.trace(rays.subspan(first, std::min(kRaysPerPiece, rays.size() - first)));
    hits.insert(hits.end(), piece.begin(), piece.end());
  }
  return hits;
}

}  // namespace

FrameTruth tellFrame(Pipeline& pipeline, const TruthProgress& progress) {
  FrameTruth frame{.grid = pipeline.grid(),
                   .worldTriangles = pipeline.worldTriangles(),
                   .rays = pipeline.rays(),
                   .hits = pipeline.hits(),
                   .parameters = pipeline.parameters().trace,
                   .scene = &pipeline.numbered()};
  if (progress && !progress(0.0f)) return frame;
  frame.demand = Demand(frame.grid.parameters, *frame.scene, frame.worldTriangles);
  frame.exact = traceExactly(frame, progress);
  if (frame.exact.size() != frame.rays.size()) return frame;
  frame.truths = tellTruth(frame.input(), frame.rays, frame.hits, frame.exact,
                           [&](float done) { return !progress || progress(kExactShare + (1.0f - kExactShare) * done); });
  frame.totals = countTruths(frame.truths);
  return frame;
}

ProofTotals proveFrame(const FrameTruth& frame, const TruthProgress& progress) {
  return proveFrame(frame.input(), {frame.rays, frame.hits, frame.exact, frame.truths}, progress);
}

float distanceOff(const FrameTruth& frame, uint32_t ray) {
  const RayTruth& truth = frame.truths[ray];
  const Hit &hit = frame.hits[ray], &exact = frame.exact[ray];
  const bool hits = hit.kind == kHitTriangle || hit.kind == kHitVoxel, surface = exact.kind == kHitTriangle;
  if (truth.verdict == kVerdictNoRay || truth.verdict == kVerdictAgrees) return 0.0f;
  if (hits && surface) return std::abs(truth.error);

  const GridParameters& grid = frame.grid.parameters;
  float leave = kFar;
  for (int axis = 0; axis < 3; ++axis) {
    const float direction = frame.rays[ray].direction[axis];
    const float face = gridFace(grid, axis, direction > 0.0f ? grid.cellCount[axis] : 0);
    if (std::abs(direction) > kTiny) leave = std::min(leave, (face - frame.rays[ray].origin[axis]) / direction);
  }
  return std::abs(leave - (surface ? exact.t : hit.t)) / grid.cellEdge;
}

std::vector<uint32_t> worstRays(const FrameTruth& frame, size_t count) {
  std::vector<std::pair<float, uint32_t>> wrong;
  for (uint32_t i = 0; i < frame.truths.size(); ++i)
    if (verdictWrong(frame.truths[i].verdict)) wrong.push_back({-distanceOff(frame, i), i});
  std::ranges::sort(wrong);
  std::vector<uint32_t> rays;
  for (size_t i = 0; i < std::min(count, wrong.size()); ++i) rays.push_back(wrong[i].second);
  return rays;
}

Ledger makeLedger(const FrameTruth& frame) { return makeLedger(frame.input(), frame.truths); }

}  // namespace gridscope
