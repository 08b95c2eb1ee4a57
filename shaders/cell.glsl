// What one cell of the grid holds and refused, for views.

// References stored in a cell: the slots before the first blank.
uint cellStored(ivec3 cell) {
  int slot = 0;
  while (slot < parameters.grid.capacity && slotLoad(gridTexel(parameters.grid, cell, slot)) != kBlank) ++slot;
  return uint(slot);
}

// References a cell refused. A grid with fewer than two reserved texels does not count: then 1 stands for one or more.
uint cellRefused(ivec3 cell, uint storedCount) {
  if (parameters.grid.reserved == 0) return storedCount == uint(parameters.grid.capacity) ? 1u : 0u;
  uint refused = slotLoad(gridRefusedTexel(parameters.grid, cell, false));
  if (parameters.grid.reserved == 1) return refused != 0u ? 1u : 0u;
  return refused + slotLoad(gridRefusedTexel(parameters.grid, cell, true));
}

// A cell as an element: the references it stores, marked when it refused some.
ViewElement occupancyElement(ivec3 cell) {
  uint storedCount = cellStored(cell);
  float value = float(storedCount);
  return cellRefused(cell, storedCount) != 0u ? markedElement(value) : valueElement(value);
}

// The cell of the surface seen at a pixel. A surface may lie on a cell's face: the point is moved into the surface by a thousandth of
// a cell, so that rounding does not decide.
ivec3 surfaceCell(GatherPixel surface) {
  return gridCell(parameters.grid, surface.position - surface.geometricNormal * (1e-3 * parameters.grid.cellEdge));
}
