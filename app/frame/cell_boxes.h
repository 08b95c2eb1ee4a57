// Which cells' boxes are drawn over the viewport, by what they are chosen and coloured, and their edges: each once, however many boxes share
// it, cut at the clip box.
#pragma once

#include <span>
#include <vector>

#include "app/frame/find_next.h"
#include "app/frame/projection.h"
#include "app/frame/showing.h"

namespace gridscope {

struct BoxCell {
  CellFacts full;
  CellRays rays{};  // 0 until they were counted
};

// What a box can stand for. Overlays::boxMeasure is a place in the list; the first one is shown at first.
struct BoxMeasure {
  const char* name;  // "references tried"
  uint32_t (*value)(const BoxCell& cell);
  bool byCapacity;  // colours span 0 to the capacity; else to the highest value but the top hundredth
  bool ofRays;      // not known before the rays were counted
};
std::span<const BoxMeasure> boxMeasures();
const BoxMeasure& boxMeasure(const Overlays& overlays);

// All cells that hold or refused a reference, or that a ray asked, x fastest. `rays`: of all cells, x fastest; may be empty.
std::vector<BoxCell> occupiedCells(const Grid& grid, std::span<const CellRays> rays);

// The value at the end of the colours.
float boxTop(const BoxMeasure& measure, std::span<const BoxCell> occupied, int capacity);

struct BoxChoice {
  std::vector<BoxCell> cells;  // nearest first
  size_t wanted = 0;           // before the limit
};

// The cells in view whose boxes the overlays ask for: those nearest to the eye, at most `most`.
BoxChoice chooseBoxes(std::span<const BoxCell> occupied, const GridParameters& grid, const Overlays& overlays,
                      const CameraParameters& camera, size_t most);

// An edge of the grid's lattice.
struct BoxEdge {
  WorldLine line;
  uint32_t value = 0;      // the highest of the cells that it belongs to
  bool saturated = false;  // of any of them
};
std::vector<BoxEdge> boxEdgesOf(std::span<const BoxCell> cells, const GridParameters& grid, const BoxMeasure& measure);

}  // namespace gridscope
