// See grid.h: the door to the fixed-capacity grid.
#include "core/grid/grid.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/grid/slots.h"

namespace gridscope {

namespace {

// Where a word lies.
struct WordPlace {
  ivec3 cell;
  int slot;  // at and beyond the capacity: what the cell refused
};

WordPlace placeOf(const GridParameters& grid, size_t word) {
  const ivec3 count = gridTexelCount(grid);
  ivec3 place(int(word % count.x), int(word / count.x % count.y), int(word / (size_t(count.x) * count.y)));
  const int slot = place[grid.stretchAxis] % grid.stride;
  place[grid.stretchAxis] /= grid.stride;
  return {place, slot};
}

}  // namespace

Grid makeEmptyGrid(const GridParameters& parameters) {
  Grid grid{parameters, std::vector<uint32_t>(gridWordCount(parameters), kBlank)};
  forRanges(size_t(parameters.cellCount.z), 8, [&](size_t begin, size_t end) {
    SlotWriter slots(grid);
    forCellsOfLayers(parameters, int(begin), int(end), [&](ivec3 cell) {
      for (int slot = parameters.capacity; slot < parameters.stride; ++slot) slots.slotStore(gridTexel(parameters, cell, slot), 0);
    });
  });
  return grid;
}

CellFacts cellFacts(const Grid& grid, ivec3 cell) {
  const GridParameters& parameters = grid.parameters;
  CellReader reader(grid);
  CellFacts facts{.cell = cell, .id = idOfCell(parameters, cell)};
  facts.stored = uint32_t(reader.listLength(parameters, cellList(parameters, cell)));
  if (parameters.reserved == 2) {
    facts.staticRefused = reader.slotLoad(gridRefusedTexel(parameters, cell, false));
    facts.dynamicRefused = reader.slotLoad(gridRefusedTexel(parameters, cell, true));
    facts.refused = facts.staticRefused + facts.dynamicRefused;
  }
  if (parameters.reserved == 1) facts.refused = reader.slotLoad(gridRefusedTexel(parameters, cell, false)) != 0 ? 1 : 0;
  facts.saturated = parameters.reserved == 0 ? int(facts.stored) == parameters.capacity
                                             : facts.staticRefused != 0 || facts.dynamicRefused != 0 || facts.refused != 0;
  return facts;
}

std::vector<uint32_t> storedIn(const Grid& grid, ivec3 cell) {
  if (!gridContains(grid.parameters, cell)) return {};
  CellReader reader(grid);
  const CellList list = cellList(grid.parameters, cell);
  std::vector<uint32_t> references(size_t(reader.listLength(grid.parameters, list)));
  for (size_t i = 0; i < references.size(); ++i) references[i] = reader.listReference(grid.parameters, list, int(i));
  return references;
}

bool cellOccupied(const Grid& grid, ivec3 cell) {
  return CellReader(grid).listReference(grid.parameters, cellList(grid.parameters, cell), 0) != kNoReference;
}

ivec3 cellOfId(const GridParameters& grid, uint32_t id) {
  const uint32_t x = uint32_t(grid.cellCount.x), y = uint32_t(grid.cellCount.y);
  return ivec3(int(id % x), int(id / x % y), int(id / x / y));
}

Bounds cellBox(const GridParameters& grid, ivec3 cell) {
  Bounds box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = gridFace(grid, axis, cell[axis]);
    box.high[axis] = gridFace(grid, axis, cell[axis] + 1);
  }
  return box;
}

GridAbilities gridAbilities(const GridParameters& grid) {
  const bool counts = grid.reserved == 2;
  return {.built = counts, .updated = counts, .countsRefusals = counts, .notesRefusals = grid.reserved >= 1};
}

std::string gridText(const GridParameters& grid) {
  return printed("%d x %d x %d cells of %.4g, capacity %d", grid.cellCount.x, grid.cellCount.y, grid.cellCount.z, double(grid.cellEdge),
                 grid.capacity);
}

std::string storageText(const GridParameters& grid) { return printed("stretched along %c", "xyz"[grid.stretchAxis]); }

StorageFacts storageFacts(const GridParameters& grid) {
  return {.extent = gridTexelCount(grid), .stretchedAxis = "xyz"[grid.stretchAxis], .wordsPerCell = grid.stride};
}

std::string refusalText(const GridParameters& grid) { return printed("%d reserved texels a cell", grid.reserved); }

bool storedAlike(const GridParameters& a, const GridParameters& b) {
  return a.cellCount == b.cellCount && a.stride == b.stride && a.capacity == b.capacity && a.stretchAxis == b.stretchAxis;
}

std::vector<GridArray> gridArrays(const GridParameters& grid) {
  const ivec3 count = gridTexelCount(grid);
  return {{"grid", {uint64_t(count.z), uint64_t(count.y), uint64_t(count.x)}, 0, gridWordCount(grid)}};
}

uint64_t gridWordCount(const GridParameters& grid) {
  const ivec3 count = gridTexelCount(grid);
  return uint64_t(count.x) * uint64_t(count.y) * uint64_t(count.z);
}

uint64_t gridByteCount(const GridParameters& grid) { return gridWordCount(grid) * sizeof(uint32_t); }

std::string wordText(const GridParameters& grid, size_t word) {
  const WordPlace place = placeOf(grid, word);
  if (place.slot < grid.capacity) return cellText(place.cell) + ", slot " + std::to_string(place.slot);
  return cellText(place.cell) + (place.slot == grid.capacity ? ", static refused" : ", dynamic refused");
}

ivec3 cellOfWord(const GridParameters& grid, size_t word) { return placeOf(grid, word).cell; }

bool wordIsReference(const GridParameters& grid, size_t word) { return placeOf(grid, word).slot < grid.capacity; }

std::string cellText(ivec3 cell) {
  return "cell (" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ", " + std::to_string(cell.z) + ")";
}

}  // namespace gridscope
