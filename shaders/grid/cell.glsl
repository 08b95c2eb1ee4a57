// What one cell of the grid holds and refused, for views.

// References stored in a cell, and those that it refused (cell.h).
uint cellStored(ivec3 cell) { return uint(listLength(gridParameters(), cellList(gridParameters(), cell))); }
uint cellRefused(ivec3 cell, uint storedCount) { return cellRefused(gridParameters(), cell, int(storedCount)); }

// A cell as an element: the references it stores, marked when it refused some.
ViewElement occupancyElement(ivec3 cell) {
  uint storedCount = cellStored(cell);
  float value = float(storedCount);
  return cellRefused(cell, storedCount) != 0u ? markedElement(value) : valueElement(value);
}

bool cellHolds(ivec3 cell, uint reference) {
  CellList list = cellList(gridParameters(), cell);
  for (int place = 0; place < list.most; ++place) {
    uint held = listReference(gridParameters(), list, place);
    if (held == reference) return true;
    if (held == kNoReference) return false;
  }
  return false;
}

// The cell of a surface point. On a cell's face, where floors and walls like to lie, rounding decides which of the two neighbours holds the
// triangle: of the point's own cell and those a hair on either side of the surface, the first that holds it; its own when none does.
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
