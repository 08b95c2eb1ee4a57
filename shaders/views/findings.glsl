// What was found out about the frame, for views. What was not given reads as nothing found: its binding is too short.
#include "shaders/shared/grid/findings.h"
#include "shaders/shared/views/truth_colours.h"

layout(scalar, set = 0, binding = kBindTruths) readonly buffer TruthsBuffer { RayTruth truths[]; };
layout(scalar, set = 0, binding = kBindTriangleCosts) readonly buffer TriangleCostsBuffer { uint triangleCosts[]; };
layout(scalar, set = 0, binding = kBindCellRays) readonly buffer CellRaysBuffer { CellRays cellRays[]; };
layout(scalar, set = 0, binding = kBindStableCells) readonly buffer StableCellsBuffer { uint stableCells[]; };
layout(scalar, set = 0, binding = kBindStableRays) readonly buffer StableRaysBuffer { uint stableRays[]; };
layout(scalar, set = 0, binding = kBindCellUpdates) readonly buffer CellUpdatesBuffer { CellUpdate cellUpdates[]; };

RayTruth truthOf(uint pixel) {
  if (pixel < uint(truths.length())) return truths[pixel];
  RayTruth none;
  none.verdict = kVerdictNoRay;
  none.cause = kCauseNone;
  none.exactT = 0.0;
  none.exactReference = kNoReference;
  none.error = 0.0;
  none.cell = ivec3(-1);
  none.reference = kNoReference;
  none.segment = -1;
  return none;
}

// Rays lost to a reference's triangle.
uint costOf(uint reference) {
  uint triangle = instances[referenceInstance(reference)].firstWorldTriangle + referenceTriangle(reference);
  return triangle < uint(triangleCosts.length()) ? triangleCosts[triangle] : 0u;
}

CellRays raysOf(ivec3 cell) {
  uint number = cellNumber(gridParameters(), cell);
  if (number < uint(cellRays.length())) return cellRays[number];
  return CellRays(0u, 0u);
}

uint stabilityOf(ivec3 cell) {
  uint number = cellNumber(gridParameters(), cell);
  return number < uint(stableCells.length()) ? stableCells[number] : kStable;
}

bool rayChanges(uint pixel) { return pixel < uint(stableRays.length()) && stableRays[pixel] != 0u; }

CellUpdate updateOf(ivec3 cell) {
  uint number = cellNumber(gridParameters(), cell);
  if (number < uint(cellUpdates.length())) return cellUpdates[number];
  return CellUpdate(0u, 0u, 0u, kNoReference);
}

// A cell that an update touched, in its instance's colour: filled as it is, only cleared hatched, what it held before dim.
ViewElement updateElement(CellUpdate update, uvec2 pixel) {
  vec3 colour = idColour(update.instance);
  if (update.filled == 0u) colour *= update.cleared == 0u ? 0.3 : hatchLine(pixel) ? 0.4 : 1.0;
  return colourElement(colour);
}
