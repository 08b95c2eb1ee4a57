// See tune.h.
#include "core/tune/tune.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/grid/build.h"
#include "core/grid/derive.h"
#include "core/trace/derive.h"
#include "core/trace/statistics.h"
#include "core/tune/attempt.h"
#include "core/tune/choice.h"
#include "core/tune/settings.h"

namespace gridscope {
namespace {

using Clock = std::chrono::steady_clock;

// Timed runs of a stage end early when they took this long together.
constexpr double kMostStageMs = 1500.0;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// One numbering of the scene at the frame's time, with its triangles.
struct Numbering {
  NumberedScene scene;
  std::vector<Triangle> worldTriangles;
};

TuneOwn ownOf(const TuneInput& input) {
  return ownSettings(input.frame.settings(), input.frame.parameters(), input.frame.numbered(), input.bounds);
}

class Sweep {
 public:
  Sweep(const TuneInput& input, const TuneProgress& progress)
      : input_(input),
        progress_(progress),
        rays_(input.frame.rays()),
        own_(ownOf(input)),
        grids_(gridsToTry(input.axes, own_.grid, input.scene != nullptr)),
        traces_(tracesToTry(input.axes, own_.trace)) {}

  TuneResult run() {
    const Clock::time_point start = Clock::now();
    tryGrid(own_.grid);
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

  // Measures a setting and adds its row; a lost device ends the sweep, and what was done until then is kept.
  template <class Measure>
  void tryAndFinish(TuneRow row, Measure measure) {
    timedAlone_ = false;
    const bool lives = tryRow(row, measure, [&] { return timedAlone_ = std::exchange(beside_, nullptr) != nullptr; });
    if (!lives) result_.fault = tuneTitle(row) + ": " + row.refusal, result_.stopped = true;
    finishRow(std::move(row));
  }

  std::unique_ptr<Pipeline> pipelineOf(const TuneRow& row) {
    auto pipeline = std::make_unique<Pipeline>(input_.gpu, inputsOf(row), input_.frame.device());
    pipeline->useRays(rays_);
    return pipeline;
  }

  void tryGrid(const GridSettings& grid) {
    tryAndFinish({.grid = grid, .trace = own_.trace}, [&](TuneRow& row) {
      std::unique_ptr<Pipeline> pipeline = pipelineOf(row);
      measureGrid(*pipeline, row);
      measureTrace(*pipeline, row);
      if (result_.rows.empty()) beside_ = std::move(pipeline), ownTraceMs_ = row.traceMs.median;
    });
  }

  // The trace's constants, all on the best grid, which is built once.
  void tryTraces() {
    if (traces_.empty()) return;
    std::unique_ptr<Pipeline> pipeline;
    TuneRow best{.grid = result_.rows[result_.bestGrid].grid, .trace = own_.trace};
    for (const TraceSettings& trace : traces_) {
      if (result_.stopped) return;
      tryAndFinish({.grid = best.grid, .trace = trace}, [&](TuneRow& row) {
        if (!pipeline) {
          pipeline = pipelineOf(best);
          measureGrid(*pipeline, best);
        }
        row = best;
        row.trace = trace;
        pipeline->setTrace(trace);
        measureTrace(*pipeline, row);
      });
    }
  }

  // The frame's own numbering is at hand; others are made once.
  const Numbering& numbering(NumberBy order) {
    auto [found, isNew] = numberings_.try_emplace(order);
    if (!isNew) return found->second;
    Numbering& made = found->second;
    if (order == own_.grid.numberBy) {
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
    PipelineInputs inputs{.name = input_.frame.name(),
                          .numbered = numbered.scene,
                          .settings = input_.frame.settings(),
                          .parameters = input_.frame.parameters()};
    const bool isOwn = triesSame(row.grid, own_.grid);
    inputs.settings.grid = row.grid;
    inputs.settings.trace = row.trace;
    inputs.parameters.grid = isOwn ? own_.gridParameters : deriveGrid(row.grid, input_.bounds, numbered.scene);
    inputs.parameters.trace =
        isOwn && triesSame(row.trace, own_.trace) ? own_.traceParameters : deriveTrace(row.trace, inputs.parameters.grid);
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
    bringBeside();
    std::vector<double> beside;
    Spread spread = timed([&] {
      if (beside_) beside.push_back(once(*beside_));
      return once(pipeline);
    });
    const double scale = beside_ ? ownTraceMs_ / std::max(spreadOf(std::move(beside)).median, 1e-9) : 1.0;
    return {.min = spread.min * scale, .median = spread.median * scale, .max = spread.max * scale};
  }

  // The own setting to time beside, again after it made room for another. Where both don't fit, times stand alone.
  void bringBeside() {
    if (beside_ || timedAlone_ || result_.rows.empty()) return;
    TuneRow own{.grid = own_.grid, .trace = own_.trace};
    std::unique_ptr<Pipeline> pipeline;
    const auto build = [&](TuneRow& row) {
      pipeline = pipelineOf(row);
      pipeline->build();
      pipeline->update(std::vector<Instance>(pipeline->numbered().instances));
    };
    if (!tryRow(own, build, [] { return false; })) throw Error(own.refusal, kExitDevice);
    if (own.measured()) beside_ = std::move(pipeline);
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
  TuneOwn own_;
  std::vector<GridSettings> grids_;
  std::vector<TraceSettings> traces_;
  std::map<NumberBy, Numbering> numberings_;
  std::unique_ptr<Pipeline> beside_;  // the first row's, once it is measured: it is timed beside all others
  bool timedAlone_ = false;           // the present row needs the room of beside_
  double ownTraceMs_ = 0.0;           // median of the first row
  std::vector<Hit> exact_;
  std::optional<float> exactTMin_;  // of exact_
  TuneResult result_;
};

}  // namespace

uint64_t TuneRow::wrong() const {
  uint64_t count = 0;
  for (uint32_t verdict = 0; verdict < kVerdictCount; ++verdict)
    if (verdictWrong(verdict)) count += verdicts[verdict];
  return count;
}

size_t tuneCount(const TuneInput& input) {
  const TuneOwn own = ownOf(input);
  return 1 + gridsToTry(input.axes, own.grid, input.scene != nullptr).size() + tracesToTry(input.axes, own.trace).size();
}

TuneResult tune(const TuneInput& input, const TuneProgress& progress) { return Sweep(input, progress).run(); }

}  // namespace gridscope
