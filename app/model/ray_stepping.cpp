// See ray_stepping.h.
#include "app/model/ray_stepping.h"

#include <algorithm>

#include "app/frame/camera_moves.h"
#include "app/frame/find_next.h"
#include "app/model/held_ray.h"

namespace gridscope {

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
