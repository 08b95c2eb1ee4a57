// How a ray walks the grid: cell-sized segments (the paper's), or every cell it pierces. Written once; the fast, the counting, the
// recording and the C++ version differ only in what their includer defines:
//   uint slotLoad(ivec3 texel), and what alpha.h asks for, and Triangle loadWorldTriangle(uint index)
//   what should happen, each a macro that may be left out and is gone after the include:
//     ON_SEGMENT(segment, start, cell, outcome)  a segment was begun; outcome: kStep...
//     ON_TEST(slot, reference, test, alphaByte)  a reference was tested
//     ON_CELL(stored, saturated, travel)         a cell's references are done; travel: the value that the gate compares
//   what a trace may do differently (core/truth/edits.cpp takes events away with these), each a macro that may be left out, changes nothing
//   then, and is gone after the include:
//     SLOT_COUNT(cell)                           slots that are read of a cell
//     SLOT_LOAD(cell, slot)                      the reference that a slot shows
//     SLOTS_STORED(cell, count)                  of the references read, how many the cell holds
//     QUERY_WINDOW(cell, window)                 where along the ray a segment's query accepts hits
//     ALPHA_PASSES(reference, passes)            does alpha keying let a hit through?
//     EDIT_CELL_HIT(state, best)                 a cell's nearest hit is known: a statement
//     GATE_OPEN(cell, open)                      may the cell's gap be filled?
//     REVISIT_SKIPS(segment, skips)              is a segment skipped, its cell being the one visited last?
//     INSERT_SEGMENT(segment, state, found)      a segment is next: statements, which may return another one, found, before it
// No include guard: C++ includes it inside a class that has these functions.
// Sources: Abdollah-shamshir-saz, Hybrid Ray/Voxel-Tracing Fixed Capacity Grids, 2020; Amanatides and Woo, A Fast Voxel Traversal
// Algorithm for Ray Tracing, 1987.

#ifndef ON_SEGMENT
#define ON_SEGMENT(segment, start, cell, outcome)
#endif
#ifdef ON_TEST
#define TESTS_WATCHED true
#else
#define TESTS_WATCHED false
#define ON_TEST(slot, reference, test, alphaByte)
#endif
#ifndef ON_CELL
#define ON_CELL(stored, saturated, travel)
#endif

#ifndef SLOT_COUNT
#define SLOT_COUNT(cell) grid.capacity
#endif
#ifndef SLOT_LOAD
#define SLOT_LOAD(cell, slot) slotLoad(gridTexel(grid, cell, slot))
#endif
#ifndef SLOTS_STORED
#define SLOTS_STORED(cell, count) count
#endif
#ifndef QUERY_WINDOW
#define QUERY_WINDOW(cell, window) window
#endif
#ifndef ALPHA_PASSES
#define ALPHA_PASSES(reference, passes) passes
#endif
#ifndef EDIT_CELL_HIT
#define EDIT_CELL_HIT(state, best)
#endif
#ifndef GATE_OPEN
#define GATE_OPEN(cell, open) (open)
#endif
#ifndef REVISIT_SKIPS
#define REVISIT_SKIPS(segment, skips) (skips)
#endif
#ifndef INSERT_SEGMENT
#define INSERT_SEGMENT(segment, state, found)
#endif

#include "shaders/shared/trace/alpha.h"

// Nearest hit among a cell's references.
struct CellHit {
  float t;
  uint reference;      // kBlank: none
  uint lastReference;  // the last one encountered: what a voxel hit reports
  int stored;          // references read
  bool cut;            // the loop ended without a reason
};

SHARED Hit makeHit(uint kind, float t, uint reference) {
  Hit hit;
  hit.kind = kind;
  hit.t = t;
  hit.reference = reference;
  hit.u = 0.0f;
  hit.v = 0.0f;
  return hit;
}

SHARED Hit missedHit(uint kind) { return makeHit(kind, 0.0f, kBlank); }

SHARED Triangle loadReferenced(uint reference) {
  return loadWorldTriangle(loadInstance(referenceInstance(reference)).firstWorldTriangle + referenceTriangle(reference));
}

// Adds the barycentrics. Behind the loops, not in them: a group of invocations that run together pays for it once.
SHARED Hit finishHit(Ray ray, Hit hit) {
  if (hit.kind != kHitTriangle && hit.kind != kHitVoxel) return hit;
  Triangle triangle = loadReferenced(hit.reference);
  vec3 point = rayPoint(ray, hit.t);
  vec2 weights = hit.kind == kHitVoxel ? clampedBarycentrics(triangle, point) : barycentrics(triangle, point);
  hit.u = weights.x;
  hit.v = weights.y;
  return hit;
}

// Tests every reference of a cell and keeps the nearest of `best` and the hits within `window` (low, high). Of equal distances the
// smaller reference wins. keyed: alpha may turn hits down.
SHARED CellHit testCell(GridParameters grid, Ray ray, ivec3 cell, CellHit best, vec2 window, bool keyed) {
  uint reference = kBlank;
  int slot = 0;
  for (; slot < SLOT_COUNT(cell); ++slot) {
    reference = SLOT_LOAD(cell, slot);
    if (reference == kBlank) break;

    Triangle triangle = loadReferenced(reference);
    TriangleTest test = testTriangle(ray, triangle, window.x, window.y);
    uint alphaByte = 256u;
    if (test.verdict == kTestHit) {
      if (test.t > best.t || (test.t == best.t && reference > best.reference)) {
        test.verdict = kTestFarther;
      } else if (keyed && !ALPHA_PASSES(reference, alphaPasses(reference, triangle, rayPoint(ray, test.t), alphaByte))) {
        test.verdict = kTestAlpha;
      } else {
        best.t = test.t;
        best.reference = reference;
      }
    }
    ON_TEST(slot, reference, test, alphaByte);
    best.lastReference = reference;
  }
  best.stored = SLOTS_STORED(cell, slot);
  best.cut = slot < SLOT_COUNT(cell) && reference != kBlank;
  return best;
}

// The same with alpha keying. What alpha keying loads stays out of the first loop: only where the nearest triangle is keyed, all are tested
// again with it. Where tests are watched, once is enough.
SHARED CellHit queryCell(GridParameters grid, Ray ray, ivec3 cell, CellHit best, vec2 window) {
  bool keyed = TESTS_WATCHED;
  CellHit nearest = best;
  if (!TESTS_WATCHED) {
    nearest = testCell(grid, ray, cell, best, window, false);
    if (nearest.reference != best.reference) {
      uint material = loadInstance(referenceInstance(nearest.reference)).material;
      keyed = (loadMaterial(material).flags & kMaterialAlphaKeyed) != 0u;
    }
  }
  if (keyed) nearest = testCell(grid, ray, cell, best, window, true);
  return nearest;
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

// A segment whose cell has references, or why there is none.
struct FoundSegment {
  uint kind;    // kHitTriangle: found; otherwise how the ray ends, or kHitUnfinished after segmentsPerPass segments
  float start;  // along the ray
};

// Takes segments until one starts in a cell that holds references: most are empty, and cost one read.
SHARED FoundSegment nextSegment(GridParameters grid, TraceParameters trace, Ray ray, ivec2 span, INOUT(TraceState) state,
                                INOUT(uint) taken) {
  FoundSegment found;
  found.kind = kHitUnfinished;
  found.start = 0.0f;
  while (taken < trace.segmentsPerPass) {
    taken += 1u;
    int segment = state.segment;
    INSERT_SEGMENT(segment, state, found)
    if (uint(segment - span.x) >= trace.maxSegments) {
      found.kind = kHitLimit;
      return found;
    }
    state.segment = segment + 1;

    // The cell that holds the segment's start. Once inside, the first start outside ends the ray.
    found.start = float(segment) * grid.cellEdge;
    ivec3 cell = gridCell(grid, rayPoint(ray, found.start));
    if (!gridContains(grid, cell)) {
      ON_SEGMENT(segment, found.start, cell, kStepOutside);
      if (segment <= span.y) continue;
      found.kind = kHitMiss;
      return found;
    }

    // Skip the cell visited last.
    if (REVISIT_SKIPS(segment, cell == state.cell)) {
      ON_SEGMENT(segment, found.start, cell, kStepRevisit);
      continue;
    }
    state.cell = cell;
    if (SLOT_LOAD(cell, 0) == kBlank) {
      ON_SEGMENT(segment, found.start, cell, kStepEmpty);
      continue;
    }
    ON_SEGMENT(segment, found.start, cell, kStepRead);
    found.kind = kHitTriangle;
    return found;
  }
  if (taken != trace.segmentsPerPass) found.kind = kHitCut;
  return found;
}

// Takes at most segmentsPerPass segments; returns kHitUnfinished, with `state` saying where to go on, when there are more.
SHARED Hit traceSegments(GridParameters grid, TraceParameters trace, Ray ray, INOUT(TraceState) state) {
  ivec2 span = segmentSpan(grid, ray);
  if (span.y == -2) return missedHit(kHitMiss);
  if (state.segment < 0) state.segment = span.x;
  float climb = dotExact(ray.direction, ray.launchNormal);

  uint taken = 0u;
  while (taken <= trace.segmentsPerPass) {
    FoundSegment found = nextSegment(grid, trace, ray, span, state, taken);
    if (found.kind != kHitTriangle) return missedHit(found.kind);

    // Test the cell's references against the elongated segment.
    CellHit best;
    best.t = kFar;
    best.reference = kBlank;
    best = queryCell(grid, ray, state.cell, best,
                     QUERY_WINDOW(state.cell, vec2(max(trace.tMin, found.start - trace.back), found.start + trace.ahead)));
    if (best.cut) return missedHit(kHitCut);
    EDIT_CELL_HIT(state, best)

    // A saturated cell without a hit may have lost the triangle: fill the gap, once the launching surface's cells are left behind.
    bool saturated = cellSaturated(grid, state.cell, best.stored);
    float travel = found.start * climb;
    ON_CELL(best.stored, saturated, travel);
    if (best.reference != kBlank) return makeHit(kHitTriangle, best.t, best.reference);
    if (saturated && trace.gapFill != 0u && GATE_OPEN(state.cell, travel > trace.gate))
      return makeHit(kHitVoxel, found.start + 0.5f * grid.cellEdge, best.lastReference);
  }
  return missedHit(kHitCut);
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

// Walks until a cell holds references: kHitTriangle. Otherwise how the walk ends (kHitMiss also when it has passed the nearest hit), or
// kHitUnfinished after segmentsPerPass cells.
SHARED uint nextCell(GridParameters grid, TraceParameters trace, Ray ray, vec3 inverse, INOUT(TraceState) state, INOUT(uint) taken) {
  while (taken < trace.segmentsPerPass) {
    taken += 1u;
    if (!gridContains(grid, state.cell) || (state.reference != kBlank && state.t <= state.enter)) {
      if (!gridContains(grid, state.cell)) {
        ON_SEGMENT(state.segment, state.enter, state.cell, kStepOutside);
      }
      return kHitMiss;
    }
    if (uint(state.segment) >= trace.maxSegments) return kHitLimit;
    if (SLOT_LOAD(state.cell, 0) != kBlank) {
      ON_SEGMENT(state.segment, state.enter, state.cell, kStepRead);
      return kHitTriangle;
    }
    ON_SEGMENT(state.segment, state.enter, state.cell, kStepEmpty);
    int axis;
    float leave = leaveCell(grid, ray, state.cell, inverse, axis);
    enterNext(ray, axis, leave, state);
  }
  return taken == trace.segmentsPerPass ? kHitUnfinished : kHitCut;
}

// Visits every cell the ray pierces, keeps the nearest hit of all their references and ends when the walk has passed it: accepting hits
// inside the cell alone would open cracks at cell faces, where floors and walls lie.
SHARED Hit traceCells(GridParameters grid, TraceParameters trace, Ray ray, INOUT(TraceState) state) {
  if (state.segment < 0 && !beginWalk(grid, ray, state)) return missedHit(kHitMiss);
  vec3 inverse = vec3(inverseOrZero(ray.direction.x), inverseOrZero(ray.direction.y), inverseOrZero(ray.direction.z));
  float climb = dotExact(ray.direction, ray.launchNormal);

  uint taken = 0u;
  while (taken <= trace.segmentsPerPass) {
    uint found = nextCell(grid, trace, ray, inverse, state, taken);
    if (found == kHitMiss && state.reference != kBlank) return makeHit(kHitTriangle, state.t, state.reference);
    if (found != kHitTriangle) return missedHit(found);

    CellHit best;
    best.t = state.t;
    best.reference = state.reference;
    best = queryCell(grid, ray, state.cell, best, vec2(trace.tMin, kFar));
    if (best.cut) return missedHit(kHitCut);
    EDIT_CELL_HIT(state, best)
    state.t = best.t;
    state.reference = best.reference;

    // As for segments; the gate compares where the ray entered.
    bool saturated = cellSaturated(grid, state.cell, best.stored);
    float travel = state.enter * climb;
    ON_CELL(best.stored, saturated, travel);
    int axis;
    float leave = leaveCell(grid, ray, state.cell, inverse, axis);
    if (saturated && best.reference == kBlank && trace.gapFill != 0u && GATE_OPEN(state.cell, travel > trace.gate))
      return makeHit(kHitVoxel, 0.5f * (state.enter + leave), best.lastReference);
    if (state.reference != kBlank && state.t <= leave) return makeHit(kHitTriangle, state.t, state.reference);
    enterNext(ray, axis, leave, state);
  }
  return missedHit(kHitCut);
}

SHARED Hit traceRay(GridParameters grid, TraceParameters trace, Ray ray, INOUT(TraceState) state) {
  if (ray.valid == 0u) return missedHit(kHitNoRay);
  if (trace.traversal == kTraversalDda) return finishHit(ray, traceCells(grid, trace, ray, state));
  return finishHit(ray, traceSegments(grid, trace, ray, state));
}

#undef ON_SEGMENT
#undef ON_TEST
#undef ON_CELL
#undef TESTS_WATCHED
#undef SLOT_COUNT
#undef SLOT_LOAD
#undef SLOTS_STORED
#undef QUERY_WINDOW
#undef ALPHA_PASSES
#undef EDIT_CELL_HIT
#undef GATE_OPEN
#undef REVISIT_SKIPS
#undef INSERT_SEGMENT
