// gridscope explain: every ray of a frame beside the exact answer: verdicts, causes, and with --verify their proof.
#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>

#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/explain_report.h"
#include "app/report/report.h"
#include "app/session/budget.h"
#include "core/base/error.h"

namespace gridscope {

namespace {

double millisecondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// The bar shows whole percents; any thread may tell.
TruthProgress shownOn(Progress& progress, const std::string& what) {
  auto lock = std::make_shared<std::mutex>();
  auto shown = std::make_shared<int>(-1);
  return [&progress, what, lock, shown](float done) {
    std::lock_guard guard(*lock);
    const int percent = int(100.0f * done);
    if (percent > *shown) progress.say(printed("%s, %d %%", what.c_str(), *shown = percent));
    return true;
  };
}

// What there is to say before the work: of budgets' figures, which ones there will be.
ExplainReport emptyExplain(const Session& session, const Options& options) {
  ExplainReport report;
  report.frameNumber = options.frame;
  report.width = session.pipeline().settings().width;
  report.countsRefused = gridAbilities(session.pipeline().parameters().grid).countsRefusals;
  if (options.verify) report.proofs.emplace();
  if (session.hasCapturedHits(options.frame)) report.foreignHits = 0;
  return report;
}

std::optional<uint32_t> pixelOf(const Options& options, const FrameSettings& settings) {
  if (std::ranges::find(options.given, "--pixel") == options.given.end()) return std::nullopt;
  const uint32_t x = options.captures.pixelX, y = options.captures.pixelY;
  if (x >= settings.width || y >= settings.height)
    throw Error(printed("--pixel %u,%u: the frame has %u x %u pixels", x, y, settings.width, settings.height));
  return y * settings.width + x;
}

ExplainReport makeReport(const Options& options, Session& session, Progress& progress) {
  Pipeline& pipeline = session.pipeline();
  ExplainReport report = emptyExplain(session, options);
  report.foreignHits = session.useCapturedHits(options.frame);
  report.grid = pipeline.gridTotals();
  report.explainMs = millisecondsOf([&] { report.frame = tellFrame(pipeline, shownOn(progress, "explain")); });
  report.ledger = makeLedger(report.frame);
  report.worst = worstRays(report.frame, options.worst);
  if (options.verify) report.proveMs = millisecondsOf([&] { report.proofs = proveFrame(report.frame, shownOn(progress, "prove")); });
  return report;
}

nlohmann::ordered_json resultsOf(const Session& session, const ExplainReport& report) {
  const FrameParameters& parameters = session.pipeline().parameters();
  nlohmann::ordered_json json = explainJson(report, session.names());
  json.update(deviceJson(session));
  json["size"] = {session.pipeline().settings().width, session.pipeline().settings().height};
  json["frame"] = report.frameNumber;
  json["scene"] = sceneJson(session);
  json["grid"] = gridJson(parameters.grid);
  json["traversal"] = traversalWord(parameters.trace.traversal);
  return json;
}

void printHeading(std::FILE* out, const Session& session, const ExplainReport& report) {
  const Pipeline& pipeline = session.pipeline();
  std::fprintf(out, "%s, %u x %u rays, %s, %s on %s\n", session.scene().name.c_str(), pipeline.settings().width, pipeline.settings().height,
               gridText(pipeline.parameters().grid).c_str(), traversalWord(pipeline.parameters().trace.traversal),
               session.deviceName().c_str());
  if (session.frameCount() > 1) std::fprintf(out, "frame %u of frames 0 to %u\n", report.frameNumber, session.frameCount() - 1);
  if (report.foreignHits.value_or(0) > 0) std::fprintf(out, "%s\n", foreignHitsText(*report.foreignHits).c_str());
  std::fprintf(out, "\n");
}

}  // namespace

void addExplainOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  addFrameNumberOption(command, options);
  addTruthOptions(command, options);
  addPixelOption(command, options);
  addBudgetOption(command, options);
  addJsonOption(command, options);
}

int runExplain(const Options& options) {
  Progress progress(6);
  Session session(options, progress);
  Pipeline& pipeline = session.pipeline();
  const std::optional<uint32_t> pixel = pixelOf(options, pipeline.settings());
  checkBudgets(options.budgets, resultsOf(session, emptyExplain(session, options)));

  // One frame.
  progress.step("trace");
  session.build();
  session.update(options.frame);
  session.makeRays(options.frame);
  pipeline.trace(false);

  const ExplainReport report = makeReport(options, session, progress);
  progress.clear();

  const CaptureNames names = session.names();
  std::FILE* out = textStream(options);
  printHeading(out, session, report);
  printExplain(out, report, names);
  nlohmann::ordered_json json = resultsOf(session, report);
  if (pixel) {
    const ToldRay told = tellRay(report, names, *pixel);
    std::fprintf(out, "\n%s", plainText(told.story).c_str());
    json["pixel"] = pixelJson(report, names, told);
  }
  writeJson(options, json);
  const int budgets = judgeBudgets(options, {json});
  return session.validationMessages() > 0 ? kExitDifferent : budgets;
}

}  // namespace gridscope
