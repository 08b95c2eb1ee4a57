// See tune.h.
#include "core/tune.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string_view>

#include "core/build.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/tune_choice.h"

namespace gridscope {
namespace {

using Clock = std::chrono::steady_clock;

// Timed runs of a stage end early when they took this long together.
constexpr double kMostStageMs = 1500.0;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

template <class Value>
std::vector<Value> orOwn(const std::vector<Value>& axis, Value own) {
  return axis.empty() ? std::vector<Value>{own} : axis;
}

bool sameGrid(const GridSettings& a, const GridSettings& b) {
  return a.cells == b.cells && a.cellEdge == b.cellEdge && a.capacity == b.capacity && a.overlap == b.overlap && a.numberBy == b.numberBy;
}

bool sameTrace(const TraceSettings& a, const TraceSettings& b) {
  const bool reachMatters = a.traversal == kTraversalSegment;
  return a.traversal == b.traversal && a.gate == b.gate && (!reachMatters || (a.back == b.back && a.ahead == b.ahead));
}

// Grids to try, without the frame's own. Cells are the outermost: exact hits are made anew for each cell edge.
std::vector<GridSettings> gridsOf(const TuneInput& input) {
  const GridSettings own = input.frame.settings().grid;
  std::vector<NumberBy> numberings = orOwn(input.axes.numberings, own.numberBy);
  if (!input.scene) numberings = {own.numberBy};
  std::vector<GridSettings> grids;
  for (uint32_t cells : orOwn(input.axes.cells, own.cells))
    for (uint32_t overlap : orOwn(input.axes.overlaps, own.overlap))
      for (NumberBy numberBy : numberings)
        for (uint32_t capacity : orOwn(input.axes.capacities, own.capacity)) {
          GridSettings grid = own;
          grid.cells = cells;
          if (!input.axes.cells.empty()) grid.cellEdge = 0.0f;
          grid.overlap = overlap;
          grid.numberBy = numberBy;
          grid.capacity = capacity;
          if (!sameGrid(grid, own)) grids.push_back(grid);
        }
  return grids;
}

// Trace settings to try, without the frame's own.
std::vector<TraceSettings> tracesOf(const TuneInput& input) {
  const TraceSettings own = input.frame.settings().trace;
  std::vector<TraceSettings> traces;
  auto add = [&](const TraceSettings& trace) {
    auto same = [&](const TraceSettings& other) { return sameTrace(trace, other); };
    if (!same(own) && std::ranges::none_of(traces, same)) traces.push_back(trace);
  };
  for (uint32_t traversal : orOwn(input.axes.traversals, own.traversal))
    for (float back : orOwn(input.axes.backs, own.back))
      for (float ahead : orOwn(input.axes.aheads, own.ahead))
        for (float gate : orOwn(input.axes.gates, own.gate)) {
          TraceSettings trace = own;
          trace.traversal = traversal;
          if (traversal == kTraversalSegment) trace.back = back, trace.ahead = ahead;
          trace.gate = gate;
          add(trace);
        }
  return traces;
}

// One numbering of the scene at the frame's time, with its triangles.
struct Numbering {
  NumberedScene scene;
  std::vector<Triangle> worldTriangles;
};

class Sweep {
 public:
  Sweep(const TuneInput& input, const TuneProgress& progress)
      : input_(input), progress_(progress), rays_(input.frame.rays()), grids_(gridsOf(input)), traces_(tracesOf(input)) {}

  TuneResult run() {
    const Clock::time_point start = Clock::now();
    const FrameSettings& own = input_.frame.settings();
    tryGrid(own.grid);
    if (!result_.rows.front().measured()) throw Error("the frame's own setting: " + result_.rows.front().refusal, kExitDevice);
    for (const GridSettings& grid : grids_)
      if (!result_.stopped) tryGrid(grid);
    result_.bestGrid = recommend(result_.rows);
    if (!result_.stopped) tryTraces();
    result_.recommended = recommend(result_.rows);
    markFront(result_.rows);
    result_.seconds = secondsSince(start);
    return std::move(result_);
  }

 private:
  size_t total() const { return 1 + grids_.size() + traces_.size(); }

  void finishRow(TuneRow row) {
    result_.rows.push_back(std::move(row));
    if (progress_ && !progress_({result_.rows.size(), total(), result_.rows.back()})) result_.stopped = true;
  }

  // Runs `work`, whose fault becomes the row's refusal; a lost device is the sweep's end.
  template <class Work>
  void refusing(TuneRow& row, Work work) {
    try {
      work();
    } catch (const Error& error) {
      if (std::string_view(error.what()).find("DEVICE_LOST") != std::string_view::npos) throw;
      row.refusal = error.what();
    } catch (const std::bad_alloc&) {
      row.refusal = "not enough memory";
    }
  }

  void tryGrid(const GridSettings& grid) {
    TuneRow row{.grid = grid, .trace = input_.frame.settings().trace};
    refusing(row, [&] {
      auto pipeline = std::make_unique<Pipeline>(input_.gpu, inputsOf(row), input_.frame.device());
      pipeline->useRays(rays_);
      measureGrid(*pipeline, row);
      measureTrace(*pipeline, row);
      if (!own_) own_ = std::move(pipeline), ownTraceMs_ = row.traceMs.median;
    });
    finishRow(std::move(row));
  }

  // The trace's constants, all on the best grid, which is built once.
  void tryTraces() {
    if (traces_.empty()) return;
    TuneRow best{.grid = result_.rows[result_.bestGrid].grid, .trace = input_.frame.settings().trace};
    Pipeline pipeline(input_.gpu, inputsOf(best), input_.frame.device());
    pipeline.useRays(rays_);
    measureGrid(pipeline, best);
    for (const TraceSettings& trace : traces_) {
      if (result_.stopped) return;
      TuneRow row = best;
      row.trace = trace;
      refusing(row, [&] {
        pipeline.setTrace(trace);
        measureTrace(pipeline, row);
      });
      finishRow(std::move(row));
    }
  }

  // The frame's own numbering is at hand; others are made once.
  const Numbering& numbering(NumberBy order) {
    auto [found, isNew] = numberings_.try_emplace(order);
    if (!isNew) return found->second;
    Numbering& made = found->second;
    if (order == input_.frame.settings().grid.numberBy) {
      made.scene = input_.frame.numbered();
    } else {
      made.scene = numberScene(*input_.scene, order);
      setTransforms(made.scene, *input_.scene, input_.timeSeconds);
    }
    made.worldTriangles.resize(made.scene.triangleCount);
    transformTriangles(made.scene, {0, made.scene.instanceCount()}, made.worldTriangles);
    return made;
  }

  // For a pipeline with the row's settings and the frame's instances. Without diffuse maps: nothing measured here shows them.
  PipelineInputs inputsOf(const TuneRow& row) {
    const Numbering& numbered = numbering(row.grid.numberBy);
    PipelineInputs inputs{.name = input_.frame.name(), .numbered = numbered.scene, .settings = input_.frame.settings(),
                          .parameters = input_.frame.parameters()};
    inputs.settings.grid = row.grid;
    inputs.settings.trace = row.trace;
    inputs.parameters.grid = deriveGrid(row.grid, input_.bounds, numbered.scene);
    inputs.parameters.trace = deriveTrace(row.trace, inputs.parameters.grid);
    return inputs;
  }

  template <class Stage>
  Spread timed(Stage stage) {
    std::vector<double> times;
    const Clock::time_point start = Clock::now();
    for (uint32_t run = 0; run < std::max(1u, input_.runs); ++run) {
      times.push_back(stage());
      if (secondsSince(start) * 1000.0 > kMostStageMs) break;
    }
    return spreadOf(std::move(times));
  }

  void measureGrid(Pipeline& pipeline, TuneRow& row) {
    const std::vector<Instance> instances = pipeline.numbered().instances;
    row.buildMs = timed([&] {
      pipeline.build();
      pipeline.update(instances);
      return pipeline.times().build + pipeline.times().clear + pipeline.times().add;
    });
    const GridTotals totals = pipeline.gridTotals();
    row.bytes = gridByteCount(pipeline.parameters().grid);
    row.stored = totals.stored();
    row.refused = totals.refused();
    row.occupied = totals.statistics.occupied;
    row.saturated = totals.statistics.saturated;
  }

  // A device's clock changes while a sweep runs, by a factor of four within seconds on some. So every run stands beside one of the frame's
  // own setting, and a time is told as it would be at the clock of the first row.
  Spread timeTrace(Pipeline& pipeline) {
    auto once = [](Pipeline& traced) {
      traced.trace(false);
      return traced.times().trace;
    };
    std::vector<double> beside;
    Spread spread = timed([&] {
      if (own_) beside.push_back(once(*own_));
      return once(pipeline);
    });
    const double scale = own_ ? ownTraceMs_ / std::max(spreadOf(std::move(beside)).median, 1e-9) : 1.0;
    return {.min = spread.min * scale, .median = spread.median * scale, .max = spread.max * scale};
  }

  // The counting trace for the counters, then the fast one for its time. Their hits are the same.
  void measureTrace(Pipeline& pipeline, TuneRow& row) {
    pipeline.trace(true);
    const std::vector<Hit> hits = pipeline.hits();
    const CounterTotals counters = summariseCounters(pipeline.counters(), hits);
    row.visits = counters.visits.mean;
    row.tests = counters.tests.mean;
    row.traceMs = timeTrace(pipeline);
    judgeAll(pipeline, hits, row);
  }

  void judgeAll(Pipeline& pipeline, const std::vector<Hit>& hits, TuneRow& row) {
    const GridParameters& grid = pipeline.parameters().grid;
    const std::vector<Hit>& exact = exactHits(pipeline.parameters(), row.grid.numberBy);
    row.verdicts = {};
    for (size_t i = 0; i < hits.size(); ++i) ++row.verdicts[judge(hits[i], exact[i], grid)];
    row.rays = hits.size() - row.verdicts[kVerdictNoRay];
    row.verdicts[kVerdictNoRay] = 0;
  }

  // Exact hits depend on the rays, the triangles and the trace's parameters that are not the grid's: tMin alone.
  const std::vector<Hit>& exactHits(const FrameParameters& parameters, NumberBy order) {
    if (exactTMin_ == parameters.trace.tMin) return exact_;
    const Numbering& numbered = numbering(order);
    const Grid shape{parameters.grid, {}};
    exact_ = ExactReference({shape, numbered.scene, numbered.worldTriangles, parameters.trace}).trace(rays_);
    exactTMin_ = parameters.trace.tMin;
    return exact_;
  }

  const TuneInput& input_;
  const TuneProgress& progress_;
  std::vector<Ray> rays_;
  std::vector<GridSettings> grids_;
  std::vector<TraceSettings> traces_;
  std::map<NumberBy, Numbering> numberings_;
  std::unique_ptr<Pipeline> own_;        // of the first row, once it is measured
  double ownTraceMs_ = 0.0;              // median of the first row
  std::vector<Hit> exact_;
  std::optional<float> exactTMin_;       // of exact_
  TuneResult result_;
};

}  // namespace

uint64_t TuneRow::wrong() const {
  uint64_t count = 0;
  for (uint32_t verdict = 0; verdict < kVerdictCount; ++verdict)
    if (verdictWrong(verdict)) count += verdicts[verdict];
  return count;
}

size_t tuneCount(const TuneInput& input) { return 1 + gridsOf(input).size() + tracesOf(input).size(); }

TuneResult tune(const TuneInput& input, const TuneProgress& progress) { return Sweep(input, progress).run(); }

}  // namespace gridscope
