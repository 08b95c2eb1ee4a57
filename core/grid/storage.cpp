// See storage.h.
#include "core/grid/storage.h"

#include "shaders/shared/grid/layout.h"

namespace gridscope {

GridStorage gridStorage(const GridParameters& grid) { return {"grid", gridTexelCount(grid)}; }

std::map<uint32_t, uint32_t> gridConstants(const GridParameters& grid) {
  return {{kConstantOverlap, grid.overlap},
          {kConstantInsertion, grid.insertion},
          {kConstantStretchAxis, uint32_t(grid.stretchAxis)},
          {kConstantReserved, uint32_t(grid.reserved)}};
}

}  // namespace gridscope
