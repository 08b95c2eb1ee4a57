// Which cells' boxes are drawn over the viewport, and their edges: each once, however many boxes share it, cut at the clip box.
#pragma once

#include <span>
#include <vector>

#include "app/find_next.h"
#include "app/projection.h"
#include "app/window_model.h"

namespace gridscope {

// All cells that hold or refused a reference, x fastest.
std::vector<FullCell> occupiedCells(const Grid& grid);

struct BoxChoice {
  std::vector<FullCell> cells;         // nearest first
  size_t wanted = 0;                   // before the limit
};

// The cells in view whose boxes the overlays ask for: those nearest to the eye, at most `most`.
BoxChoice chooseBoxes(std::span<const FullCell> occupied, const GridParameters& grid, const Overlays& overlays, const CameraParameters& camera, size_t most);

// An edge of the grid's lattice.
struct BoxEdge {
  WorldLine line;
  uint32_t tried = 0;                  // of the fullest cell that it belongs to
  bool saturated = false;              // of any of them
};
std::vector<BoxEdge> boxEdgesOf(std::span<const FullCell> cells, const GridParameters& grid);

}  // namespace gridscope
