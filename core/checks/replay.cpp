// See replay.h.
#include "core/checks/replay.h"

#include <algorithm>
#include <memory>
#include <set>

#include "core/capture/compare.h"
#include "core/checks/self_test.h"
#include "core/pipeline/cpu_stages.h"
#include "core/pipeline/frame_capture.h"

namespace gridscope {
namespace {

enum Product { kGrid, kHits, kCounters, kExact, kProductCount };
constexpr const char* kProductNames[kProductCount] = {"grid", "hits", "counters", "exact"};

// 64-bit digest of a product, to tell repetitions apart. Source: Fowler, Noll and Vo, FNV-1a, on words instead of bytes.
template <typename T>
uint64_t digest(std::span<const T> values, uint64_t seed) {
  static_assert(sizeof(T) % sizeof(uint32_t) == 0);
  const auto* words = reinterpret_cast<const uint32_t*>(values.data());
  uint64_t hash = seed ^ 0xCBF29CE484222325ull;
  for (size_t i = 0; i < values.size_bytes() / sizeof(uint32_t); ++i) hash = (hash ^ words[i]) * 0x100000001B3ull, hash ^= hash >> 29;
  return hash;
}

// What one run found about one product.
struct RunResult {
  uint64_t different = 0;
  uint64_t total = 0;
  std::string first;
  uint64_t digest = 0;
  bool made = false;
};

// A capture's replay. make(frame): a Pipeline or CpuStages for the frame's inputs.
template <class Make>
class Replay {
 public:
  Replay(const Capture& capture, ReplayFrom from, const Make& make, ReplayResult& result)
      : capture_(capture), from_(from), make_(make), result_(result), firstCome_(capture.grid.insertion == kInsertionFirstCome) {}

  void run(uint32_t repeat) {
    std::set<uint64_t> digests[kProductCount];
    ReplayedProduct products[kProductCount];
    for (uint32_t i = 0; i < repeat; ++i) {
      runOnce();
      for (int k = 0; k < kProductCount; ++k) {
        const RunResult& run = run_[k];
        if (run.made) digests[k].insert(run.digest);
        if (i > 0 && run.different <= products[k].different) continue;
        products[k] = {.name = kProductNames[k], .different = run.different, .total = run.total, .first = run.first};
      }
    }
    for (int k = 0; k < kProductCount; ++k) {
      if (digests[k].empty() || (products[k].total == 0 && repeat == 1)) continue;
      products[k].distinct = static_cast<uint32_t>(digests[k].size());
      result_.products.push_back(products[k]);
    }
  }

 private:
  void runOnce() {
    for (RunResult& run : run_) run = {};
    for (size_t frame = 0; frame < capture_.frames.size(); ++frame) runFrame(frame);
  }

  void runFrame(size_t frame) {
    const CaptureFrame& captured = capture_.frames[frame];
    prepare(frame);

    // The grid. From `update` the first frame's is not compared, but must be there before the second's.
    const bool made = from_ == ReplayFrom::build || (from_ == ReplayFrom::update && frame > 0);
    if (from_ == ReplayFrom::update && frame > 0) stages_->useGrid(capture_.frames[frame - 1].grid);
    if (from_ != ReplayFrom::trace) stages_->update(frameInstances(capture_, frame));
    if (made) compareGrid(captured, frame);

    // The trace. The race that decided a first-come grid is not run again: its captured outcome is traced.
    if (!captured.rays.empty() && (made || from_ == ReplayFrom::trace)) {
      if (!made || (firstCome_ && !captured.grid.empty())) stages_->useGrid(captured.grid);
      stages_->useRays(captured.rays);
      compareTraced(captured, frame);
    }
    if (!captured.exact.empty() && !captured.rays.empty()) compareExact(captured, frame);
    if (result_.different && result_.different->frame == frame)
      result_.different->grid = std::move(grid_), result_.different->hits = std::move(hits_);
    grid_.clear(), hits_.clear();
  }

  // Stages for the frame. An update moves the instances; without one, stages are made anew where instances have moved.
  void prepare(size_t frame) {
    const bool moved = from_ == ReplayFrom::trace && frame != madeFor_;
    if (!stages_ || moved) stages_ = make_(frame), madeFor_ = frame;
    if (from_ != ReplayFrom::trace && frame == 0) stages_->build();
  }

  Comparison how() const { return {"captured", "replayed", capture_.scene, &capture_.names}; }

  void compareGrid(const CaptureFrame& captured, size_t frame) {
    const Grid grid = stages_->grid();
    made<uint32_t>(kGrid, grid.words);
    if (captured.grid.empty()) return;
    const Grid stored{capture_.grid, captured.grid};
    note(kGrid, firstCome_ ? compareGridsAsSets(stored, grid, how()) : compareGrids(stored, grid, how()), frame);
    grid_ = grid.words;
  }

  void compareTraced(const CaptureFrame& captured, size_t frame) {
    const uint32_t width = capture_.settings.width;
    stages_->trace(false);
    hits_ = stages_->hits();
    made<Hit>(kHits, hits_);
    if (!captured.hits.empty()) note(kHits, compareHits(captured.hits, hits_, width, how()), frame);
    if (captured.counters.empty()) return;

    // The counting trace is a kernel of its own: its hits must be the same.
    stages_->trace(true);
    const std::vector<RayCounters> counters = stages_->counters();
    made<RayCounters>(kCounters, counters);
    note(kCounters, compareCounters(captured.counters, counters, width, how()), frame);
    const Difference between =
        compareHits(hits_, stages_->hits(), width, {"the fast trace", "the counting trace", capture_.scene, &capture_.names});
    note(kHits, {.different = between.different, .total = 0, .firstIndex = between.firstIndex, .first = between.first}, frame);
  }

  // From the captured triangles and transforms alone, on every device in C++.
  void compareExact(const CaptureFrame& captured, size_t frame) {
    const NumberedScene scene = frameScene(capture_, frame);
    std::vector<Triangle> triangles(scene.triangleCount);
    transformTriangles(scene, {0, scene.instanceCount()}, triangles);
    const Grid shape{capture_.grid, {}};
    const std::vector<ExactHit> exact = traceExactHits({shape, scene, triangles, capture_.trace}, captured.rays);
    made<ExactHit>(kExact, exact);
    note(kExact, compareExactHits(captured.exact, exact, capture_.settings.width, how()), frame);
  }

  template <typename T>
  void made(Product product, std::span<const T> values) {
    run_[product].made = true;
    run_[product].digest = digest<T>(values, run_[product].digest);
  }

  void note(Product product, const Difference& difference, size_t frame) {
    RunResult& run = run_[product];
    run.total += difference.total;
    run.different += difference.different;
    if (difference.equal()) return;
    const std::string which = capture_.frames.size() > 1 ? "frame " + std::to_string(frame) + ", " : "";
    if (run.first.empty()) run.first = which + difference.first;
    if (!result_.different) result_.different = DifferentFrame{.frame = frame, .grid = {}, .hits = {}};
  }

  const Capture& capture_;
  ReplayFrom from_;
  const Make& make_;
  ReplayResult& result_;
  bool firstCome_;
  decltype(std::declval<Make>()(size_t(0))) stages_{};
  size_t madeFor_ = 0;
  RunResult run_[kProductCount];
  std::vector<uint32_t> grid_;  // the present frame's, where it was made
  std::vector<Hit> hits_;
};

void conclude(ReplayResult& result, uint32_t repeat, bool firstCome) {
  uint64_t compared = 0, different = 0;
  bool unstable = false;
  for (const ReplayedProduct& product : result.products) {
    compared += product.total;
    different += product.different;
    // A first-come grid is expected to come out in many ways.
    unstable = unstable || (product.distinct > 1 && !(firstCome && product.name == kProductNames[kGrid]));
  }
  if (compared == 0 && (repeat == 1 || result.products.empty())) {
    result.verdict = Verdict::unusable;
    result.reason =
        "holds no product that could be compared; --repeat 2 says whether the results are stable, capture FILE -o NEW adds them";
  } else {
    result.verdict = different > 0 || unstable ? Verdict::different : Verdict::equal;
  }
}

ReplayFrom chosen(const Capture& capture, ReplayFrom from) {
  if (from != ReplayFrom::automatic) return from;
  return builtHere(capture) ? ReplayFrom::build : ReplayFrom::trace;
}

}  // namespace

const char* verdictName(Verdict verdict) {
  static constexpr const char* kNames[] = {"equal", "different", "unusable", "unsupported"};
  return kNames[static_cast<size_t>(verdict)];
}

std::string whyUnsupported(GpuContext& gpu) {
  if (!gpu.report().float64) return gpu.report().name + " has no 64-bit floats: its bits are not those of other devices";
  const SelfTestResult test = runSelfTest(gpu);
  for (const SelfTestResult::Item& item : test.items)
    if (item.different > 0)
      return gpu.report().name + " fails the self-test: " + item.name + " differs from C++ in " + std::to_string(item.different) + " words";
  return "";
}

std::string whyNotFrom(const Capture& capture, ReplayFrom from) {
  const CaptureFrame& first = capture.frames.front();
  from = chosen(capture, from);
  if (from == ReplayFrom::trace && first.grid.empty()) return "holds no grid to trace in";
  if (from == ReplayFrom::trace && first.rays.empty()) return "holds no rays to trace";
  if (from != ReplayFrom::trace && !gridAbilities(capture.grid).built)
    return "its grid has " + refusalText(capture.grid) + ", which this program does not build; use --from trace";
  if (from == ReplayFrom::update && capture.frames.size() == 1) return "holds one frame: an update needs a sequence";
  if (from == ReplayFrom::update && first.grid.empty()) return "holds no grids to update";
  return "";
}

ReplayResult replay(const Capture& capture, const ReplayOptions& options, GpuContext* gpu) {
  const ReplayFrom from = chosen(capture, options.from);
  ReplayResult result{.device = gpu ? gpu->report().name : "cpu"};
  result.reason = whyNotFrom(capture, from);
  if (!result.reason.empty()) {
    result.verdict = Verdict::unusable;
    return result;
  }
  try {
    if (gpu) {
      const auto make = [&](size_t frame) { return std::make_unique<Pipeline>(*gpu, pipelineInputs(capture, frame)); };
      Replay(capture, from, make, result).run(options.repeat);
    } else {
      const auto make = [&](size_t frame) { return std::make_unique<CpuStages>(pipelineInputs(capture, frame)); };
      Replay(capture, from, make, result).run(options.repeat);
    }
  } catch (const Error& error) {
    // The grid or the frame does not fit the device, or it was lost.
    if (error.exitCode() != kExitDevice) throw;
    result.verdict = Verdict::unsupported;
    result.reason = error.what();
    return result;
  }
  conclude(result, options.repeat, capture.grid.insertion == kInsertionFirstCome);
  return result;
}

}  // namespace gridscope
