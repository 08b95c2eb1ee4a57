// The paper's traversal: segments of a ray, each a cell edge long, and the cell that holds each segment's start. No include guard: C++
// includes it inside a class.
// Source: Abdollah-shamshir-saz, Hybrid Ray/Voxel-Tracing Fixed Capacity Grids, 2020.

// Segments of a ray.
struct SegmentSpan {
  bool meets;       // the ray meets the grid; otherwise it has none
  int first;        // the segment that it begins with
  int lastOutside;  // up to this one a segment may start outside the grid without the ray having left it; -1: it starts inside
};

SHARED SegmentSpan segmentSpan(GridParameters grid, Ray ray) {
  SegmentSpan segments;
  segments.meets = true;
  segments.first = 0;
  segments.lastOutside = -1;
  if (gridContains(grid, gridCell(grid, ray.origin))) return segments;
  vec2 span = gridSpan(grid, ray);
  segments.meets = !(span.x > span.y || span.x > 1e8f * grid.cellEdge);
  if (!segments.meets) return segments;
  segments.first = int(floor(divide(span.x, grid.cellEdge)));
  segments.lastOutside = int(floor(divide(min(span.y, 1e8f * grid.cellEdge), grid.cellEdge)));
  return segments;
}

// A segment whose cell has references, or why there is none.
struct FoundSegment {
  bool found;
  uint ending;  // where none was found: how the ray ends, or kHitUnfinished after segmentsPerPass segments
  float start;  // along the ray
};

// Takes segments until one starts in a cell that holds references: most are empty, and cost one read.
SHARED FoundSegment nextSegment(GridParameters grid, TraceParameters trace, Ray ray, SegmentSpan span, INOUT(TraceState) state,
                                INOUT(uint) taken) {
  FoundSegment next;
  next.found = false;
  next.ending = kHitUnfinished;
  next.start = 0.0f;
  while (taken < trace.segmentsPerPass) {
    taken += 1u;
    int segment = state.segment;
    next.found = segmentInserted(grid, segment, state, next.start);
    if (next.found) return next;
    if (uint(segment - span.first) >= trace.maxSegments) {
      next.ending = kHitLimit;
      return next;
    }
    state.segment = segment + 1;

    // The cell that holds the segment's start. Once inside, the first start outside ends the ray.
    next.start = float(segment) * grid.cellEdge;
    ivec3 cell = gridCell(grid, rayPoint(ray, next.start));
    if (!gridContains(grid, cell)) {
      ON_SEGMENT(segment, next.start, cell, kStepOutside);
      if (segment <= span.lastOutside) continue;
      next.ending = kHitMiss;
      return next;
    }

    // Skip the cell visited last.
    if (revisitSkips(segment, cell == state.cell)) {
      ON_SEGMENT(segment, next.start, cell, kStepRevisit);
      continue;
    }
    state.cell = cell;
    if (shownReference(grid, shownList(grid, cell), 0) == kNoReference) {
      ON_SEGMENT(segment, next.start, cell, kStepEmpty);
      continue;
    }
    ON_SEGMENT(segment, next.start, cell, kStepRead);
    next.found = true;
    return next;
  }
  if (taken != trace.segmentsPerPass) next.ending = kHitCut;
  return next;
}

// Takes at most segmentsPerPass segments; returns kHitUnfinished, with `state` saying where to go on, when there are more.
SHARED Hit traceSegments(GridParameters grid, TraceParameters trace, Ray ray, INOUT(TraceState) state) {
  SegmentSpan span = segmentSpan(grid, ray);
  if (!span.meets) return missedHit(kHitMiss);
  if (state.segment < 0) state.segment = span.first;
  float climb = dotExact(ray.direction, ray.launchNormal);

  uint taken = 0u;
  while (taken <= trace.segmentsPerPass) {
    FoundSegment next = nextSegment(grid, trace, ray, span, state, taken);
    if (!next.found) return missedHit(next.ending);

    // Test the cell's references against the elongated segment.
    vec2 window = vec2(max(trace.tMin, next.start - trace.back), next.start + trace.ahead);
    CellHit best = askCell(grid, ray, state.cell, nearestSoFar(kFar, kNoReference), queryWindow(grid, ray, state.cell, window));
    if (best.cut) return missedHit(kHitCut);

    // A saturated cell without a hit may have lost the triangle: fill the gap, once the launching surface's cells are left behind.
    bool saturated = cellSaturated(grid, state.cell, best.stored);
    float travel = next.start * climb;
    ON_CELL(best.stored, saturated, travel);
    if (best.reference != kNoReference) return makeHit(kHitTriangle, best.t, best.reference);
    if (saturated && trace.gapFill != 0u && gateOpen(state.cell, travel > trace.gate))
      return makeHit(kHitVoxel, next.start + 0.5f * grid.cellEdge, best.lastReference);
  }
  return missedHit(kHitCut);
}
