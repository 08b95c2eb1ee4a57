// gridscope tune: the same frame with other grids and constants; what each costs, and which one to take.
#include <filesystem>

#include "app/base/interrupt.h"
#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/report.h"
#include "app/report/tune_report.h"
#include "core/base/error.h"
#include "core/base/image_file.h"
#include "core/base/write_file.h"
#include "core/tune/choice.h"
#include "core/tune/tune.h"
#include "views/tune_plot.h"

namespace gridscope {

namespace {

namespace fs = std::filesystem;

// The frame of a sweep, unless the person or a built-in scene says another.
constexpr FrameSize kSweepSize{320, 180};

// Time left is what the last rows took, times the rows to come: with rising cells a row takes ever longer.
class TimeLeft {
 public:
  std::string after(size_t done, size_t total) {
    ends_.push_back(Clock::now());
    const size_t span = std::min<size_t>(kRows, ends_.size() - 1);
    if (span == 0 || done >= total) return "";
    const double seconds =
        std::chrono::duration<double>(ends_.back() - ends_[ends_.size() - 1 - span]).count() / double(span) * double(total - done);
    return seconds >= 90.0 ? printed(", about %.0f min left", seconds / 60.0) : printed(", about %.0f s left", seconds);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr size_t kRows = 28;
  std::vector<Clock::time_point> ends_{Clock::now()};
};

void checkPlotName(const fs::path& plot) {
  if (!plot.empty() && plot.extension() != ".svg" && plot.extension() != ".png")
    throw Error("--plot " + plot.string() + ": give a name that ends in .svg or .png");
}

void writeText(const char* option, const fs::path& file, const std::string& text) {
  try {
    writeWholeFile(file, std::as_bytes(std::span(text)));
  } catch (const Error& error) {
    throw error.within(std::string(option) + " " + file.string());
  }
}

void writeFiles(const Options& options, const TuneResult& result) {
  const TuneOptions& tune = options.tune;
  if (!tune.csv.empty()) writeText("--csv", tune.csv, tuneCsv(result));
  if (tune.plot.extension() == ".svg") writeText("--plot", tune.plot, svgOf(drawTune(result)));
  if (tune.plot.extension() == ".png") writePng(tune.plot.string(), pictureOf(drawTune(result), 1.5f));
}

TuneResult sweep(Session& session, const Options& options, Progress& progress) {
  const TuneInput input{.gpu = session.gpu(),
                        .frame = session.pipeline(),
                        .scene = session.capture() ? nullptr : &session.scene(),
                        .bounds = session.bounds(),
                        .timeSeconds = session.frameTime(options.frame),
                        .axes = options.tune.axes,
                        .runs = options.tune.runs};
  Interrupt interrupt;
  TimeLeft left;
  progress.plan(tuneCount(input));
  progress.step("the own setting");
  return tune(input, [&](const TuneStep& step) {
    const std::string last =
        step.last.measured() ? printed("%s: %s wrong", tuneTitle(step.last).c_str(), percentOf(step.last.wrong(), step.last.rays).c_str())
                             : tuneTitle(step.last) + ": can't be tried";
    progress.step(printed("%zu of %zu%s; %s", step.done, step.total, left.after(step.done, step.total).c_str(), last.c_str()));
    return !Interrupt::asked();
  });
}

}  // namespace

void addTuneOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  addFrameNumberOption(command, options);
  addTuneChoices(command, options);
  addJsonOption(command, options);
}

int runTune(const Options& given) {
  checkPlotName(given.tune.plot);
  Options options = given;
  if (!options.size) options.sizeByDefault = kSweepSize;
  Progress progress(3);
  Session session(options, progress);
  session.build();
  session.update(options.frame);
  session.makeRays(options.frame);
  const TuneResult result = sweep(session, options, progress);
  progress.clear();

  std::FILE* out = textStream(options);
  const FrameSettings& settings = session.pipeline().settings();
  std::fprintf(out, "%s on %s, %s; %s rays of %ux%u; %zu settings in %.0f s\n\n", session.scene().name.c_str(),
               session.deviceName().c_str(), session.deviceReport().driver.c_str(), grouped(result.rows[0].rays).c_str(), settings.width,
               settings.height, result.rows.size(), result.seconds);
  if (!session.builtBy().empty())
    std::fprintf(out, "The grid of %s was built by %s; the own setting is the same shape, built here.\n\n", options.scene.c_str(),
                 session.builtBy().c_str());
  printTune(out, result);
  if (result.stopped) std::fprintf(out, "stopped early: the sweep above is what was done until then\n");
  if (!result.fault.empty()) std::fprintf(stderr, "error: the sweep ended at %s\n", result.fault.c_str());
  writeFiles(options, result);
  nlohmann::ordered_json json = deviceJson(session);
  json["scene"] = sceneJson(session);
  json["size"] = {settings.width, settings.height};
  json.update(tuneJson(result));
  writeJson(options, json);
  if (!result.fault.empty()) return kExitDevice;
  return session.validationMessages() > 0 ? kExitDifferent : kExitDone;
}

}  // namespace gridscope
