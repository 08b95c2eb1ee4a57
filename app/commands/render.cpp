// gridscope render: the stages of every frame, pictures of its views, the statistics table.
#include <chrono>
#include <filesystem>
#include <optional>

#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/findings.h"
#include "app/report/report.h"
#include "core/base/error.h"
#include "core/checks/cpu_check.h"
#include "core/checks/exact_check.h"
#include "views/picture.h"

namespace gridscope {

namespace {

using Clock = std::chrono::steady_clock;

void makeFolder(const std::filesystem::path& folder) {
  std::error_code fault;
  if (!folder.empty()) std::filesystem::create_directories(folder, fault);
  if (fault) throw Error("--out " + folder.string() + ": can't be made: " + fault.message());
}

// A render in progress.
class Render {
 public:
  Render(const Options& options, Clock::time_point start)
      : options_(options), progress_(stepCount(options)), session_(options, progress_), findings_(session_, options) {
    if (options.checkCpu) check_.emplace(session_.pipeline());
    report_.startMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  }

  int run() {
    progress_.step("build");
    session_.build();
    checkStage([](CpuCheck& check) { return check.afterBuild(); });
    for (uint32_t frame = 0; frame < options_.frames && !different(); ++frame) runFrame(frame);
    if (options_.checkExact > 0) compareExact();
    progress_.clear();
    return finish();
  }

 private:
  // Load, device, build; then the stages of each frame and its views; with --check-cpu one more after the build,
  // the update, the fast trace, and (in most cases) the counting trace.
  static uint64_t stepCount(const Options& options) {
    const uint64_t checks = options.checkCpu ? 1 : 0;
    return 3 + checks + uint64_t(options.frames) * (1 + 3 * checks + options.views.size());
  }

  bool different() const { return report_.check && !report_.check->empty(); }

  // Keeps the first difference.
  template <class Check>
  void checkStage(Check check) {
    if (!check_ || different()) return;
    progress_.step("compare with C++");
    report_.check = check(*check_);
  }

  void runFrame(uint32_t frame) {
    Pipeline& pipeline = session_.pipeline();
    progress_.step(printed("frame %u of %u", frame + 1, options_.frames));
    findings_.beforeUpdate();
    session_.update(frame);
    checkStage([](CpuCheck& check) { return check.afterUpdate(); });
    session_.makeRays(frame);

    // The counting trace where counters are shown; then the fast one, whose time is reported. Their hits are the same.
    const bool counting = needsCounters(frame);
    if (counting) {
      pipeline.trace(true);
      checkStage([](CpuCheck& check) { return check.afterTrace(true); });
    }
    pipeline.trace(false);
    checkStage([](CpuCheck& check) { return check.afterTrace(false); });

    // A capture's own hits are what is shown, as they are what is judged.
    report_.foreignHits = session_.useCapturedHits(frame);
    findings_.afterTrace(frame);
    for (const View* view : options_.views) writeView(*view, frame);
    report_.frames.push_back(reportFrame(session_, frame, counting));
  }

  // Only the grid's parameters matter to a hit found without it.
  void compareExact() {
    progress_.step("compare with all triangles");
    Pipeline& pipeline = session_.pipeline();
    const Grid shape{pipeline.parameters().grid, {}};
    const std::vector<Triangle> triangles = pipeline.worldTriangles();
    report_.exact = compareWithExact({shape, pipeline.numbered(), triangles, pipeline.parameters().trace}, pipeline.rays(), pipeline.hits(),
                                     options_.checkExact);
  }

  bool needsCounters(uint32_t frame) const {
    if (frame + 1 == options_.frames) return true;  // the table shows them
    for (const View* view : options_.views)
      if (view->needsCounters) return true;
    return false;
  }

  void writeView(const View& view, uint32_t frame) {
    progress_.step(std::string(view.name));
    const Pipeline::ViewImage image = session_.pipeline().view(view.name, options_.slice, view.needsGrid);
    const std::string number = options_.frames > 1 ? printed(".%04u", frame) : "";
    const std::string file = (options_.out / (std::string(view.name) + number + ".png")).string();
    writePng(file, makeViewPicture(view, image.elements, image.width, image.height, pictureSettings()).picture);
    report_.pictures.push_back(file);
  }

  ViewPictureSettings pictureSettings() const {
    const FrameSettings& settings = session_.pipeline().settings();
    const GridParameters& grid = session_.pipeline().parameters().grid;
    const int axis = options_.slice.axis, layers = grid.cellCount[axis];
    return {.range = options_.range,
            .legend = options_.legend,
            .capacity = static_cast<uint32_t>(grid.capacity),
            .lines = {session_.scene().name + ": " + gridText(grid), refusedFirst(settings.grid)},
            .frameWidth = settings.width,
            .frameHeight = settings.height,
            .sliceAxis = axis,
            .sliceIndex = options_.slice.index < 0 ? layers / 2 : options_.slice.index,
            .sliceCount = layers};
  }

  int finish() {
    std::FILE* out = textStream(options_);
    if (!report_.frames.empty()) printReport(out, session_, report_);
    if (report_.foreignHits.value_or(0) > 0) std::fprintf(out, "%-12s%s\n", "hits", foreignHitsText(*report_.foreignHits).c_str());
    std::fprintf(out, "%-12s%zu in %s\n", "pictures", report_.pictures.size(), options_.out.string().c_str());
    if (report_.check)
      std::fprintf(out, "%-12s%s\n", "check", different() ? report_.check->c_str() : "every product equals the C++ path's");
    if (report_.exact) printExact(out, *report_.exact, session_.pipeline().settings().width);
    if (options_.validation) std::fprintf(out, "%-12s%u messages\n", "validation", session_.validationMessages());
    writeJson(options_, reportJson(session_, report_));
    const bool inexact = report_.exact && report_.exact->differences.size() > kMostExactDifferences;
    return different() || inexact || session_.validationMessages() > 0 ? kExitDifferent : kExitDone;
  }

  const Options& options_;
  Progress progress_;
  Session session_;
  Findings findings_;
  std::optional<CpuCheck> check_;
  RenderReport report_;
};

}  // namespace

void addRenderOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  addPictureOptions(command, options);
  addJsonOption(command, options);
}

int runRender(const Options& options) {
  const Clock::time_point start = Clock::now();
  makeFolder(options.out);
  return Render(options, start).run();
}

}  // namespace gridscope
