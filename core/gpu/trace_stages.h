// The trace on the device, and the recording of one ray.
#pragma once

#include "core/gpu/program.h"
#include "core/trace/trace.h"

namespace gridscope {

class TraceStages {
 public:
  explicit TraceStages(GpuPrograms& programs);

  // Allocates rays and what becomes of them.
  void makeTargets(uint64_t rayCount);
  void setParameters(const TraceParameters& trace);

  // Traces the rays [firstRay, endRay); milliseconds of GPU time. counting: counters too. Throws Error (kExitDevice) when a loop was cut short.
  double trace(uint32_t firstRay, uint32_t endRay, bool counting);
  RayRecord record(uint32_t ray);

 private:
  GpuPrograms& programs_;
  TraceParameters trace_{};
};

}  // namespace gridscope
