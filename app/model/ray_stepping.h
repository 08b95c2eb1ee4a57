// Going through the steps of the recorded ray: forward, back, to the next step of a kind, to the next ray. What buttons and keys call. Going
// back reads the record, so it is the exact inverse of going forward.
#pragma once

#include <optional>

#include "app/frame/step_search.h"
#include "app/model/window_model.h"

namespace gridscope {

// The selected ray (held_ray.h), as a plain pointer.
const RecordedRay* shownRecord(const WindowModel& model);

// The selected step, within the record; nothing without a record or with one that has no steps.
std::optional<uint32_t> shownStep(const WindowModel& model);

// All do nothing without a record, and leave the selection where there is no such step.
void stepForward(WindowModel& model);
void stepBack(WindowModel& model);
void stepFirst(WindowModel& model);
void stepLast(WindowModel& model);
bool stepToNext(WindowModel& model, StepSearch search, int direction = 1);  // true: there was one; else a message says that there is none
void selectStepAt(WindowModel& model, uint32_t step);                       // the last one when there are fewer

// Selects the next (1) or previous (-1) ray in the order of the rays table, and shows its steps.
void nextRay(WindowModel& model, int direction);

// Plays the steps from the selected one, from the first when that is the last; or stops.
void togglePlay(WindowModel& model);

// While WindowModel::followStep holds, the camera goes along with the selected step: at another step it looks at its start.
void followStep(WindowModel& model);

// Goes on with the play when its time has come. `due`: when the next step is; the caller keeps it.
void advancePlay(WindowModel& model, double& due);

}  // namespace gridscope
