// What a cell holds, read from the grid: the door for everything that does not build. The includer has uint slotLoad(ivec3 texel). No include
// guard: C++ includes it inside a class that has this function.

// The reference at a place of a cell's list, from 0 on; kNoReference: the list ended before. Places from list.most on are not read.
SHARED uint listReference(GridParameters grid, CellList list, int place) { return slotLoad(gridTexel(grid, list.cell, place)); }

// References that a cell holds.
SHARED int listLength(GridParameters grid, CellList list) {
  int length = 0;
  while (length < list.most && listReference(grid, list, length) != kNoReference) ++length;
  return length;
}

// Did the cell refuse references? Only a full one can have. storedCount: of its references.
SHARED bool cellSaturated(GridParameters grid, ivec3 cell, int storedCount) {
  if (storedCount < grid.capacity) return false;
  if (grid.reserved == 0) return true;
  if (slotLoad(gridTexel(grid, cell, grid.capacity)) != 0u) return true;
  return grid.reserved == 2 && slotLoad(gridTexel(grid, cell, grid.capacity + 1)) != 0u;
}

// References that a cell refused. A grid that does not count them: 1 stands for one or more.
SHARED uint cellRefused(GridParameters grid, ivec3 cell, int storedCount) {
  if (grid.reserved == 0) return storedCount == grid.capacity ? 1u : 0u;
  uint refused = slotLoad(gridRefusedTexel(grid, cell, false));
  if (grid.reserved == 1) return refused != 0u ? 1u : 0u;
  return refused + slotLoad(gridRefusedTexel(grid, cell, true));
}
