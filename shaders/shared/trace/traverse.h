// How a ray walks the grid: cell-sized segments (the paper's), or every cell it pierces. Written once; the fast, the counting, the
// recording and the C++ version differ only in what their includer has:
//   what cell.h of the grid, and alpha.h, ask for, and Triangle loadWorldTriangle(uint index)
//   what should happen, each a macro that may be left out and is gone after the include:
//     ON_SEGMENT(segment, start, cell, outcome)  a segment was begun; outcome: kStep...
//     ON_TEST(place, reference, test, alphaByte) a reference, at a place of its cell's list, was tested
//     ON_CELL(stored, saturated, travel)         a cell's references are done; travel: the value that the gate compares
//   and, to trace by other rules, what trace_rules.h names.
// Read it in this order: segments.h (the paper's walk), cell_test.h (one cell), dda.h (the other walk), trace_rules.h.
// No include guard: C++ includes it inside a class that has these functions.

#ifndef ON_SEGMENT
#define ON_SEGMENT(segment, start, cell, outcome)
#endif
#ifdef ON_TEST
#define TESTS_WATCHED true
#else
#define TESTS_WATCHED false
#define ON_TEST(place, reference, test, alphaByte)
#endif
#ifndef ON_CELL
#define ON_CELL(stored, saturated, travel)
#endif

#include "shaders/shared/trace/alpha.h"
#include "shaders/shared/trace/trace_rules.h"

#include "shaders/shared/trace/cell_test.h"
#include "shaders/shared/trace/grid_span.h"

#include "shaders/shared/trace/dda.h"
#include "shaders/shared/trace/segments.h"

SHARED TraceState traceBegin() {
  TraceState state;
  state.segment = -1;
  state.cell = ivec3(-2, -2, -2);
  state.enter = 0.0f;
  state.t = kFar;
  state.reference = kNoReference;
  return state;
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
#undef OWN_TRACE_RULES
