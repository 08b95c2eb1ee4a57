// What one cell of the grid holds and refused, for views.

// References stored in a cell: the slots before the first blank.
uint cellStored(ivec3 cell) {
  int slot = 0;
  while (slot < gridParameters().capacity && slotLoad(gridTexel(gridParameters(), cell, slot)) != kBlank) ++slot;
  return uint(slot);
}

// References a cell refused. A grid with fewer than two reserved texels does not count: then 1 stands for one or more.
uint cellRefused(ivec3 cell, uint storedCount) {
  if (gridParameters().reserved == 0) return storedCount == uint(gridParameters().capacity) ? 1u : 0u;
  uint refused = slotLoad(gridRefusedTexel(gridParameters(), cell, false));
  if (gridParameters().reserved == 1) return refused != 0u ? 1u : 0u;
  return refused + slotLoad(gridRefusedTexel(gridParameters(), cell, true));
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
  return gridCell(gridParameters(), surface.position - surface.geometricNormal * (1e-3 * gridParameters().cellEdge));
}
