// The ways to the next ray of a kind and to the next cell (flow.h); ray_stepping.h has those to steps.
#include "app/frame/find_next.h"
#include "app/frame/projection.h"
#include "app/model/flow.h"

namespace gridscope {

void jumpTo(WindowModel& model, Jump jump) {
  if (!model.frame) return;
  model.request.truth = true;
  model.truthDeclined = false;
  if (!model.frame->truths) {
    model.pendingJump = jump;
    return model.showMessage("The truth of this frame is being told first");
  }
  const RayWanted wanted{.verdict = jump == Jump::nextHole ? kVerdictHole : kVerdictVoxelWrong};
  if (const auto pixel = nextRay(*model.frame, model.rayOrder.pixels, model.selected().pixel, wanted))
    return model.selection.selectPixel(*pixel);
  model.showMessage(std::string("No ray of this frame is a ") + (jump == Jump::nextHole ? "hole" : "wrong voxel hit"));
}

void goToNextSaturatedCell(WindowModel& model) {
  if (!model.frame || !model.frame->occupied) return;
  const auto cell = nextFullCell(*model.frame->occupied, model.selected().cell);
  if (!cell) return model.showMessage("The grid holds no reference");
  model.selection.selectCell(*cell);
  model.focusWanted = cellBounds(model.frame->gridShape(), *cell);
}

}  // namespace gridscope
