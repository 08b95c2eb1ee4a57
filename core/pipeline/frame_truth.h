// The truth of a whole frame of a pipeline: everything that questions about its rays need, downloaded once, with every ray explained.
#pragma once

#include <vector>

#include "core/pipeline/pipeline.h"
#include "core/truth/ledger.h"
#include "core/truth/proof.h"
#include "core/truth/truth.h"

namespace gridscope {

struct FrameTruth {
  // Products of the frame, from the pipeline.
  Grid grid;
  std::vector<Triangle> worldTriangles;
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  TraceParameters parameters{};
  const NumberedScene* scene = nullptr;  // the pipeline's, which must outlive this

  // What was found out.
  Demand demand;
  std::vector<Hit> exact;        // one a ray; empty when abandoned
  std::vector<RayTruth> truths;  // one a ray; empty when abandoned
  TruthTotals totals;

  TraceInput traceInput() const { return {grid, *scene, worldTriangles, parameters}; }
  TruthInput input() const { return {traceInput(), demand}; }
};

// Of a pipeline whose trace has run. `progress`: see TruthProgress.
FrameTruth tellFrame(Pipeline& pipeline, const TruthProgress& progress = {});

// Proves the causes of a frame's rays.
ProofTotals proveFrame(const FrameTruth& frame, const TruthProgress& progress = {});

// How far the end of a ray is from where it should be, cell edges: where one of the two hits is missing, from the other to where the ray
// leaves the grid. 0 for rays that agree.
float distanceOff(const FrameTruth& frame, uint32_t ray);

// The `count` wrong rays whose ends are farthest off, the worst first.
std::vector<uint32_t> worstRays(const FrameTruth& frame, size_t count);

// What was lost and what it cost.
Ledger makeLedger(const FrameTruth& frame);

}  // namespace gridscope
