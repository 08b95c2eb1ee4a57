// See tune_job.h.
#include "app/jobs/tune_job.h"

#include <algorithm>
#include <chrono>

#include "app/base/low_priority.h"
#include "app/session/load_scene.h"
#include "core/base/error.h"

namespace gridscope {

double TuneState::secondsLeft() const { return done == 0 || total == 0 ? -1.0 : seconds * double(total - done) / double(done); }

TuneLimits usualLimits(const TuneRow& first) { return {kTuneMostMemory * memoryOf(first), kTuneMostTime * traceTimeOf(first)}; }

bool within(const TuneRow& row, const TuneLimits& limits) {
  return row.measured() && memoryOf(row) <= limits.bytes && traceTimeOf(row) <= limits.milliseconds;
}

std::optional<size_t> bestWithin(std::span<const TuneRow> rows, const TuneLimits& limits) {
  const auto better = [](const TuneRow& a, const TuneRow& b) {
    if (a.wrong() != b.wrong()) return a.wrong() < b.wrong();
    if (a.bytes != b.bytes) return a.bytes < b.bytes;
    return traceTimeOf(a) < traceTimeOf(b);
  };
  std::optional<size_t> best;
  for (size_t index = 0; index < rows.size(); ++index)
    if (within(rows[index], limits) && (!best || better(rows[index], rows[*best]))) best = index;
  return best;
}

void applyTuneRow(const TuneRow& row, FrameSettings& settings) {
  settings.grid.cells = row.grid.cells;
  settings.grid.cellEdge = row.grid.cellEdge;
  settings.grid.capacity = row.grid.capacity;
  settings.grid.overlap = row.grid.overlap;
  settings.grid.numberBy = row.grid.numberBy;
  settings.trace.traversal = row.trace.traversal;
  settings.trace.back = row.trace.back;
  settings.trace.ahead = row.trace.ahead;
  settings.trace.gate = row.trace.gate;
}

bool canRenumber(const FrameSnapshot& frame) { return frame.scene && frame.scene->captureFrames == 0 && frame.request.edits.empty(); }

size_t settingCount(const TuneAxes& axes, bool numberingsToo) {
  const auto of = [](size_t count) { return std::max<size_t>(1, count); };
  const size_t grids =
      of(axes.cells.size()) * of(axes.capacities.size()) * of(axes.overlaps.size()) * (numberingsToo ? of(axes.numberings.size()) : 1);
  const auto dda = std::count(axes.traversals.begin(), axes.traversals.end(), kTraversalDda);
  const size_t segments = of(axes.traversals.size()) - size_t(dda);
  const size_t traces = (segments * of(axes.backs.size()) * of(axes.aheads.size()) + size_t(dda)) * of(axes.gates.size());
  return 1 + grids + traces;
}

TuneJob::~TuneJob() {
  cancel_ = true;
  if (thread_.joinable()) thread_.join();
}

template <typename Change>
void TuneJob::change(const Change& change) {
  const std::lock_guard lock(mutex_);
  change(state_);
  state_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  state_.number = ++number_;
}

TuneState TuneJob::state() const {
  const std::lock_guard lock(mutex_);
  TuneState copy = state_;
  if (copy.running) copy.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  return copy;
}

void TuneJob::start(std::shared_ptr<const FrameSnapshot> frame, const TuneAxes& axes) {
  cancel_ = true;
  if (thread_.joinable()) thread_.join();
  cancel_ = false;
  began_ = std::chrono::steady_clock::now();
  change([&](TuneState& state) {
    state = {.running = true, .width = frame->request.settings->width, .height = frame->request.settings->height};
  });
  thread_ = std::thread([this, frame = std::move(frame), axes] {
    lowerThreadPriority();
    std::string fault;
    try {
      run(frame, axes);
    } catch (const std::exception& error) {
      fault = error.what();
    }
    change([&](TuneState& state) { state.running = false, state.fault = fault, state.stopped = cancel_; });
  });
}

void TuneJob::note(const TuneStep& step) {
  change([&](TuneState& state) {
    state.rows.push_back(step.last);
    state.done = step.done, state.total = step.total;
    markFront(state.rows);
    if (state.rows.front().measured()) state.recommended = recommend(state.rows);
  });
}

// The frame's own instances, as a pipeline without a scene takes them.
static PipelineInputs inputsOf(const FrameSnapshot& frame) {
  PipelineInputs inputs{
      .name = frame.scene->name, .numbered = frame.scene->numbered, .settings = *frame.request.settings, .parameters = frame.parameters};
  inputs.numbered.instances = *frame.instances;
  return inputs;
}

static std::optional<Scene> sceneToNumber(const FrameSnapshot& frame, const TuneAxes& axes) {
  if (!canRenumber(frame) || axes.numberings.size() < 2) return std::nullopt;
  Options options;
  options.scene = frame.request.source.scene;
  options.teapots = frame.request.source.teapots;
  options.moving = frame.request.source.moving;
  return loadScene(options).scene;
}

void TuneJob::run(const std::shared_ptr<const FrameSnapshot>& frame, const TuneAxes& axes) {
  const bool onCpu = frame->device == "cpu";
  GpuContext gpu({.device = onCpu ? "" : frame->device});
  Pipeline pipeline(gpu, inputsOf(*frame), onCpu ? StageDevice::cpu : StageDevice::vulkan);
  pipeline.build();
  pipeline.update(*frame->instances);
  if (frame->gather) pipeline.useGather(*frame->gather);
  pipeline.useRays(*frame->rays);
  const std::optional<Scene> scene = sceneToNumber(*frame, axes);
  const TuneInput input{.gpu = gpu,
                        .frame = pipeline,
                        .scene = scene ? &*scene : nullptr,
                        .bounds = frame->request.settings->grid.bounds.value_or(frame->scene->bounds),
                        .timeSeconds = float(frame->request.timeSeconds),
                        .axes = axes};
  change([&](TuneState& state) { state.total = tuneCount(input); });
  const TuneResult result = tune(input, [this](const TuneStep& step) {
    note(step);
    return !cancel_;
  });
  change([&](TuneState& state) { state.rows = result.rows, state.recommended = result.recommended; });
  if (!result.fault.empty()) throw Error("the sweep ended at " + result.fault);
}

}  // namespace gridscope
