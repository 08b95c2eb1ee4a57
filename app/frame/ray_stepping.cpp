// See ray_stepping.h.
#include "app/frame/ray_stepping.h"

#include <algorithm>

#include "app/frame/camera_moves.h"
#include "app/frame/find_next.h"
#include "app/model/held_ray.h"

namespace gridscope {

namespace {

// Does the cell of a step hold references? A revisited one was looked into by the last step that was not a revisit.
bool cellHoldsReferences(const RayRecord& record, uint32_t step) {
  for (uint32_t i = step + 1; i-- > 0;)
    if (record.steps[i].outcome != kStepRevisit)
      return record.steps[i].outcome == kStepRead && record.steps[i].cell == record.steps[step].cell;
  return false;
}

bool isFound(const RayRecord& record, uint32_t step, StepSearch search) {
  const StepRecord& at = record.steps[step];
  switch (search) {
    case StepSearch::nonEmpty: return cellHoldsReferences(record, step);
    case StepSearch::tested: return !at.tests.empty();
    case StepSearch::saturated: return at.saturated;
    case StepSearch::revisit: return at.outcome == kStepRevisit;
    case StepSearch::voxelHit: return record.hit.kind == kHitVoxel && step + 1 == record.steps.size();
  }
  return false;
}

}  // namespace

std::optional<uint32_t> nextStep(const RayRecord& record, uint32_t from, StepSearch search, int direction) {
  const int64_t count = static_cast<int64_t>(record.steps.size());
  for (int64_t step = int64_t(from) + direction; step >= 0 && step < count; step += direction)
    if (isFound(record, static_cast<uint32_t>(step), search)) return static_cast<uint32_t>(step);
  return std::nullopt;
}

const char* noSuchStep(StepSearch search, int direction) {
  const bool later = direction > 0;
  switch (search) {
    case StepSearch::nonEmpty:
      return later ? "No later step starts in a cell that holds references" : "No earlier step starts in a cell that holds references";
    case StepSearch::tested: return later ? "No later step tests a triangle" : "No earlier step tests a triangle";
    case StepSearch::saturated: return later ? "No later step reads a saturated cell" : "No earlier step reads a saturated cell";
    case StepSearch::revisit:
      return later ? "No later step starts in the cell visited last" : "No earlier step starts in the cell visited last";
    case StepSearch::voxelHit: return "The ray does not end behind here with a voxel hit";
  }
  return "";
}

const RecordedRay* shownRecord(const WindowModel& model) { return shownRay(model).get(); }

std::optional<uint32_t> shownStep(const WindowModel& model) {
  const RecordedRay* ray = shownRecord(model);
  if (!ray || ray->record.steps.empty()) return std::nullopt;
  return std::min(model.selected().step, static_cast<uint32_t>(ray->record.steps.size() - 1));
}

void selectStepAt(WindowModel& model, uint32_t step) {
  const RecordedRay* ray = shownRecord(model);
  if (ray && !ray->record.steps.empty()) model.selection.selectStep(std::min(step, static_cast<uint32_t>(ray->record.steps.size() - 1)));
}

void stepForward(WindowModel& model) {
  if (const auto step = shownStep(model)) selectStepAt(model, *step + 1);
}

void stepBack(WindowModel& model) {
  if (const auto step = shownStep(model)) selectStepAt(model, *step > 0 ? *step - 1 : 0);
}

void stepFirst(WindowModel& model) { selectStepAt(model, 0); }

void stepLast(WindowModel& model) { selectStepAt(model, UINT32_MAX); }

bool stepToNext(WindowModel& model, StepSearch search, int direction) {
  const auto from = shownStep(model);
  const auto found = from ? nextStep(shownRecord(model)->record, *from, search, direction) : std::nullopt;
  if (found)
    selectStepAt(model, *found);
  else if (from)
    model.showMessage(noSuchStep(search, direction));
  return found.has_value();
}

void nextRay(WindowModel& model, int direction) {
  if (!model.frame) return;
  const auto pixel = neighbourRay(*model.frame, model.rayOrder.pixels, model.selected().pixel, direction);
  if (!pixel) return;
  model.selection.selectPixel(*pixel);
  model.stepsPlaying = false;
}

void togglePlay(WindowModel& model) {
  const auto step = shownStep(model);
  model.stepsPlaying = !model.stepsPlaying && step.has_value();
  if (model.stepsPlaying && *step + 1 == shownRecord(model)->record.steps.size()) stepFirst(model);
}

void advancePlay(WindowModel& model, double& due) {
  const auto step = shownStep(model);
  if (!model.stepsPlaying || !step) {
    due = 0.0;
    return;
  }
  const double pause = 1.0 / std::max(model.stepsPerSecond, 0.1f);
  if (due == 0.0) due = model.now + pause;
  if (model.now < due) return;
  due = std::max(due + pause, model.now);  // a slow frame is not made up for by skipping steps
  stepForward(model);
  if (*step + 2 >= shownRecord(model)->record.steps.size()) model.stepsPlaying = false;
}

void followStep(WindowModel& model) {
  static std::optional<std::pair<uint32_t, uint32_t>> followed;  // pixel and step
  const std::optional<uint32_t> step = shownStep(model);
  if (!model.followStep || !step) {
    followed.reset();
    return;
  }
  const std::shared_ptr<const RecordedRay> ray = shownRay(model);
  const std::pair now{ray->pixel, *step};
  if (followed == now) return;
  followed = now;
  moveTargetTo(model.camera, rayPoint(ray->ray, ray->record.steps[*step].start));
}

}  // namespace gridscope
