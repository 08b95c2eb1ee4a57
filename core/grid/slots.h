// A grid's slots in plain memory: the functions that shaders/shared/grid/insert.h and traverse.h ask their includer for.
#pragma once

#include <algorithm>

#include "core/grid/grid.h"

namespace gridscope {

// What a trace needs. Texel coordinates are not checked.
class SlotReader {
 public:
  explicit SlotReader(const Grid& grid)
      : texels_(grid.texels.data()), sideX_(gridTexelCount(grid.parameters).x), sideY_(gridTexelCount(grid.parameters).y) {}

  uint slotLoad(ivec3 texel) const { return texels_[index(texel)]; }

 protected:
  size_t index(ivec3 texel) const { return (size_t(texel.z) * sideY_ + size_t(texel.y)) * sideX_ + size_t(texel.x); }

 private:
  const uint32_t* texels_;
  size_t sideX_, sideY_;
};

// What an insertion needs. Not atomic: one thread at a time may touch a cell.
class SlotWriter : public SlotReader {
 public:
  explicit SlotWriter(Grid& grid) : SlotReader(grid), texels_(grid.texels.data()) {}

  uint slotMin(ivec3 texel, uint value) {
    uint& slot = texels_[index(texel)];
    const uint old = slot;
    slot = std::min(old, value);
    return old;
  }
  uint slotSwap(ivec3 texel, uint expect, uint value) {
    uint& slot = texels_[index(texel)];
    const uint old = slot;
    if (old == expect) slot = value;
    return old;
  }
  void slotStore(ivec3 texel, uint value) { texels_[index(texel)] = value; }
  void slotCount(ivec3 texel) { ++texels_[index(texel)]; }

 private:
  uint32_t* texels_;
};

}  // namespace gridscope
