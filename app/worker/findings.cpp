// What some views need beside the frame's products (View::need): found out once such a view is shown, and given to the pipeline
// (maker.h).
#include <algorithm>

#include "app/worker/maker.h"

#include "core/grid/cell_updates.h"
#include "core/pipeline/frame_capture.h"
#include "core/pipeline/stability.h"
#include "core/trace/cell_rays.h"

namespace gridscope {

// Builds that the view `stability` compares.
static constexpr uint32_t kComparedBuilds = 4;

bool FrameMaker::wantsFinding(ViewNeed need) const {
  for (const std::string& name : made_.views)
    if (const View* view = findView(name); view && view->need == need) return true;
  return false;
}

// Views that wait for this can be filled.
void FrameMaker::found(ViewNeed need) {
  findings_.insert(need);
  std::erase_if(viewsDone_, [need](const std::string& name) {
    const View* view = findView(name);
    return view && view->need == need;
  });
}

void FrameMaker::keepGridBeforeUpdate() {
  gridBefore_ = wantsFinding(ViewNeed::cellUpdates) && !current_.scene->foreign ? pipeline_->grid() : Grid{};
}

// What the last update changed. Where the grid before it was not kept, it is made again: a build, the update before, and the last one, so that
// both grids come of the same run.
void FrameMaker::findUpdates() {
  if (!gridBefore_.empty()) return pipeline_->useCellUpdates(compareUpdate(gridBefore_, *current_.grid));
  const std::vector<Instance> instances = *current_.instances;
  pipeline_->build();
  if (instancesBefore_) pipeline_->update(*instancesBefore_);
  const Grid before = pipeline_->grid();
  pipeline_->update(instances);
  pipeline_->useCellUpdates(compareUpdate(before, pipeline_->grid()));
  pipeline_->useGrid(current_.grid->words);
}

// Piece by piece, so that another request need not wait for all of them.
bool FrameMaker::countReads() {
  if (current_.cellRays) return true;
  constexpr size_t kRaysPerPiece = 16384;
  const std::span<const Ray> rays(*current_.rays);
  std::vector<CellRays> counts(cellCountOf(current_.grid->parameters));
  for (size_t first = 0; first < rays.size(); first += kRaysPerPiece) {
    if (interrupted()) return false;
    const std::vector<CellRays> piece = countCellRays(traceInput(), rays.subspan(first, std::min(kRaysPerPiece, rays.size() - first)));
    for (size_t cell = 0; cell < counts.size(); ++cell) counts[cell].read += piece[cell].read, counts[cell].empty += piece[cell].empty;
  }
  current_.cellRays = std::make_shared<const std::vector<CellRays>>(std::move(counts));
  publish(false);
  return true;
}

bool FrameMaker::findAboutCells() {
  if (!countReads()) return false;
  const auto missing = [&](ViewNeed need) { return wantsFinding(need) && !findings_.contains(need); };
  const bool ownGrid = !loaded_->capture || builtHere(*loaded_->capture);
  if (missing(ViewNeed::cellUpdates) && (ownGrid || !gridBefore_.empty())) {
    findUpdates();
    found(ViewNeed::cellUpdates);
  }
  if (missing(ViewNeed::cellRays)) {
    pipeline_->useCellRays(*current_.cellRays);
    found(ViewNeed::cellRays);
  }
  if (missing(ViewNeed::stability)) {
    if (interrupted()) return false;
    compareSomeBuilds();
    found(ViewNeed::stability);
  }
  fillViews(true);
  return true;
}

// The frame's own grid and hits come back afterwards.
void FrameMaker::compareSomeBuilds() {
  const std::vector<Instance> instances = *current_.instances;
  const bool foreign = current_.scene->foreign;
  const Stability stability = compareBuilds(*pipeline_, foreign ? 1 : kComparedBuilds, [&] {
    if (foreign) return;
    pipeline_->build();
    pipeline_->update(instances);
  });
  pipeline_->useStability(stability.cells, stability.rays);
  pipeline_->useGrid(current_.grid->words);
  pipeline_->useHits(*current_.hits);
}

bool FrameMaker::showTruths() {
  if (!current_.truths || findings_.contains(ViewNeed::truth)) return true;
  pipeline_->useTruths(*current_.truths);
  found(ViewNeed::truth);
  std::vector<uint32_t> costs;
  for (const TriangleLoss& loss : current_.ledger->triangles) costs.push_back(loss.rays);
  pipeline_->useTriangleCosts(costs);
  found(ViewNeed::triangleCosts);
  fillViews(true);
  return true;
}

}  // namespace gridscope
