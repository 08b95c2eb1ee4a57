// See findings.h.
#include "app/report/findings.h"

#include "core/base/error.h"
#include "core/grid/cell_updates.h"
#include "core/pipeline/frame_capture.h"
#include "core/pipeline/frame_truth.h"
#include "core/pipeline/stability.h"
#include "core/trace/cell_rays.h"

namespace gridscope {

Findings::Findings(Session& session, const Options& options) : session_(session), options_(options) {
  for (const View* view : options.views) needs_.insert(view->need);
}

void Findings::beforeUpdate() {
  if (!needs(ViewNeed::cellUpdates)) return;
  if (session_.capture() && !builtHere(*session_.capture()))
    throw Error(options_.scene + ": its grid was built elsewhere, and no update changes it");
  before_ = session_.pipeline().grid();
}

void Findings::afterTrace(uint32_t frame) {
  Pipeline& pipeline = session_.pipeline();
  if (needs(ViewNeed::cellUpdates)) pipeline.useCellUpdates(compareUpdate(before_, pipeline.grid()));
  if (needs(ViewNeed::stability)) compareBuildsOf(frame);
  if (needs(ViewNeed::truth) || needs(ViewNeed::triangleCosts)) tellTruths();
  if (!needs(ViewNeed::cellRays)) return;
  const Grid grid = pipeline.grid();
  const std::vector<Triangle> triangles = pipeline.worldTriangles();
  pipeline.useCellRays(countCellRays({grid, pipeline.numbered(), triangles, pipeline.parameters().trace}, pipeline.rays()));
}

// The last build, and the hits in it, stay.
void Findings::compareBuildsOf(uint32_t frame) {
  const uint32_t builds = options_.stability > 0 ? options_.stability : kComparedBuilds;
  const Stability stability = compareBuilds(session_.pipeline(), builds, [&] { session_.rebuild(frame); });
  session_.pipeline().useStability(stability.cells, stability.rays);
}

void Findings::tellTruths() {
  const FrameTruth truth = tellFrame(session_.pipeline());
  session_.pipeline().useTruths(truth.truths);
  if (!needs(ViewNeed::triangleCosts)) return;
  std::vector<uint32_t> costs;
  for (const TriangleLoss& loss : makeLedger(truth).triangles) costs.push_back(loss.rays);
  session_.pipeline().useTriangleCosts(costs);
}

}  // namespace gridscope
