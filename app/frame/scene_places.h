// Where things are in the grid: what a cell holds and refused, which cells hold and refused a triangle, what the ledger has on them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/frame/snapshot.h"

namespace gridscope {

struct CellContents {
  std::vector<uint32_t> stored;                    // references in slot order
  std::vector<uint32_t> refused;                   // rising; empty when not known
  bool refusedKnown = false;                       // the demand is there
  uint32_t refusedCount = 0;                       // as the grid counts; 1 where it only flags
  uint32_t staticRefused = 0, dynamicRefused = 0;  // of a grid that counts them
  bool saturated = false;
};
CellContents cellContents(const FrameSnapshot& frame, const ivec3& cell);

// Cells of a triangle, x fastest.
struct TriangleCells {
  std::vector<ivec3> stored;
  std::vector<ivec3> refused;  // empty when not known
  bool refusedKnown = false;
};
TriangleCells cellsOfTriangle(const FrameSnapshot& frame, uint32_t reference);

// The ledger's line on something; null where there is none, or no ledger.
const CellLoss* lossOf(const Ledger* ledger, const GridParameters& grid, const ivec3& cell);
const TriangleLoss* lossOf(const Ledger* ledger, uint32_t reference);
const GroupLoss* lossOfInstance(const Ledger* ledger, uint32_t sceneInstance);

// The next pixel behind `from` whose cause took place in a cell; going around.
std::optional<uint32_t> nextRayOfCell(const FrameSnapshot& frame, const ivec3& cell, std::optional<uint32_t> from);

// The next pixel behind `from` that should have hit a triangle and does not agree; going around.
std::optional<uint32_t> nextRayOfTriangle(const FrameSnapshot& frame, uint32_t reference, std::optional<uint32_t> from);

float triangleArea(const Triangle& triangle);  // world units squared

}  // namespace gridscope
