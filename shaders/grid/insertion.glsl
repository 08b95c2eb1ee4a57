// Insertion into the grid image, and the report that every workgroup adds to. OPERATION: what a walk over a triangle's cells does.
#define OPERATION_INSERT 0   // insert the reference
#define OPERATION_MARK 1     // mark the cells that take the triangle (update `moved`)
#define OPERATION_RESTORE 2  // insert, but only into cells marked to be rebuilt (update `moved`)

#include "shaders/shared/grid/overlap.h"

layout(scalar, set = 0, binding = kBindBuildReport) buffer BuildReportBuffer { BuildReport buildReport; };
#if OPERATION != OPERATION_INSERT
layout(scalar, set = 0, binding = kBindCellMarks) buffer CellMarksBuffer { uint cellMarks[]; };
#endif

uint slotMin(ivec3 texel, uint value) { return imageAtomicMin(gridImage, texel, value); }
uint slotSwap(ivec3 texel, uint expect, uint value) { return imageAtomicCompSwap(gridImage, texel, expect, value); }
void slotCount(ivec3 texel) { imageAtomicAdd(gridImage, texel, 1u); }

#if OPERATION == OPERATION_RESTORE
#define INSERT_INTO(cell) (cellMarks[cellNumber(gridParameters(), cell)] & kCellRebuilt) != 0u
#endif
#include "shaders/shared/grid/insert.h"

BuildReport emptyReport() { return BuildReport(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u); }

// Walks the cells [part.x, part.y) of a triangle's range.
void walkCells(Triangle triangle, uint reference, CellRange range, uvec2 part, inout BuildReport report) {
#if OPERATION == OPERATION_MARK
  vec3 normal = triangleNormal(triangle);
  for (uint index = part.x; index < part.y; ++index) {
    ivec3 cell = cellRangeCell(range, index);
    report.cellsWalked += 1u;
    if (cellTakesTriangle(gridParameters(), triangle, normal, cell)) atomicOr(cellMarks[cellNumber(gridParameters(), cell)], kCellTouched);
  }
#else
  insertTriangle(gridParameters(), triangle, reference, range, part, report);
#endif
}

void addReport(BuildReport report) {
  if (report.tried != 0u) atomicAdd(buildReport.tried, report.tried);
  if (report.stored != 0u) atomicAdd(buildReport.stored, report.stored);
  if (report.refused != 0u) atomicAdd(buildReport.refused, report.refused);
  if (report.outside != 0u) atomicAdd(buildReport.outside, report.outside);
  if (report.degenerate != 0u) atomicAdd(buildReport.degenerate, report.degenerate);
  if (report.cellsExpected != 0u) atomicAdd(buildReport.cellsExpected, report.cellsExpected);
  if (report.cellsWalked != 0u) atomicAdd(buildReport.cellsWalked, report.cellsWalked);
  if (report.loopsCut != 0u) atomicAdd(buildReport.loopsCut, report.loopsCut);
}
