// The lists of triangles whose boxes have too many cells for one invocation.
layout(scalar, set = 0, binding = kBindBigTriangles) buffer BigTrianglesBuffer { uint bigTriangles[]; };
layout(scalar, set = 0, binding = kBindBigDispatch) buffer BigDispatchBuffer { BigDispatch bigDispatch; };

uint bigClassInvocations(int bigClass) { return kBigGroupSize << (3 * bigClass); }

// The first class whose invocations each get few cells; the last takes the rest.
int bigClassOf(uint cellCount) {
  int bigClass = 0;
  while (bigClass < kBigClassCount - 1 && cellCount > kBigCells * bigClassInvocations(bigClass)) ++bigClass;
  return bigClass;
}

void appendBig(uint worldTriangle, uint cellCount) {
  int bigClass = bigClassOf(cellCount);
  uint place = atomicAdd(bigDispatch.counts[bigClass], 1u);
  bigTriangles[uint(bigClass) * gridParameters().triangleCount + place] = worldTriangle;
}

bool isBig(uint cellCount) { return cellCount > min(kSmallCells, gridParameters().cellsPerInvocation); }

// Offers a triangle to its cells, or appends it to a list. Counts what the box asks for.
void insertOrAppend(Triangle triangle, uint reference, uint worldTriangle, inout BuildReport report) {
  bool degenerate = triangleDegenerate(triangleNormal(triangle));
  CellRange range = triangleCells(gridParameters(), triangle);
#if OPERATION != OPERATION_MARK
  report.degenerate += degenerate ? 1u : 0u;
  report.outside += range.clipped && !degenerate ? 1u : 0u;
#endif
  if (degenerate) return;
  uint cellCount = cellRangeCount(range);
  report.cellsExpected += cellCount;
  if (isBig(cellCount)) appendBig(worldTriangle, cellCount);
  else walkCells(triangle, reference, range, uvec2(0u, cellCount), report);
}
