// Which step of a recorded ray comes next of a kind.
#pragma once

#include <cstdint>
#include <optional>

#include "core/trace/trace.h"

namespace gridscope {

// What "run to the next" looks for.
enum class StepSearch {
  nonEmpty,   // the segment starts in a cell that holds references; read, or skipped as the cell visited last
  tested,     // references were tested
  saturated,  // the cell refused references
  revisit,    // the segment starts in the cell visited last
  voxelHit    // the ray ends there with a voxel hit
};

// The first such step after `from` (direction 1) or before it (-1); nothing: there is none.
std::optional<uint32_t> nextStep(const RayRecord& record, uint32_t from, StepSearch search, int direction = 1);

// Why a search from the selected step found none, one sentence.
const char* noSuchStep(StepSearch search, int direction = 1);

}  // namespace gridscope
