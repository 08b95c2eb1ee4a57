// A grid in memory: the texels as the 3D image holds them (x fastest, then y, then z).
#pragma once

#include <cstdint>
#include <vector>

#include "shaders/shared/grid.h"

namespace gridscope {

struct Grid {
  GridParameters parameters{};
  std::vector<uint32_t> texels;   // gridTexelCount(parameters): x fastest

  size_t index(ivec3 texel) const {
    ivec3 count = gridTexelCount(parameters);
    return (size_t(texel.z) * count.y + texel.y) * count.x + texel.x;
  }
  uint32_t& at(ivec3 texel) { return texels[index(texel)]; }
  uint32_t at(ivec3 texel) const { return texels[index(texel)]; }
};

// All slots blank, all reserved texels zero.
Grid makeEmptyGrid(const GridParameters& parameters);

}  // namespace gridscope
