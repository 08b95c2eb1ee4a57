// From settings to the parameters of trace and camera: every derived constant is computed here, once, and passed on as bits.
#pragma once

#include "core/trace/settings.h"
#include "shaders/shared/trace/frame.h"

namespace gridscope {

// Throws Error for numbers out of range.
TraceParameters deriveTrace(const TraceSettings& settings, const GridParameters& grid);

// Camera axes from a pose; a pose that looks straight along `up` is turned a little. Throws Error when eye and target coincide.
CameraParameters deriveCamera(const CameraPose& pose, uint32_t width, uint32_t height, float sceneDiagonal);

}  // namespace gridscope
