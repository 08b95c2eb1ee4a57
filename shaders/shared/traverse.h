// How a ray walks the grid: cell-sized segments (the paper's), or every cell it pierces. Written once; the fast, the counting, the
// recording and the C++ version differ only in what their includer defines:
//   uint slotLoad(ivec3 texel), and what alpha.h asks for, and Triangle loadWorldTriangle(uint index)
//   what should happen, each a macro that may be left out and is gone after the include:
//     ON_SEGMENT(segment, start, cell, outcome)  a segment was begun; outcome: kStep...
//     ON_TEST(slot, reference, test, alphaByte)  a reference was tested
//     ON_CELL(stored, saturated, travel)         a cell's references are done; travel: the value that the gate compares
// No include guard: C++ includes it inside a class that has these functions.
// Sources: Abdollah-shamshir-saz, Hybrid Ray/Voxel-Tracing Fixed Capacity Grids, 2020; Amanatides and Woo, A Fast Voxel Traversal
// Algorithm for Ray Tracing, 1987.

#ifndef ON_SEGMENT
#define ON_SEGMENT(segment, start, cell, outcome)
#endif
#ifndef ON_TEST
#define ON_TEST(slot, reference, test, alphaByte)
#endif
#ifndef ON_CELL
#define ON_CELL(stored, saturated, travel)
#endif

#include "alpha.h"

// Nearest hit among a cell's references.
struct CellHit {
  float t;
  uint reference;      // kBlank: none
  uint lastReference;  // the last one encountered: what a voxel hit reports
  int stored;          // references read
  bool cut;            // the loop ended without a reason
};

SHARED Hit missedHit(uint kind) {
  Hit hit;
  hit.kind = kind;
  hit.t = 0.0f;
  hit.reference = kBlank;
  hit.u = 0.0f;
  hit.v = 0.0f;
  return hit;
}

SHARED Triangle loadReferenced(uint reference) {
  return loadWorldTriangle(loadInstance(referenceInstance(reference)).firstWorldTriangle + referenceTriangle(reference));
}

SHARED Hit triangleHit(Ray ray, float t, uint reference) {
  vec2 weights = barycentrics(loadReferenced(reference), rayPoint(ray, t));
  Hit hit;
  hit.kind = kHitTriangle;
  hit.t = t;
  hit.reference = reference;
  hit.u = weights.x;
  hit.v = weights.y;
  return hit;
}

SHARED Hit voxelHit(Ray ray, float t, uint reference) {
  vec2 weights = clampedBarycentrics(loadReferenced(reference), rayPoint(ray, t));
  Hit hit;
  hit.kind = kHitVoxel;
  hit.t = t;
  hit.reference = reference;
  hit.u = weights.x;
  hit.v = weights.y;
  return hit;
}

// Tests every reference of a cell, whose first is `reference`, and keeps the nearest of `best` and the hits within [low, high]. Of
// equal distances the smaller reference wins.
SHARED CellHit queryCell(GridParameters grid, Ray ray, ivec3 cell, uint reference, CellHit best, vec2 window) {
  ivec3 texel = gridTexel(grid, cell, 0);
  int slot = 0;
  for (; slot < grid.capacity; ++slot) {
    texel[grid.stretchAxis] = cell[grid.stretchAxis] * grid.stride + slot;
    reference = slotLoad(texel);
    if (reference == kBlank) break;

    Triangle triangle = loadReferenced(reference);
    TriangleTest test = testTriangle(ray, triangle, window.x, window.y);
    uint alphaByte = 256u;
    if (test.verdict == kTestHit) {
      if (test.t > best.t || (test.t == best.t && reference > best.reference)) {
        test.verdict = kTestFarther;
      } else if (!alphaPasses(reference, triangle, rayPoint(ray, test.t), alphaByte)) {
        test.verdict = kTestAlpha;
      } else {
        best.t = test.t;
        best.reference = reference;
      }
    }
    ON_TEST(slot, reference, test, alphaByte);
    best.lastReference = reference;
  }
  best.stored = slot;
  best.cut = slot < grid.capacity && reference != kBlank;
  return best;
}

// Did the cell refuse references? Only a full one can have.
SHARED bool cellSaturated(GridParameters grid, ivec3 cell, int storedCount) {
  if (storedCount < grid.capacity) return false;
  if (grid.reserved == 0) return true;
  if (slotLoad(gridTexel(grid, cell, grid.capacity)) != 0u) return true;
  return grid.reserved == 2 && slotLoad(gridTexel(grid, cell, grid.capacity + 1)) != 0u;
}

// Narrows [low, high] of a ray's parameter to one axis' pair of grid faces. Quotients in double: only for rays from outside.
SHARED void clipToFaces(float origin, float direction, float faceLow, float faceHigh, INOUT(vec2) range) {
  if (abs(direction) < kTiny) {
    if (origin < faceLow || origin > faceHigh) range = vec2(kFar, -kFar);
    return;
  }
  float first = divide(faceLow - origin, direction);
  float second = divide(faceHigh - origin, direction);
  range.x = max(range.x, min(first, second));
  range.y = min(range.y, max(first, second));
}

// Where a ray is inside the grid: parameters of entry and exit; x > y when it never meets it.
SHARED vec2 gridSpan(GridParameters grid, Ray ray) {
  vec2 range = vec2(0.0f, kFar);
  clipToFaces(ray.origin.x, ray.direction.x, gridFace(grid, 0, 0), gridFace(grid, 0, grid.cellCount.x), range);
  clipToFaces(ray.origin.y, ray.direction.y, gridFace(grid, 1, 0), gridFace(grid, 1, grid.cellCount.y), range);
  clipToFaces(ray.origin.z, ray.direction.z, gridFace(grid, 2, 0), gridFace(grid, 2, grid.cellCount.z), range);
  return range;
}

// The first segment of a ray (x) and the last that may still lie outside the grid without the ray having left it (y). x > y + 1 never
// happens for a ray that starts inside: (0, -1). A ray that never meets the grid gets (0, -2).
SHARED ivec2 segmentSpan(GridParameters grid, Ray ray) {
  if (gridContains(grid, gridCell(grid, ray.origin))) return ivec2(0, -1);
  vec2 span = gridSpan(grid, ray);
  if (span.x > span.y || span.x > 1e8f * grid.cellEdge) return ivec2(0, -2);
  int first = int(floor(divide(span.x, grid.cellEdge)));
  int last = int(floor(divide(min(span.y, 1e8f * grid.cellEdge), grid.cellEdge)));
  return ivec2(first, last);
}

SHARED TraceState traceBegin() {
  TraceState state;
  state.segment = -1;
  state.cell = ivec3(-2, -2, -2);
  state.enter = 0.0f;
  state.t = kFar;
  state.reference = kBlank;
  return state;
}

// Takes at most segmentsPerPass segments; returns kHitUnfinished, with `state` saying where to go on, when there are more.
SHARED Hit traceSegments(GridParameters grid, TraceParameters trace, Ray ray, INOUT(TraceState) state) {
  ivec2 span = segmentSpan(grid, ray);
  if (span.y == -2) return missedHit(kHitMiss);
  if (state.segment < 0) state.segment = span.x;
  float climb = dotExact(ray.direction, ray.launchNormal);

  uint taken = 0u;
  for (; taken < trace.segmentsPerPass; ++taken) {
    int segment = state.segment;
    if (uint(segment - span.x) >= trace.maxSegments) return missedHit(kHitLimit);
    state.segment = segment + 1;

    // The cell that holds the segment's start. Once inside, the first start outside ends the ray.
    float start = float(segment) * grid.cellEdge;
    ivec3 cell = gridCell(grid, rayPoint(ray, start));
    if (!gridContains(grid, cell)) {
      ON_SEGMENT(segment, start, cell, kStepOutside);
      if (segment > span.y) return missedHit(kHitMiss);
      continue;
    }

    // Skip the cell visited last.
    if (cell == state.cell) {
      ON_SEGMENT(segment, start, cell, kStepRevisit);
      continue;
    }
    state.cell = cell;

    // Most cells are empty: one read.
    uint reference = slotLoad(gridTexel(grid, cell, 0));
    if (reference == kBlank) {
      ON_SEGMENT(segment, start, cell, kStepEmpty);
      continue;
    }
    ON_SEGMENT(segment, start, cell, kStepRead);

    // Test all its references against the elongated segment.
    CellHit best;
    best.t = kFar;
    best.reference = kBlank;
    vec2 window = vec2(max(trace.tMin, start - trace.back), start + trace.ahead);
    best = queryCell(grid, ray, cell, reference, best, window);
    if (best.cut) return missedHit(kHitCut);

    // A saturated cell without a hit may have lost the triangle: fill the gap, once the launching surface's cells are left behind.
    bool saturated = cellSaturated(grid, cell, best.stored);
    float travel = start * climb;
    ON_CELL(best.stored, saturated, travel);
    if (best.reference != kBlank) return triangleHit(ray, best.t, best.reference);
    if (saturated && trace.gapFill != 0u && travel > trace.gate)
      return voxelHit(ray, start + 0.5f * grid.cellEdge, best.lastReference);
  }
  return missedHit(taken == trace.segmentsPerPass ? kHitUnfinished : kHitCut);
}

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

// Visits every cell the ray pierces, keeps the nearest hit of all their references and ends when the walk has passed it: accepting hits
// inside the cell alone would open cracks at cell faces, where floors and walls lie.
SHARED Hit traceCells(GridParameters grid, TraceParameters trace, Ray ray, INOUT(TraceState) state) {
  if (state.segment < 0 && !beginWalk(grid, ray, state)) return missedHit(kHitMiss);
  vec3 inverse = vec3(inverseOrZero(ray.direction.x), inverseOrZero(ray.direction.y), inverseOrZero(ray.direction.z));
  float climb = dotExact(ray.direction, ray.launchNormal);

  uint taken = 0u;
  for (; taken < trace.segmentsPerPass; ++taken) {
    ivec3 cell = state.cell;
    if (!gridContains(grid, cell)) {
      ON_SEGMENT(state.segment, state.enter, cell, kStepOutside);
      if (state.reference != kBlank) return triangleHit(ray, state.t, state.reference);
      return missedHit(kHitMiss);
    }
    if (uint(state.segment) >= trace.maxSegments) return missedHit(kHitLimit);

    // Where the ray leaves the cell, and through which face.
    vec3 exits = vec3(cellExit(grid, ray, 0, cell.x, inverse.x), cellExit(grid, ray, 1, cell.y, inverse.y),
                      cellExit(grid, ray, 2, cell.z, inverse.z));
    int axis = exits.x <= exits.y ? (exits.x <= exits.z ? 0 : 2) : (exits.y <= exits.z ? 1 : 2);
    float leave = exits[axis];

    uint reference = slotLoad(gridTexel(grid, cell, 0));
    if (reference == kBlank) {
      ON_SEGMENT(state.segment, state.enter, cell, kStepEmpty);
    } else {
      ON_SEGMENT(state.segment, state.enter, cell, kStepRead);
      CellHit best;
      best.t = state.t;
      best.reference = state.reference;
      best = queryCell(grid, ray, cell, reference, best, vec2(trace.tMin, kFar));
      if (best.cut) return missedHit(kHitCut);
      state.t = best.t;
      state.reference = best.reference;

      // As for segments; the gate compares where the ray entered.
      bool saturated = cellSaturated(grid, cell, best.stored);
      float travel = state.enter * climb;
      ON_CELL(best.stored, saturated, travel);
      if (saturated && best.reference == kBlank && trace.gapFill != 0u && travel > trace.gate)
        return voxelHit(ray, 0.5f * (state.enter + leave), best.lastReference);
    }
    if (state.reference != kBlank && state.t <= leave) return triangleHit(ray, state.t, state.reference);

    // Step through that face.
    state.cell[axis] = cell[axis] + (ray.direction[axis] > 0.0f ? 1 : -1);
    state.enter = max(leave, 0.0f);
    state.segment = state.segment + 1;
  }
  return missedHit(taken == trace.segmentsPerPass ? kHitUnfinished : kHitCut);
}

SHARED Hit traceRay(GridParameters grid, TraceParameters trace, Ray ray, INOUT(TraceState) state) {
  if (ray.valid == 0u) return missedHit(kHitNoRay);
  if (trace.traversal == kTraversalDda) return traceCells(grid, trace, ray, state);
  return traceSegments(grid, trace, ray, state);
}

#undef ON_SEGMENT
#undef ON_TEST
#undef ON_CELL
