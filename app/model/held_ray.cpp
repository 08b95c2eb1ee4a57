// See held_ray.h.
#include "app/model/held_ray.h"

#include <cstring>

#include "app/frame/changes.h"

namespace gridscope {

namespace {

bool sameTraceParameters(const TraceParameters& a, const TraceParameters& b) { return std::memcmp(&a, &b, sizeof(a)) == 0; }

// The frame's own record, as long as the camera stands where it was made.
void noteRay(WindowModel& model) {
  const FrameSnapshot& frame = *model.frame;
  if (!frame.record || frame.record->pixel != model.selected().pixel || !sameCamera(frame.request.settings->camera, model.camera.pose))
    return;
  if (model.held && model.held->ray == frame.record) return;
  model.held = HeldRay{.ray = frame.record, .pose = model.camera.pose, .grid = frame.grid, .trace = frame.parameters.trace};
}

void recordAgain(WindowModel& model) {
  const FrameSnapshot& frame = *model.frame;
  HeldRay& held = *model.held;
  if (!frame.grid || !frame.worldTriangles || (held.grid == frame.grid && sameTraceParameters(held.trace, frame.parameters.trace))) return;
  RecordedRay ray{.pixel = held.ray->pixel, .ray = held.ray->ray, .surface = held.ray->surface};
  ray.record = recordRay(TraceInput{*frame.grid, frame.scene->numbered, *frame.worldTriangles, frame.parameters.trace}, ray.ray);
  ray.frameHit = ray.record.hit;
  ray.equalsFrame = true;
  held = {
      .ray = std::make_shared<const RecordedRay>(std::move(ray)), .pose = held.pose, .grid = frame.grid, .trace = frame.parameters.trace};
}

}  // namespace

void holdRay(WindowModel& model) {
  if (model.held && model.held->ray->pixel != model.selected().pixel) model.held.reset();
  if (!model.frame || !model.frame->scene || !model.frame->request.settings) return;
  noteRay(model);
  if (rayIsHeld(model)) recordAgain(model);
}

bool rayIsHeld(const WindowModel& model) {
  return model.held && model.held->ray->pixel == model.selected().pixel && !sameCamera(model.held->pose, model.camera.pose);
}

std::shared_ptr<const RecordedRay> shownRay(const WindowModel& model) {
  if (!model.frame) return nullptr;
  if (rayIsHeld(model)) return model.held->ray;
  const std::optional<uint32_t> pixel = model.selected().pixel;
  if (pixel && model.frame->record && model.frame->record->pixel == *pixel) return model.frame->record;
  // While the frame's stages run again the last record keeps its place.
  return pixel && model.held && model.held->ray->pixel == *pixel ? model.held->ray : nullptr;
}

void returnToRay(WindowModel& model) {
  if (model.held) model.camera.pose = model.held->pose;
}

}  // namespace gridscope
