// gridscope check: the stages of a frame, and after each of them everything that must hold; the order of arrival; budgets.
#include "app/check_report.h"
#include "app/commands.h"
#include "app/text.h"
#include "core/error.h"
#include "core/frame_capture.h"
#include "core/invariants_place.h"
#include "core/invariants_rays.h"

namespace gridscope {

namespace {

// A check in progress.
class Check {
 public:
  Check(const Options& options, uint64_t steps) : options_(options), progress_(steps), session_(options, progress_), pipeline_(session_.pipeline()) {
    if (options.frames == 1 && session_.capture()) frameCount_ = uint32_t(session_.capture()->frames.size());
  }

  int run() {
    for (uint32_t frame = 0; frame < frameCount_; ++frame) {
      progress_.step(printed("frame %u of %u", frame + 1, frameCount_));
      if (capturedGrid()) checkCaptured(frame);
      else checkBuilt(frame);
    }
    if (options_.stability > 0) compareOrders();
    if (budgetsNeedTruth(options_)) {
      progress_.step("truth");
      report_.truth = tellFrame(pipeline_).totals;
    }
    progress_.clear();
    return finish();
  }

 private:
  bool capturedGrid() const { return session_.capture() && !session_.capture()->frames.front().grid.empty(); }
  bool foreign() const { return capturedGrid() && !builtHere(*session_.capture()); }

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
      CheckedStage build{.stage = "build", .frame = frame, .invariants = testCells(built_, pipeline_.numbered(), &triedByBuild)};
      addPlaces(build, {built_, demand, false});
      report_.stages.push_back(std::move(build));
      built_ = {};
    }
    const uint64_t tried = pipeline_.referencesTried();
    CheckedStage update{.stage = "update", .frame = frame, .invariants = testCells(updated, pipeline_.numbered(), &tried)};
    addPlaces(update, {updated, demand, true});
    report_.stages.push_back(std::move(update));
    checkTrace(frame, updated);
  }

  // The grid of a capture: built by this program, what it promises; by another, what every grid must keep to.
  void checkCaptured(uint32_t frame) {
    if (frame == 0) session_.build();
    session_.update(frame);
    const Grid grid = pipeline_.grid();
    if (foreign()) {
      report_.stages.push_back({.stage = "captured", .frame = frame, .invariants = foreignInvariants(grid)});
    } else {
      const Demand demand(grid.parameters, pipeline_.numbered(), pipeline_.worldTriangles());
      const uint64_t tried = demand.total();
      CheckedStage stage{.stage = "captured", .frame = frame, .invariants = testCells(grid, pipeline_.numbered(), &tried)};
      addPlaces(stage, {grid, demand, true});
      report_.stages.push_back(std::move(stage));
    }
    checkTrace(frame, grid);
  }

  std::vector<Invariant> foreignInvariants(const Grid& grid) const {
    std::vector<Invariant> invariants = testCells(grid, pipeline_.numbered(), nullptr);
    const std::string by = "the grid was built by " + session_.capture()->writer;
    for (Invariant& invariant : invariants)
      if (invariant.key == "staticFirst") invariant = {.key = invariant.key, .name = "static before dynamic", .whyNot = by + ": its order is its own"};
    invariants.push_back({.key = "placed", .name = "each triangle is where the overlap test puts it", .whyNot = by + ": its overlap test is not known"});
    invariants.push_back({.key = "nothingStale", .name = "nothing stale", .whyNot = by + ": its overlap test is not known"});
    return invariants;
  }

  static void addPlaces(CheckedStage& stage, const PlaceInput& input) {
    stage.invariants.push_back(testStale(input));
    stage.invariants.push_back(testPlacement(input));
  }

  void checkTrace(uint32_t frame, const Grid& before) {
    session_.makeRays(frame);
    pipeline_.trace(false);
    const std::vector<Ray> rays = pipeline_.rays();
    const std::vector<Hit> hits = pipeline_.hits();
    report_.stages.push_back({.stage = "trace", .frame = frame,
                              .invariants = {testEnds(rays, hits), testHits(pipeline_.numbered(), pipeline_.parameters().trace, hits),
                                             testGridKept(before, pipeline_.grid())}});
    report_.grid = countGrid(before);
    report_.rays = countRays(hits);
  }

  void compareOrders() {
    progress_.step("compare builds");
    const uint32_t last = frameCount_ - 1;
    report_.stability = compareBuilds(pipeline_, options_.stability, [&] { session_.rebuild(last); });
    if (!capturedGrid()) return;
    session_.update(last);  // the truth is of the captured grid
    pipeline_.trace(false);
  }

  int finish() {
    std::FILE* out = textStream(options_);
    printCheck(out, session_, report_);
    if (options_.validation) std::fprintf(out, "%-12s%u messages\n", "validation", session_.validationMessages());
    const nlohmann::ordered_json json = checkJson(session_, report_);
    writeJson(options_, json);
    const int budgets = judgeBudgets(options_, json);
    return report_.broken() > 0 || session_.validationMessages() > 0 ? kExitDifferent : budgets;
  }

  const Options& options_;
  Progress progress_;
  Session session_;
  Pipeline& pipeline_;
  uint32_t frameCount_ = options_.frames;  // of a capture all, where none are named
  Grid built_;                         // after the build, before the first update
  CheckReport report_;
};

}  // namespace

void addCheckOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  addCheckChoices(command, options);
  addBudgetOption(command, options);
  addJsonOption(command, options);
}

int runCheck(const Options& options) {
  const uint64_t steps = 2 + uint64_t(options.frames) + (options.stability > 0 ? 1 : 0) + (budgetsNeedTruth(options) ? 1 : 0);
  return Check(options, steps).run();
}

}  // namespace gridscope
