// Insertion of references into a grid. The includer defines, before including this:
//   uint slotMin(ivec3 texel, uint value)             atomic minimum, returns the old value
//   uint slotSwap(ivec3 texel, uint expect, uint value)  atomic compare and swap, returns the old value
//   uint slotLoad(ivec3 texel)                        plain read
//   void slotCount(ivec3 texel)                       atomic add of 1
//   INSERT_INTO(cell)                                 a macro that may be left out and is gone after the include: false for cells to leave alone
// No include guard: C++ includes it inside a class that has these functions.

#ifndef INSERT_INTO
#define INSERT_INTO(cell) true
#endif

// How the insertion of one reference ended.
struct InsertResult {
  uint stored;
  uint refused;
  uint cut;  // the slot loop ended without a reason: the driver cut it short
};

SHARED InsertResult makeInsertResult(uint storedCount, uint refusedCount, uint cut) {
  InsertResult result;
  result.stored = storedCount;
  result.refused = refusedCount;
  result.cut = cut;
  return result;
}

// A walk over the slots ended at `slot` without finding room for `reference`: counted as refused, unless it was cut short.
SHARED InsertResult refuseReference(GridParameters grid, ivec3 cell, uint reference, int slot) {
  if (slot != grid.capacity) return makeInsertResult(0u, 0u, 1u);
  if (grid.reserved == 2) slotCount(gridRefusedTexel(grid, cell, reference >= firstDynamicReference(grid)));
  return makeInsertResult(0u, 1u, 0u);
}

// Sorted: whatever the order of arrival, slot k ends with the k-th smallest reference, and a full cell keeps the smallest: the larger
// value is carried on. What is refused may be another reference than the one that came.
SHARED InsertResult insertSorted(GridParameters grid, ivec3 cell, uint reference) {
  // A full cell whose last reference is smaller will refuse this one: slots only ever fall, so a plain read is safe.
  int slot = slotLoad(gridTexel(grid, cell, grid.capacity - 1)) < reference ? grid.capacity : 0;
  for (; slot < grid.capacity; ++slot) {
    uint old = slotMin(gridTexel(grid, cell, slot), reference);
    if (old == kBlank) return makeInsertResult(1u, 0u, 0u);
    reference = max(old, reference);
  }
  return refuseReference(grid, cell, reference, slot);
}

// First come, first served: the paper's. Which references a full cell keeps depends on the race.
SHARED InsertResult insertFirstCome(GridParameters grid, ivec3 cell, uint reference) {
  int slot = 0;
  for (; slot < grid.capacity; ++slot)
    if (slotSwap(gridTexel(grid, cell, slot), kBlank, reference) == kBlank) return makeInsertResult(1u, 0u, 0u);
  return refuseReference(grid, cell, reference, slot);
}

SHARED InsertResult insertReference(GridParameters grid, ivec3 cell, uint reference) {
  if (grid.insertion == kInsertionSorted) return insertSorted(grid, cell, reference);
  return insertFirstCome(grid, cell, reference);
}

// Offers a triangle to the cells [begin, end) of its range and adds what happened to the report.
SHARED void insertTriangle(GridParameters grid, Triangle triangle, uint reference, CellRange range, uvec2 part, INOUT(BuildReport) report) {
  vec3 normal = triangleNormal(triangle);
  for (uint index = part.x; index < part.y; ++index) {
    ivec3 cell = cellRangeCell(range, index);
    report.cellsWalked += 1u;
    if (!(INSERT_INTO(cell))) continue;
    if (!cellTakesTriangle(grid, triangle, normal, cell)) continue;
    InsertResult result = insertReference(grid, cell, reference);
    report.tried += 1u;
    report.stored += result.stored;
    report.refused += result.refused;
    report.loopsCut += result.cut;
  }
}

#undef INSERT_INTO
