// Update in C++, in its two ways.
//
// Why `moved` leaves the bits of `all`, cell by cell and whatever the order (sorted insertion): let F be the slots that static references
// leave free. The dynamic part of a cell holds the F smallest references of a set, and counts the rest of the set as refused. For `all` the
// set is every dynamic reference that overlaps the cell now. Where nothing had been refused, the slots hold the whole earlier set: taking the
// moved references out and inserting the new ones makes the present set, and the insertion itself drops and counts what finds no slot.
// Where something had been refused, the slots do not say what: the cell starts from its static part and gets the present set from all dynamic
// instances. A cell that no moved triangle overlapped before or overlaps now has the same set as before and is left alone.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/grid/build.h"
#include "core/grid/candidates.h"
#include "core/grid/slots.h"

namespace gridscope {

namespace {

// kCell... bits of every cell.
class CellMarks {
 public:
  explicit CellMarks(const ivec3& cellCount) : count_(cellCount), marks_(size_t(cellCount.x) * cellCount.y * cellCount.z) {}
  uint8_t& at(const ivec3& cell) { return marks_[(size_t(cell.z) * count_.y + cell.y) * count_.x + cell.x]; }

 private:
  ivec3 count_;
  std::vector<uint8_t> marks_;  // x fastest
};

struct MovedInsert : SlotWriter {
  using SlotWriter::SlotWriter;
#include "shaders/shared/grid/insert.h"
};

// Inserts into rebuilt cells alone.
#define INSERT_INTO(cell) (marks.at(cell) & kCellRebuilt) != 0
struct RestoringInsert : SlotWriter {
  RestoringInsert(Grid& grid, CellMarks& cellMarks) : SlotWriter(grid), marks(cellMarks) {}
  CellMarks& marks;
#include "shaders/shared/grid/insert.h"
};

// Blanks a cell's dynamic references, and forgets those it refused.
void clearDynamic(const GridParameters& grid, SlotWriter& slots, const ivec3& cell) {
  for (int slot = 0; slot < grid.capacity; ++slot) {
    const ivec3 texel = gridTexel(grid, cell, slot);
    const uint reference = slots.slotLoad(texel);
    if (reference == kBlank) break;
    if (reference >= firstDynamicReference(grid)) slots.slotStore(texel, kBlank);
  }
  slots.slotStore(gridRefusedTexel(grid, cell, true), 0);
}

// Takes a cell's references of moved instances out and closes the gaps in order.
void removeMoved(const GridParameters& grid, SlotWriter& slots, const ivec3& cell, const std::vector<bool>& isMoved) {
  int kept = 0;
  for (int slot = 0; slot < grid.capacity; ++slot) {
    const ivec3 texel = gridTexel(grid, cell, slot);
    const uint reference = slots.slotLoad(texel);
    if (reference == kBlank) break;
    slots.slotStore(texel, kBlank);
    if (!isMoved[referenceInstance(reference)]) slots.slotStore(gridTexel(grid, cell, kept++), reference);
  }
}

void markCells(const NumberedScene& scene, std::span<const uint32_t> instances, std::span<const Triangle> worldTriangles,
               const GridParameters& grid, CellMarks& marks) {
  BuildReport notCounted{};
  for (uint32_t i : instances)
    forCandidates(scene, i, worldTriangles, grid, notCounted, [&](const Triangle& triangle, uint32_t, const CellRange& range) {
      const vec3 normal = triangleNormal(triangle);
      for (uint index = 0; index < cellRangeCount(range); ++index) {
        const ivec3 cell = cellRangeCell(range, index);
        if (cellTakesTriangle(grid, triangle, normal, cell)) marks.at(cell) = kCellTouched;
      }
    });
}

// Prepares every touched cell for the insertion: rebuilt ones lose their whole dynamic part, others what moved.
void openCells(Grid& grid, CellMarks& marks, const std::vector<bool>& isMoved, UpdateReport& report) {
  SlotWriter slots(grid);
  forCellsOfLayers(grid.parameters, 0, grid.parameters.cellCount.z, [&](const ivec3& cell) {
    uint8_t& mark = marks.at(cell);
    if (mark == 0) return;
    report.cellsTouched += 1;
    if (slots.slotLoad(gridRefusedTexel(grid.parameters, cell, true)) == 0) {
      removeMoved(grid.parameters, slots, cell, isMoved);
    } else {
      report.cellsRebuilt += 1;
      mark |= kCellRebuilt;
      clearDynamic(grid.parameters, slots, cell);
    }
  });
}

}  // namespace

UpdateReport updateAll(const NumberedScene& scene, std::span<Triangle> worldTriangles, Grid& grid) {
  CHECK(gridAbilities(grid.parameters).updated);
  const GridParameters& parameters = grid.parameters;
  const InstanceRange dynamics{scene.staticInstanceCount, scene.instanceCount()};

  // Clear.
  forRanges(size_t(parameters.cellCount.z), 8, [&](size_t begin, size_t end) {
    SlotWriter slots(grid);
    forCellsOfLayers(parameters, int(begin), int(end), [&](const ivec3& cell) { clearDynamic(parameters, slots, cell); });
  });

  // Add.
  UpdateReport report;
  transformTriangles(scene, dynamics, worldTriangles);
  report.added = insertInstances(scene, dynamics, worldTriangles, grid);
  report.cellsTouched = uint32_t(parameters.cellCount.x) * uint32_t(parameters.cellCount.y) * uint32_t(parameters.cellCount.z);
  return report;
}

UpdateReport updateMoved(const NumberedScene& scene, std::span<const uint32_t> moved, std::span<Triangle> worldTriangles, Grid& grid) {
  CHECK(gridAbilities(grid.parameters).updated);
  std::vector<bool> isMoved(scene.instanceCount());
  for (uint32_t i : moved) {
    CHECK_LE(scene.staticInstanceCount, i);
    CHECK_LT(i, scene.instanceCount());
    isMoved[i] = true;
  }

  // Mark the cells that the moved triangles leave and those that they enter.
  CellMarks marks(grid.parameters.cellCount);
  markCells(scene, moved, worldTriangles, grid.parameters, marks);
  for (uint32_t i : moved) transformTriangles(scene, {i, i + 1}, worldTriangles);
  markCells(scene, moved, worldTriangles, grid.parameters, marks);

  // Take out what moved, or everything dynamic where references had been refused.
  UpdateReport report;
  openCells(grid, marks, isMoved, report);

  // Add the moved instances; the others only to the cells that lost them. In rising order, so that first-come insertion repeats itself too.
  MovedInsert insert(grid);
  RestoringInsert restore(grid, marks);
  for (uint32_t i = scene.staticInstanceCount; i < scene.instanceCount(); ++i) {
    if (!isMoved[i] && report.cellsRebuilt == 0) continue;
    forCandidates(scene, i, worldTriangles, grid.parameters, report.added,
                  [&](const Triangle& triangle, uint32_t reference, const CellRange& range) {
                    const uvec2 whole(0, cellRangeCount(range));
                    if (isMoved[i])
                      insert.insertTriangle(grid.parameters, triangle, reference, range, whole, report.added);
                    else
                      restore.insertTriangle(grid.parameters, triangle, reference, range, whole, report.added);
                  });
  }
  return report;
}

}  // namespace gridscope
