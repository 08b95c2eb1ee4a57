// The steps of a recorded ray from left to right: outcome, tests, and the gate's value against its threshold.
#pragma once

#include "app/model/window_model.h"

namespace gridscope {

// As wide as the panel, `height` pixels. Clicking, dragging and the wheel select a step.
void drawStepTimeline(WindowModel& model, const RecordedRay& ray, uint32_t step, float height);

}  // namespace gridscope
