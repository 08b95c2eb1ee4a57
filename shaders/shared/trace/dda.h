// The uniform-grid walk: every cell that a ray pierces. No include guard: C++ includes it inside a class.
// Source: Amanatides and Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, 1987.

// Parameter at which the ray leaves a cell along one axis; kFar when it runs across that axis.
SHARED float cellExit(GridParameters grid, Ray ray, int axis, int cell, float inverseDirection) {
  if (abs(ray.direction[axis]) < kTiny) return kFar;
  float face = gridFace(grid, axis, ray.direction[axis] > 0.0f ? cell + 1 : cell);
  return (face - ray.origin[axis]) * inverseDirection;
}

SHARED float inverseOrZero(float value) { return abs(value) < kTiny ? 0.0f : divide(1.0f, value); }

// Sets the first cell of a walk; false when the ray never meets the grid.
SHARED bool beginWalk(GridParameters grid, Ray ray, INOUT(TraceState) state) {
  state.segment = 0;
  state.cell = gridCell(grid, ray.origin);
  state.enter = 0.0f;
  if (gridContains(grid, state.cell)) return true;
  vec2 span = gridSpan(grid, ray);
  if (span.x > span.y) return false;
  state.enter = span.x;
  state.cell = clamp(gridCell(grid, rayPoint(ray, span.x)), ivec3(0, 0, 0), grid.cellCount - ivec3(1, 1, 1));
  return true;
}

// Where the ray leaves a cell, and through which axis' face.
SHARED float leaveCell(GridParameters grid, Ray ray, ivec3 cell, vec3 inverse, OUT(int) axis) {
  float x = cellExit(grid, ray, 0, cell.x, inverse.x);
  float y = cellExit(grid, ray, 1, cell.y, inverse.y);
  float z = cellExit(grid, ray, 2, cell.z, inverse.z);
  axis = x <= y ? (x <= z ? 0 : 2) : (y <= z ? 1 : 2);
  return axis == 0 ? x : axis == 1 ? y : z;
}

SHARED void enterNext(Ray ray, int axis, float leave, INOUT(TraceState) state) {
  state.cell[axis] = state.cell[axis] + (ray.direction[axis] > 0.0f ? 1 : -1);
  state.enter = max(leave, 0.0f);
  state.segment = state.segment + 1;
}

// A cell with references, or why there is none.
struct FoundCell {
  bool found;
  uint ending;  // where none was found: how the walk ends (kHitMiss also when it has passed the nearest hit), or kHitUnfinished
};

SHARED FoundCell makeFoundCell(bool found, uint ending) {
  FoundCell next;
  next.found = found;
  next.ending = ending;
  return next;
}

// Walks until a cell holds references, over at most segmentsPerPass cells.
SHARED FoundCell nextCell(GridParameters grid, TraceParameters trace, Ray ray, vec3 inverse, INOUT(TraceState) state, INOUT(uint) taken) {
  while (taken < trace.segmentsPerPass) {
    taken += 1u;
    if (!gridContains(grid, state.cell) || (state.reference != kNoReference && state.t <= state.enter)) {
      if (!gridContains(grid, state.cell)) {
        ON_SEGMENT(state.segment, state.enter, state.cell, kStepOutside);
      }
      return makeFoundCell(false, kHitMiss);
    }
    if (uint(state.segment) >= trace.maxSegments) return makeFoundCell(false, kHitLimit);
    if (shownReference(grid, shownList(grid, state.cell), 0) != kNoReference) {
      ON_SEGMENT(state.segment, state.enter, state.cell, kStepRead);
      return makeFoundCell(true, kHitUnfinished);
    }
    ON_SEGMENT(state.segment, state.enter, state.cell, kStepEmpty);
    int axis;
    float leave = leaveCell(grid, ray, state.cell, inverse, axis);
    enterNext(ray, axis, leave, state);
  }
  return makeFoundCell(false, taken == trace.segmentsPerPass ? kHitUnfinished : kHitCut);
}

// Visits every cell the ray pierces, keeps the nearest hit of all their references and ends when the walk has passed it: accepting hits
// inside the cell alone would open cracks at cell faces, where floors and walls lie.
SHARED Hit traceCells(GridParameters grid, TraceParameters trace, Ray ray, INOUT(TraceState) state) {
  if (state.segment < 0 && !beginWalk(grid, ray, state)) return missedHit(kHitMiss);
  vec3 inverse = vec3(inverseOrZero(ray.direction.x), inverseOrZero(ray.direction.y), inverseOrZero(ray.direction.z));
  float climb = dotExact(ray.direction, ray.launchNormal);

  uint taken = 0u;
  while (taken <= trace.segmentsPerPass) {
    FoundCell next = nextCell(grid, trace, ray, inverse, state, taken);
    if (!next.found && next.ending == kHitMiss && state.reference != kNoReference) return makeHit(kHitTriangle, state.t, state.reference);
    if (!next.found) return missedHit(next.ending);

    CellHit best = askCell(grid, ray, state.cell, nearestSoFar(state.t, state.reference), vec2(trace.tMin, kFar));
    if (best.cut) return missedHit(kHitCut);
    state.t = best.t;
    state.reference = best.reference;

    // As for segments; the gate compares where the ray entered.
    bool saturated = cellSaturated(grid, state.cell, best.stored);
    float travel = state.enter * climb;
    ON_CELL(best.stored, saturated, travel);
    int axis;
    float leave = leaveCell(grid, ray, state.cell, inverse, axis);
    if (saturated && best.reference == kNoReference && trace.gapFill != 0u && gateOpen(state.cell, travel > trace.gate))
      return makeHit(kHitVoxel, 0.5f * (state.enter + leave), best.lastReference);
    if (state.reference != kNoReference && state.t <= leave) return makeHit(kHitTriangle, state.t, state.reference);
    enterNext(ray, axis, leave, state);
  }
  return missedHit(kHitCut);
}
