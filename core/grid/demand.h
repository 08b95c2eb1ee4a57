// Which references every cell was asked to take: what the overlap test lets through, stored or refused. The grid alone keeps the first few.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/grid/grid.h"
#include "core/scene/numbering.h"

namespace gridscope {

class Demand {
 public:
  Demand() = default;  // of no cells: nothing is wanted

  // Runs the overlap test of every triangle, on all cores. Takes 4 bytes a tried reference and 8 a cell. worldTriangles: of all instances.
  Demand(const GridParameters& grid, const NumberedScene& scene, std::span<const Triangle> worldTriangles);

  // Rising references that a cell was asked to take; empty outside the grid.
  std::span<const uint32_t> wanted(ivec3 cell) const;
  bool wants(ivec3 cell, uint32_t reference) const;
  uint64_t total() const { return references_.size(); }

 private:
  GridParameters grid_{};
  std::vector<uint64_t> first_;  // of a cell (x fastest) in references_; one more at the end
  std::vector<uint32_t> references_;
};

// What a cell was asked to take and refused, rising: where it is full and says so, what it does not hold. A cell with room refused nothing.
std::vector<uint32_t> refusedBy(const Grid& grid, const Demand& demand, ivec3 cell);

}  // namespace gridscope
