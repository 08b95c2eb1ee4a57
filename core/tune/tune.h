// What if: the same frame with other grids. A sweep over cells, capacity, overlap test and numbering, then over the trace's constants around
// the best grid; every setting is built, traced and compared with the exact hits of the same rays. The paper chooses these by hand.
//
// What the settings share is made once: the rays (the bounce's offset depends on the scene alone), the world triangles, and the exact hits
// of each cell edge (tMin is given in cell edges). Numbering changes references but no distance, and a verdict compares distances.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/statistics.h"
#include "core/pipeline/pipeline.h"
#include "core/truth/truth.h"

namespace gridscope {

// Values to try. An empty axis keeps the frame's own value. Every combination of the grid's axes is tried, and then, on the best grid, every
// combination of the trace's (back and ahead mean nothing to dda).
struct TuneAxes {
  std::vector<uint32_t> cells{48, 64, 96, 128, 160, 192, 256};       // along the longest side
  std::vector<uint32_t> capacities{4, 8, 16, 24, 32, 48, 64};        // slots of a cell
  std::vector<uint32_t> overlaps{kOverlapPlane, kOverlapExact};      // kOverlap...
  std::vector<NumberBy> numberings{NumberBy::file, NumberBy::area};  // without a scene, the frame's own alone
  std::vector<uint32_t> traversals{kTraversalSegment, kTraversalDda};
  std::vector<float> backs{0.5f, 1.0f, 1.5f};  // cell edges; likewise the next two
  std::vector<float> aheads{0.5f, 0.75f, 1.0f, 1.5f};
  std::vector<float> gates{1.0f, 1.75f, 2.5f};
};

struct TuneInput {
  GpuContext& gpu;
  Pipeline& frame;               // what is tuned: its settings and shape, instances and rays; gather and bounce (or useRays) have run
  const Scene* scene = nullptr;  // to number in other orders; null (a capture): the frame's own numbering alone
  Bounds bounds;                 // that grids cover: the scene's over its whole animation
  float timeSeconds = 0.0f;      // of the frame, for a scene's transforms
  TuneAxes axes;
  uint32_t runs = 3;  // timed runs of build and trace; a stage that takes long gets fewer
};

// One setting, and what it does to the frame.
struct TuneRow {
  GridSettings grid;
  TraceSettings trace;
  std::string refusal;  // why it can't be tried (the device can't hold it, say), one line; empty: it was
  uint64_t bytes = 0;   // of the grid
  uint64_t stored = 0;  // references, static and dynamic; likewise the next
  uint64_t refused = 0;
  uint64_t occupied = 0;  // cells; likewise the next
  uint64_t saturated = 0;
  uint64_t rays = 0;                               // valid ones: the verdicts add up to them
  std::array<uint64_t, kVerdictCount> verdicts{};  // by kVerdict...
  double visits = 0.0;                             // mean a ray; likewise the next
  double tests = 0.0;
  Spread buildMs;      // of the static grid and the dynamic instances
  Spread traceMs;      // at the clock of the first row: scaled by what its setting took beside this one
  bool front = false;  // no other setting is at least as good in memory, trace time and wrong rays and better in one

  bool measured() const { return refusal.empty(); }
  uint64_t wrong() const;  // hole + voxel wrong + too far + too near
};

struct TuneResult {
  std::vector<TuneRow> rows;  // in the order tried; the first is the frame's own setting
  size_t recommended = 0;     // into rows, by the rule of choice.h; 0: the sweep found nothing better
  size_t bestGrid = 0;        // into rows: whose grid the trace's constants were tried on
  bool stopped = false;       // by the progress function, or because of `fault`: rows hold what was done until then
  std::string fault;          // why it could not go on: the device is lost; empty: it could
  double seconds = 0.0;       // it took
};

// Told after every setting, on the thread of tune(). `last`: the row just done.
struct TuneStep {
  size_t done;
  size_t total;  // settings in the whole sweep, known from the start
  const TuneRow& last;
};
using TuneProgress = std::function<bool(const TuneStep& step)>;  // false stops after this row

// How many settings a sweep tries, the frame's own included.
size_t tuneCount(const TuneInput& input);

// Runs the sweep. What can't be tried becomes a row with its reason; throws Error when the frame's own setting fails.
TuneResult tune(const TuneInput& input, const TuneProgress& progress = {});

}  // namespace gridscope
