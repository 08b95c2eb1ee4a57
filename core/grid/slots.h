// A grid's slots in plain memory: what shaders/shared/grid/insert.h and cell.h ask their includer for. For the grid's own room, and for traces
// through CellReader.
#pragma once

#include <algorithm>

#include "core/grid/grid.h"
#include "shaders/shared/grid/layout.h"

namespace gridscope {

// Texel coordinates are not checked.
class SlotReader {
 public:
  explicit SlotReader(const Grid& grid)
      : words_(grid.words.data()), sideX_(gridTexelCount(grid.parameters).x), sideY_(gridTexelCount(grid.parameters).y) {}

  uint slotLoad(ivec3 texel) const { return words_[index(texel)]; }

 protected:
  size_t index(ivec3 texel) const { return (size_t(texel.z) * sideY_ + size_t(texel.y)) * sideX_ + size_t(texel.x); }

 private:
  const uint32_t* words_;
  size_t sideX_, sideY_;
};

// What a trace needs: the cells' lists.
class CellReader : public SlotReader {
 public:
  using SlotReader::SlotReader;
#include "shaders/shared/grid/cell.h"
};

// What an insertion needs. Not atomic: one thread at a time may touch a cell.
class SlotWriter : public SlotReader {
 public:
  explicit SlotWriter(Grid& grid) : SlotReader(grid), words_(grid.words.data()) {}

  uint slotMin(ivec3 texel, uint value) {
    uint& slot = words_[index(texel)];
    const uint old = slot;
    slot = std::min(old, value);
    return old;
  }
  uint slotSwap(ivec3 texel, uint expect, uint value) {
    uint& slot = words_[index(texel)];
    const uint old = slot;
    if (old == expect) slot = value;
    return old;
  }
  void slotStore(ivec3 texel, uint value) { words_[index(texel)] = value; }
  void slotCount(ivec3 texel) { ++words_[index(texel)]; }

 private:
  uint32_t* words_;
};

}  // namespace gridscope
