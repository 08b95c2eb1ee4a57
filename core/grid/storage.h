// What a grid asks of a device, which runs it without knowing its layout: where its cells lie, and what its passes are specialized by.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "shaders/shared/grid/grid.h"

namespace gridscope {

// One 3D image of 32-bit unsigned words.
struct GridStorage {
  std::string name;
  ivec3 extent{};  // words along x, y and z
  uint64_t wordCount() const { return uint64_t(extent.x) * uint64_t(extent.y) * uint64_t(extent.z); }
};
GridStorage gridStorage(const GridParameters& grid);

// Values of the passes' specialization constants, by their ids: settings that branch inside loops, so that drivers leave the other branch out.
std::map<uint32_t, uint32_t> gridConstants(const GridParameters& grid);

}  // namespace gridscope
