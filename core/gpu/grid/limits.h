// How large a grid a device can hold.
#pragma once

#include "core/gpu/context.h"
#include "core/grid/derive.h"

namespace gridscope {

// `report` must outlive the limits, which name the device.
GridLimits gridLimits(const DeviceReport& report);

}  // namespace gridscope
