// gridscope check: the stages of a frame, and after each of them everything that must hold; the order of arrival; budgets.
#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/check_report.h"
#include "core/base/error.h"
#include "core/trace/invariants_frame.h"
#include "core/trace/invariants_rays.h"

namespace gridscope {

namespace {

// A check in progress.
class Check {
 public:
  explicit Check(const Options& options) : options_(options), progress_(3), session_(options, progress_), pipeline_(session_.pipeline()) {
    if (options.frames == 1 && session_.capture()) frameCount_ = session_.frameCount();
    if (options.stability > 0) session_.mustRebuild();
    needsTruth_ = !haveFigures(options.budgets, checkJson(session_, shapeOf(false), 0));
    checkBudgets(options.budgets, checkJson(session_, shapeOf(needsTruth_), 0));
    progress_.plan(uint64_t(frameCount_) + (options.stability > 0 ? 1 : 0));
  }

  int run() {
    for (uint32_t frame = 0; frame < frameCount_; ++frame) {
      progress_.step(printed("frame %u of %u", frame + 1, frameCount_));
      if (capturedGrid())
        checkCaptured(frame);
      else
        checkBuilt(frame);
    }
    if (options_.stability > 0) compareOrders();
    progress_.clear();
    return finish();
  }

 private:
  bool capturedGrid() const { return session_.capture() && !session_.capture()->frames.front().grid.empty(); }

  // A report with every figure that there will be, before any is known.
  CheckReport shapeOf(bool withTruth) const {
    CheckReport shape{.frames = std::vector<CheckedFrame>(frameCount_)};
    for (uint32_t frame = 0; frame < frameCount_; ++frame) {
      if (withTruth) shape.frames[frame].truth.emplace();
      if (session_.hasCapturedHits(frame)) shape.frames[frame].foreignHits = 0;
    }
    if (options_.stability > 0) shape.stability.emplace();
    return shape;
  }

  void add(const char* stage, uint32_t frame, std::vector<Invariant> invariants) {
    report_.stages.push_back({.stage = stage, .frame = frame, .invariants = std::move(invariants)});
  }

  // The stages that make a grid, each with what must hold behind it.
  void checkBuilt(uint32_t frame) {
    if (frame == 0) {
      session_.build();
      built_ = pipeline_.grid();
    }
    const uint64_t triedByBuild = pipeline_.buildReport().tried;
    session_.update(frame);
    const Grid updated = pipeline_.grid();
    const Demand demand(updated.parameters, pipeline_.numbered(), pipeline_.worldTriangles());
    if (frame == 0) {
      add("build", frame,
          testGrid({.grid = built_, .scene = pipeline_.numbered(), .demand = &demand, .tried = triedByBuild, .dynamicAdded = false}));
      built_ = {};
    }
    add("update", frame,
        testGrid({.grid = updated, .scene = pipeline_.numbered(), .demand = &demand, .tried = pipeline_.referencesTried()}));
    checkTrace(frame, updated);
  }

  // The grid of a capture: built by this program, what it promises; by another, what every grid must keep to.
  void checkCaptured(uint32_t frame) {
    if (frame == 0) session_.build();
    session_.update(frame);
    const Grid grid = pipeline_.grid();
    GridFacts facts{.grid = grid, .scene = pipeline_.numbered(), .builtBy = session_.builtBy()};
    std::optional<Demand> demand;
    if (facts.builtBy.empty()) {
      demand.emplace(grid.parameters, pipeline_.numbered(), pipeline_.worldTriangles());
      facts.demand = &*demand;
      facts.tried = demand->total();
    }
    add("captured", frame, testGrid(facts));
    checkTrace(frame, grid);
  }

  // The trace, and the hits that a capture holds: those are judged.
  void checkTrace(uint32_t frame, const Grid& before) {
    session_.makeRays(frame);
    pipeline_.trace(false);
    const TraceParameters& trace = pipeline_.parameters().trace;
    const std::vector<Ray> rays = pipeline_.rays();
    std::vector<Invariant> traced = testFrameHits(pipeline_.numbered(), trace, rays, pipeline_.hits());
    traced.push_back(testGridKept(before, pipeline_.grid()));
    add("trace", frame, std::move(traced));

    CheckedFrame checked{.grid = countGrid(before), .foreignHits = session_.useCapturedHits(frame)};
    const std::vector<Hit> hits = pipeline_.hits();
    if (checked.foreignHits) add("captured hits", frame, testFrameHits(pipeline_.numbered(), trace, rays, hits));
    checked.rays = countRays(hits);
    if (needsTruth_) checked.truth = tellFrame(pipeline_).totals;
    report_.frames.push_back(std::move(checked));
  }

  void compareOrders() {
    progress_.step("compare builds");
    report_.stability = compareBuilds(pipeline_, options_.stability, [&] { session_.rebuild(frameCount_ - 1); });
  }

  int finish() {
    std::FILE* out = textStream(options_);
    printCheck(out, session_, report_);
    if (options_.validation) std::fprintf(out, "%-12s%u messages\n", "validation", session_.validationMessages());
    std::vector<nlohmann::ordered_json> frames;
    for (size_t frame = 0; frame < report_.frames.size(); ++frame) frames.push_back(checkJson(session_, report_, frame));
    writeJson(options_, frames.back());
    const int budgets = judgeBudgets(options_, frames);
    return report_.broken() > 0 || session_.validationMessages() > 0 ? kExitDifferent : budgets;
  }

  const Options& options_;
  Progress progress_;
  Session session_;
  Pipeline& pipeline_;
  uint32_t frameCount_ = options_.frames;  // of a capture all, where none are named
  bool needsTruth_ = false;                // a budget is about wrong rays, say
  Grid built_;                             // after the build, before the first update
  CheckReport report_;
};

}  // namespace

void addCheckOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  addCheckChoices(command, options);
  addBudgetOption(command, options);
  addJsonOption(command, options);
}

int runCheck(const Options& options) { return Check(options).run(); }

}  // namespace gridscope
