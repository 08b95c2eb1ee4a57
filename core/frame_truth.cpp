// See frame_truth.h.
#include "core/frame_truth.h"

#include <algorithm>

#include "core/parallel.h"

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
  FrameTruth frame{.grid = pipeline.grid(), .worldTriangles = pipeline.worldTriangles(), .rays = pipeline.rays(), .hits = pipeline.hits(),
                   .parameters = pipeline.parameters().trace, .scene = &pipeline.numbered()};
  if (progress && !progress(0.0f)) return frame;
  frame.demand = Demand(frame.grid.parameters, *frame.scene, frame.worldTriangles);
  frame.exact = traceExactly(frame, progress);
  if (frame.exact.size() != frame.rays.size()) return frame;
  frame.truths = tellTruth(frame.input(), frame.rays, frame.hits, frame.exact, [&](float done) {
    return !progress || progress(kExactShare + (1.0f - kExactShare) * done);
  });
  frame.totals = countTruths(frame.truths);
  return frame;
}

ProofTotals proveFrame(const FrameTruth& frame, const TruthProgress& progress) {
  return proveFrame(frame.input(), frame.exact, frame.rays, frame.truths, progress);
}

Ledger makeLedger(const FrameTruth& frame) { return makeLedger(frame.input(), frame.truths); }

}  // namespace gridscope
