// A grid in memory, and the door to it: what its cells hold, what it can do, its arrays. How it is stored only core/grid knows.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "shaders/shared/grid/grid.h"

namespace gridscope {

struct Grid {
  GridParameters parameters{};
  std::vector<uint32_t> words;  // its arrays (gridArrays), one after another; empty: there is no grid

  bool empty() const { return words.empty(); }
};

// Every cell empty, nothing refused.
Grid makeEmptyGrid(const GridParameters& parameters);

// --- Cells

// What a cell holds, as far as it can be told.
struct CellFacts {
  ivec3 cell{0};                // (i, j, k)
  uint32_t id = 0;              // opaque; cellOfId() leads back
  uint32_t stored = 0;          // references in its list
  uint32_t staticRefused = 0;   // of grids that count refusals (GridAbilities)
  uint32_t dynamicRefused = 0;  // likewise
  uint32_t refused = 0;         // both together; 1 where a grid says only that something was refused; 0 where it says nothing
  bool saturated = false;       // it refused one or more; where the grid says nothing: its list is full

  uint32_t tried() const { return stored + refused; }
  bool operator==(const CellFacts&) const = default;
};

// Of a cell of the grid.
CellFacts cellFacts(const Grid& grid, ivec3 cell);

// A cell's references, in the order in which a ray is shown them. Empty outside the grid.
std::vector<uint32_t> storedIn(const Grid& grid, ivec3 cell);

bool cellOccupied(const Grid& grid, ivec3 cell);

// A cell's number: x fastest, then y, then z. Lists with an element a cell are in this order.
inline uint32_t idOfCell(const GridParameters& grid, ivec3 cell) { return cellNumber(grid, cell); }
ivec3 cellOfId(const GridParameters& grid, uint32_t id);

Bounds cellBox(const GridParameters& grid, ivec3 cell);  // world

// Calls visit(cell) for every cell of layers [beginZ, endZ), by rising id.
template <typename Visit>
void forCellsOfLayers(const GridParameters& grid, int beginZ, int endZ, Visit visit) {
  ivec3 cell;
  for (cell.z = beginZ; cell.z < endZ; ++cell.z)
    for (cell.y = 0; cell.y < grid.cellCount.y; ++cell.y)
      for (cell.x = 0; cell.x < grid.cellCount.x; ++cell.x) visit(cell);
}

// Calls visit(CellFacts) for every cell, by rising id.
template <typename Visit>
void forCells(const Grid& grid, Visit visit) {
  forCellsOfLayers(grid.parameters, 0, grid.parameters.cellCount.z, [&](ivec3 cell) { visit(cellFacts(grid, cell)); });
}

// --- The whole

// What can be done with a grid of these parameters. One from elsewhere can be traced and looked at, whatever it is.
struct GridAbilities {
  bool built = false;           // this program builds such grids
  bool updated = false;         // and takes dynamic references out and in
  bool countsRefusals = false;  // it says of every cell how many references it refused
  bool notesRefusals = false;   // it says of every cell at least whether it refused any
};
GridAbilities gridAbilities(const GridParameters& grid);

std::string gridText(const GridParameters& grid);     // "12 x 34 x 56 cells of 0.25, capacity 32"
std::string storageText(const GridParameters& grid);  // "stretched along x"
// How a cell lies in the storage, for people who look at it.
struct StorageFacts {
  ivec3 extent;        // of the image, words along x, y and z
  char stretchedAxis;  // 'x', 'y' or 'z': a cell's words lie along it
  int wordsPerCell;
};
StorageFacts storageFacts(const GridParameters& grid);

std::string refusalText(const GridParameters& grid);  // how refusals are kept: "2 reserved texels a cell"

// Are both stored alike, so that words of one mean the same in the other?
bool storedAlike(const GridParameters& a, const GridParameters& b);

// --- Arrays: what a capture holds of a grid

struct GridArray {
  const char* name;             // "grid": of the array in a capture
  std::vector<uint64_t> shape;  // slowest first, of 32-bit words
  uint64_t first;               // word in Grid::words
  uint64_t count;               // words
};
std::vector<GridArray> gridArrays(const GridParameters& grid);
uint64_t gridWordCount(const GridParameters& grid);

// Bytes of all arrays.
uint64_t gridByteCount(const GridParameters& grid);

// A word's place: "cell (1, 2, 3), slot 4". The cell that it belongs to.
std::string wordText(const GridParameters& grid, size_t word);
ivec3 cellOfWord(const GridParameters& grid, size_t word);

// Does the word hold a reference (or the mark of none)? The others hold counts.
bool wordIsReference(const GridParameters& grid, size_t word);

// "cell (1, 2, 3)".
std::string cellText(ivec3 cell);

}  // namespace gridscope
