// See limits.h.
#include "core/gpu/grid/limits.h"

#include <algorithm>

namespace gridscope {

GridLimits gridLimits(const DeviceReport& report) {
  GridLimits limits;
  limits.maxImageSide = report.maxImageSide;
  limits.maxImageBytes = std::min(report.maxImageBytes, report.maxAllocationBytes);
  limits.maxMemoryBytes = report.deviceMemoryBytes;
  limits.device = report.name.c_str();
  return limits;
}

}  // namespace gridscope
