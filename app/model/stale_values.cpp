// See stale_values.h.
#include "app/model/stale_values.h"

#include "app/frame/changes.h"
#include "app/model/flow.h"
#include "app/model/held_ray.h"

namespace gridscope {

StaleValues staleValues(const WindowModel& model) {
  if (!model.frame || !model.frame->request.settings) return {};
  const FrameSnapshot& frame = *model.frame;
  const FrameRequest wanted = requestOf(model);
  if (!wanted.settings) return {.grid = true, .rays = true, .steps = true};  // another source is being loaded
  const FrameChanges changes = changesBetween(frame.request, wanted);
  // After an update the demand is worked out again, once the new grid was read.
  const bool rays = changes.trace || frame.stale;
  return {.grid = changes.update || (frame.stale && !frame.demand), .rays = rays, .steps = rays && !rayIsHeld(model)};
}

void noteStale(WindowModel& model) {
  constexpr double kMoment = 0.2;  // seconds: quick stages do not make the panels flicker
  const StaleValues now = staleValues(model);
  const bool any = now.grid || now.rays || now.steps;
  if (!any || model.playing) model.freshAt = model.now;
  model.stale = any && model.now - model.freshAt >= kMoment ? now : StaleValues{};
}

}  // namespace gridscope
