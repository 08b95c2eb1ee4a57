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

bool cellHolds(ivec3 cell, uint reference) {
  for (int slot = 0; slot < gridParameters().capacity; ++slot) {
    uint held = slotLoad(gridTexel(gridParameters(), cell, slot));
    if (held == reference) return true;
    if (held == kBlank) return false;
  }
  return false;
}

// The cell of a surface point. On a cell's face, where floors and walls like to lie, rounding decides which of the two neighbours holds the
// triangle: of the point's own cell and those a hair behind and before the surface, the first that holds it; its own when none does.
ivec3 surfaceCell(GatherPixel surface) {
  vec3 hair = surface.geometricNormal * (1e-3 * gridParameters().cellEdge);
  ivec3 own = gridCell(gridParameters(), surface.position);
  ivec3 cell = own;
  for (int side = 0; side < 3; ++side) {
    if (gridContains(gridParameters(), cell) && cellHolds(cell, surface.reference)) return cell;
    cell = gridCell(gridParameters(), side == 0 ? surface.position - hair : surface.position + hair);
  }
  return own;
}
