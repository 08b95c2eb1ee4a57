// Build and update in C++: the reference that every device must equal bit for bit, and the path of `--device cpu`.
// Source: Abdollah-shamshir-saz, Hybrid Ray/Voxel-Tracing Fixed Capacity Grids, 2020, sections 2.1 and 2.2.
#pragma once

#include <span>
#include <vector>

#include "core/grid/grid.h"
#include "core/scene/numbering.h"

namespace gridscope {

// Instances [begin, end).
struct InstanceRange {
  uint32_t begin = 0;
  uint32_t end = 0;
};

// Writes the world triangles of the instances. worldTriangles: scene.triangleCount entries.
void transformTriangles(const NumberedScene& scene, InstanceRange instances, std::span<Triangle> worldTriangles);

// Inserts the instances' world triangles into the grid, in rising order of reference.
BuildReport insertInstances(const NumberedScene& scene, InstanceRange instances, std::span<const Triangle> worldTriangles, Grid& grid);

// Build: a grid of the static instances.
Grid buildGrid(const GridParameters& parameters, const NumberedScene& scene, std::span<Triangle> worldTriangles, BuildReport& report);

// What an update did.
struct UpdateReport {
  BuildReport added{};        // for `moved`: of the moved instances and of the rebuilt cells
  uint32_t cellsRebuilt = 0;  // cells whose dynamic part was rebuilt from all dynamic instances (`moved`)
  uint32_t cellsTouched = 0;  // cells that moved instances left or entered (`moved`); all cells for `all`
};

// Update, all: clears every dynamic reference and counter, then adds all dynamic instances again.
UpdateReport updateAll(const NumberedScene& scene, std::span<Triangle> worldTriangles, Grid& grid);

// Update, moved: clears the references of the moved instances, closes the gaps in order, adds them again, and rebuilds the dynamic part of
// every cell among those they left or entered that had refused dynamic references; a cell that begins to refuse gets the same bits without
// (update.cpp says why). The same bits as updateAll() for sorted insertion.
// `moved`: rising instance numbers, all dynamic. On entry worldTriangles hold the previous transforms, on return the present ones.
UpdateReport updateMoved(const NumberedScene& scene, std::span<const uint32_t> moved, std::span<Triangle> worldTriangles, Grid& grid);

}  // namespace gridscope
