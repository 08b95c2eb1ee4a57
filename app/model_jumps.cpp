// The ways to the next step, ray and cell (model_flow.h).
#include <algorithm>

#include "app/find_next.h"
#include "app/model_flow.h"
#include "app/text.h"

namespace gridscope {

uint32_t stepCount(const WindowModel& model) {
  return model.frame && model.frame->record ? uint32_t(model.frame->record->record.steps.size()) : 0;
}

void goToStep(WindowModel& model, int64_t step) {
  const int64_t count = stepCount(model);
  if (count > 0) model.selection.selectStep(uint32_t(std::clamp<int64_t>(step, 0, count - 1)));
}

static bool isKind(const RecordedRay& record, uint32_t index, StepKind kind) {
  const StepRecord& step = record.record.steps[index];
  switch (kind) {
    case StepKind::nonEmpty: return step.outcome == kStepRead;
    case StepKind::tested: return !step.tests.empty();
    case StepKind::saturated: return step.saturated;
    case StepKind::revisit: return step.outcome == kStepRevisit;
    case StepKind::voxelHit: return record.record.hit.kind == kHitVoxel && index + 1 == record.record.steps.size();
  }
  return false;
}

std::optional<uint32_t> nextStep(const RecordedRay& record, uint32_t from, StepKind kind) {
  for (uint32_t index = from + 1; index < record.record.steps.size(); ++index)
    if (isKind(record, index, kind)) return index;
  return std::nullopt;
}

bool goToNextStep(WindowModel& model, StepKind kind) {
  if (stepCount(model) == 0) return false;
  const std::optional<uint32_t> next = nextStep(*model.frame->record, model.selected().step, kind);
  if (next) model.selection.selectStep(*next);
  return next.has_value();
}

void goToRay(WindowModel& model, int direction) {
  if (!model.frame) return;
  if (const auto pixel = neighbourRay(*model.frame, model.rayOrder.pixels, model.selected().pixel, direction)) model.selection.selectPixel(*pixel);
}

void jumpTo(WindowModel& model, Jump jump) {
  if (!model.frame) return;
  model.request.truth = true;
  model.truthDeclined = false;
  if (!model.frame->truths) {
    model.pendingJump = jump;
    return model.showMessage("The truth of this frame is being told first");
  }
  const RayWanted wanted{.verdict = jump == Jump::nextHole ? kVerdictHole : kVerdictVoxelWrong};
  if (const auto pixel = nextRay(*model.frame, model.rayOrder.pixels, model.selected().pixel, wanted)) return model.selection.selectPixel(*pixel);
  model.showMessage(std::string("No ray of this frame is a ") + (jump == Jump::nextHole ? "hole" : "wrong voxel hit"));
}

void goToNextSaturatedCell(WindowModel& model) {
  if (!model.frame || !model.frame->grid) return;
  if (const auto cell = nextFullCell(*model.frame->grid, model.selected().cell)) model.selection.selectCell(*cell);
  else model.showMessage("The grid holds no reference");
}

}  // namespace gridscope
