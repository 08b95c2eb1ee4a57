// See edits.h. Which event is removed by which edit:
//   refused, not inserted, left out, stale  the cell's slots show the reference before those that they hold, or hide it where they hold it;
//                                           what the cell stores and whether it is saturated stays as it was
//   stepped over                            one more segment, from where the ray enters the cell
//   revisit                                 that segment is not skipped
//   segment end                             the window of that cell's queries reaches over the whole stay of the ray in it
//   accepted early                          that cell's hit is not accepted, nor its gap filled
//   gate                                    that cell's gap may be filled
//   filled early                            that cell's gap is not filled
//   outside                                 the triangle is tried where the ray is outside the grid
//   segment limit                           there is none
//   alpha                                   keying decides the other way about that reference
//   self-hit                                another tMin: one at which that reference, if it was too near, counts, or is too near, if it counted
//   numeric                                 nothing
#include "core/truth/edits.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/trace/loads.h"

namespace gridscope {

namespace {

// A cell's slots as a ray is shown them.
struct ShownCell {
  ivec3 cell;
  std::vector<uint32_t> references;
  int stored;  // references that the cell really holds
};

// The removed events, by what they change.
struct Edits {
  std::vector<ShownCell> shown;
  std::vector<ivec3> unfilled;      // filled early
  std::vector<ivec3> unaccepted;    // accepted early
  std::vector<ivec3> opened;        // gate
  std::vector<ivec3> widened;       // segment end
  std::vector<ivec3> inserted;      // stepped over
  std::vector<int32_t> unskipped;   // revisit: segments
  std::vector<uint32_t> outside;    // references
  std::vector<uint32_t> inverted;   // alpha: references
  std::vector<uint32_t> otherTMin;  // self-hit: references
  bool unlimited = false;
};

template <typename Value>
bool contains(const std::vector<Value>& values, const Value& value) {
  return std::ranges::find(values, value) != values.end();
}

ShownCell& showCell(Edits& edits, const Grid& grid, ivec3 cell) {
  const auto found = std::ranges::find(edits.shown, cell, &ShownCell::cell);
  if (found != edits.shown.end()) return *found;
  const std::vector<uint32_t> stored = storedIn(grid, cell);
  edits.shown.push_back({cell, stored, int(stored.size())});
  return edits.shown.back();
}

// Shows a reference that a cell lacks, hides one that it holds.
void toggleReference(Edits& edits, const Grid& grid, const TruthEvent& event) {
  if (!gridContains(grid.parameters, event.cell)) return;
  std::vector<uint32_t>& references = showCell(edits, grid, event.cell).references;
  const auto found = std::ranges::find(references, event.reference);
  if (found == references.end())
    references.insert(references.begin(), event.reference);
  else
    references.erase(found);
}

void addEdit(Edits& edits, const Grid& grid, const TruthEvent& event) {
  switch (event.cause) {
    case kCauseRefused:
    case kCauseNotInserted:
    case kCauseLeftOut:
    case kCauseStale: return toggleReference(edits, grid, event);
    case kCauseSteppedOver: return edits.inserted.push_back(event.cell);
    case kCauseRevisit: return edits.unskipped.push_back(event.segment);
    case kCauseSegmentEnd: return edits.widened.push_back(event.cell);
    case kCauseAcceptedEarly: return edits.unaccepted.push_back(event.cell);
    case kCauseGate: return edits.opened.push_back(event.cell);
    case kCauseFilledEarly: return edits.unfilled.push_back(event.cell);
    case kCauseOutside: return edits.outside.push_back(event.reference);
    case kCauseAlpha: return edits.inverted.push_back(event.reference);
    case kCauseSelfHit: return edits.otherTMin.push_back(event.reference);
    case kCauseSegmentLimit: edits.unlimited = true; return;
    default: return;
  }
}

// The nearest distance that counts, where those references are on its other side.
float otherTMin(const TraceInput& input, const Ray& ray, const Edits& edits) {
  float tMin = input.parameters.tMin;
  for (uint32_t reference : edits.otherTMin) {
    const TriangleTest test = testTriangle(ray, referencedTriangle(input, reference), -kFar, kFar);
    if (test.verdict != kTestHit) continue;
    tMin = test.t < tMin ? test.t : std::nextafter(test.t, kFar);
  }
  return tMin;
}

class EditedTrace : public TraceLoads {
 public:
  EditedTrace(const TraceInput& input, const Ray& ray, const Edits& edits)
      : TraceLoads(input), grid_(input.grid.parameters), edits_(edits) {
    for (const ivec3& cell : edits_.inserted) inserts_.push_back({cell, cellStay(grid_, ray, cell).x, false});
  }

  RayRecord record;

  // The nearest of the outside triangles, where the ray is outside the grid.
  Hit outsideHit(const Ray& ray, float tMin) {
    Hit best = missedHit(kHitMiss);
    for (uint32_t reference : edits_.outside) {
      const Triangle triangle = loadReferenced(reference);
      const TriangleTest test = testTriangle(ray, triangle, tMin, kFar);
      uint alphaByte;
      if (test.verdict != kTestHit || gridContains(grid_, gridCell(grid_, rayPoint(ray, test.t)))) continue;
      if (best.kind == kHitTriangle && test.t >= best.t) continue;
      if (!alphaPasses(reference, triangle, rayPoint(ray, test.t), alphaByte)) continue;
      best = finishHit(ray, makeHit(kHitTriangle, test.t, reference));
    }
    return best;
  }

#define OWN_TRACE_RULES
#include "core/trace/record_hooks.h"
#include "shaders/shared/trace/traverse.h"

 private:
  struct Insert {
    ivec3 cell;
    float start;  // where the ray enters it
    bool done;
  };

  const ShownCell* shownCell(ivec3 cell) const {
    for (const ShownCell& shown : edits_.shown)
      if (shown.cell == cell) return &shown;
    return nullptr;
  }

  // --- The rules of trace_rules.h

  // One more than the references: their end is read too.
  CellList shownList(const GridParameters& grid, ivec3 cell) const {
    CellList list = cellList(grid, cell);
    if (const ShownCell* shown = shownCell(cell)) list.most = int(shown->references.size()) + 1;
    return list;
  }

  uint shownReference(const GridParameters& grid, const CellList& list, int place) {
    const ShownCell* shown = shownCell(list.cell);
    if (!shown) return listReference(grid, list, place);
    return size_t(place) < shown->references.size() ? shown->references[size_t(place)] : kNoReference;
  }

  int heldCount(ivec3 cell, int shownCount) const {
    const ShownCell* shown = shownCell(cell);
    return shown ? shown->stored : shownCount;
  }

  vec2 queryWindow(const GridParameters& grid, const Ray& ray, ivec3 cell, vec2 window) const {
    if (!contains(edits_.widened, cell)) return window;
    const vec2 stay = cellStay(grid, ray, cell);
    const float margin = kAgreement * grid.cellEdge;  // a surface on the cell's face may be met a hair beyond it
    return vec2(std::min(window.x, std::max(stay.x - margin, 0.0f)), std::max(window.y, stay.y + margin));
  }

  bool keyingPasses(uint reference, bool passes) const { return contains(edits_.inverted, reference) != passes; }
  bool hitCounts(ivec3 cell) const { return !contains(edits_.unaccepted, cell); }

  bool gateOpen(ivec3 cell, bool open) const {
    if (contains(edits_.unfilled, cell) || contains(edits_.unaccepted, cell)) return false;
    return open || contains(edits_.opened, cell);
  }

  bool revisitSkips(int segment, bool visitedLast) const { return visitedLast && !contains(edits_.unskipped, segment); }

  // Is one more segment due before the next one? It leaves no trace in the state: the cell visited last comes back with the next segment.
  bool segmentInserted(const GridParameters& grid, int segment, TraceState& state, float& start) {
    if (resumes_) state.cell = resumeCell_;
    resumes_ = false;
    for (Insert& insert : inserts_) {
      if (insert.done || insert.start > float(segment) * grid.cellEdge) continue;
      insert.done = true;
      if (shownReference(grid, shownList(grid, insert.cell), 0) == kNoReference) {
        record.steps.push_back({segment, insert.start, insert.cell, kStepEmpty, {}});
        continue;
      }
      record.steps.push_back({segment, insert.start, insert.cell, kStepRead, {}});
      resumeCell_ = state.cell;
      resumes_ = true;
      state.cell = insert.cell;
      start = insert.start;
      return true;
    }
    return false;
  }

  const GridParameters& grid_;
  const Edits& edits_;
  std::vector<Insert> inserts_;
  ivec3 resumeCell_{-2};
  bool resumes_ = false;
};

}  // namespace

RayRecord recordWithout(const TraceInput& input, const Ray& ray, std::span<const TruthEvent> removed) {
  Edits edits;
  for (const TruthEvent& event : removed) addEdit(edits, input.grid, event);
  TraceInput edited = input;
  if (edits.unlimited) edited.parameters.maxSegments = 0x40000000u;
  edited.parameters.tMin = otherTMin(input, ray, edits);

  EditedTrace trace(edited, ray, edits);
  trace.record.hit = traceAllPasses(trace, edited, ray);
  const Hit outside = trace.outsideHit(ray, edited.parameters.tMin);
  const bool ended = trace.record.hit.kind == kHitTriangle || trace.record.hit.kind == kHitVoxel;
  if (outside.kind == kHitTriangle && (!ended || outside.t < trace.record.hit.t)) trace.record.hit = outside;
  return std::move(trace.record);
}

}  // namespace gridscope
