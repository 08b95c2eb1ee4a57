// What a trace does at the places where an edited one does otherwise: core/truth/edits.cpp takes events away by functions of its own with these
// names, and says so with OWN_TRACE_RULES. No include guard: C++ includes it inside a class.
#ifndef OWN_TRACE_RULES

// What a ray is shown of a cell.
SHARED CellList shownList(GridParameters grid, ivec3 cell) { return cellList(grid, cell); }
SHARED uint shownReference(GridParameters grid, CellList list, int place) { return listReference(grid, list, place); }

// Of the references shown, how many the cell holds.
SHARED int heldCount(ivec3, int shownCount) { return shownCount; }

// Where along the ray the query of a segment's cell accepts hits: low, high.
SHARED vec2 queryWindow(GridParameters, Ray, ivec3, vec2 window) { return window; }

// Does alpha keying let a hit through, when the map says `passes`?
SHARED bool keyingPasses(uint, bool passes) { return passes; }

// Does a cell's nearest hit count?
SHARED bool hitCounts(ivec3) { return true; }

// May a cell's gap be filled, when the gate says `open`?
SHARED bool gateOpen(ivec3, bool open) { return open; }

// Is a segment skipped, when its cell is the one visited last?
SHARED bool revisitSkips(int, bool visitedLast) { return visitedLast; }

// Does another segment come before this one, with its cell in `state` and its start? Called until it says no.
SHARED bool segmentInserted(GridParameters, int, INOUT(TraceState), INOUT(float)) { return false; }

#endif
