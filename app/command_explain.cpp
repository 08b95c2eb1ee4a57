// gridscope explain: every ray of a frame beside the exact answer: verdicts, causes, and with --verify their proof.
#include <algorithm>
#include <chrono>
#include <cstring>
#include <memory>
#include <mutex>

#include "app/budget.h"
#include "app/commands.h"
#include "app/explain_report.h"
#include "app/report.h"
#include "app/text.h"
#include "core/error.h"

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

std::optional<uint32_t> pixelOf(const Options& options, const FrameSettings& settings) {
  if (std::ranges::find(options.given, "--pixel") == options.given.end()) return std::nullopt;
  const uint32_t x = options.captures.pixelX, y = options.captures.pixelY;
  if (x >= settings.width || y >= settings.height)
    throw Error(printed("--pixel %u,%u: the frame has %u x %u pixels", x, y, settings.width, settings.height));
  return y * settings.width + x;
}

// A capture's own hits are what is explained. Returns how many of them are not what the trace has just ended with: another engine's, say.
uint64_t useCapturedHits(Session& session) {
  if (!session.capture() || session.capture()->frames.front().hits.empty()) return 0;
  const std::vector<Hit>& captured = session.capture()->frames.front().hits;
  const std::vector<Hit> traced = session.pipeline().hits();
  uint64_t different = 0;
  for (size_t i = 0; i < traced.size(); ++i) different += std::memcmp(&traced[i], &captured[i], sizeof(Hit)) != 0 ? 1 : 0;
  session.pipeline().useHits(captured);
  return different;
}

ExplainReport makeReport(const Options& options, Session& session, Progress& progress) {
  Pipeline& pipeline = session.pipeline();
  ExplainReport report;
  report.width = pipeline.settings().width;
  report.grid = pipeline.gridTotals();
  report.explainMs = millisecondsOf([&] { report.frame = tellFrame(pipeline, shownOn(progress, "explain")); });
  report.tried = report.grid.stored() + report.grid.refused();
  report.ledger = makeLedger(report.frame);
  report.worst = worstRays(report.frame, options.worst);
  if (options.verify) report.proveMs = millisecondsOf([&] { report.proofs = proveFrame(report.frame, shownOn(progress, "prove")); });
  return report;
}

}  // namespace

void addExplainOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
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

  // One frame.
  progress.step("trace");
  session.build();
  session.update(0);
  session.makeRays(0);
  pipeline.trace(false);
  const uint64_t foreign = useCapturedHits(session);

  const ExplainReport report = makeReport(options, session, progress);
  progress.clear();

  const CaptureNames names = session.names();
  std::FILE* out = textStream(options);
  const FrameSettings& settings = pipeline.settings();
  const char* traversal = pipeline.parameters().trace.traversal == kTraversalDda ? "dda" : "segment";
  std::fprintf(out, "%s, %u x %u rays, %s, %s on %s\n\n", session.scene().name.c_str(), settings.width, settings.height,
               gridText(pipeline.parameters().grid).c_str(), traversal, session.deviceName().c_str());
  if (foreign > 0) std::fprintf(out, "%s of the capture's hits are not what this trace ends with\n\n", grouped(foreign).c_str());
  printExplain(out, report, names);
  nlohmann::ordered_json json = explainJson(report, names);
  if (pixel) {
    const std::string story = plainText(tellRay(report, names, *pixel));
    std::fprintf(out, "\n%s", story.c_str());
    json["pixel"] = {{"x", *pixel % settings.width}, {"y", *pixel / settings.width}, {"story", story}};
  }
  json.update(deviceJson(session));
  json["size"] = {settings.width, settings.height};
  json["scene"] = sceneJson(session);
  json["grid"] = gridJson(pipeline.parameters().grid);
  json["traversal"] = traversal;
  if (session.capture()) json["foreignHits"] = foreign;
  writeJson(options, json);
  const int budgets = judgeBudgets(options, json);
  return session.validationMessages() > 0 ? kExitDifferent : budgets;
}

}  // namespace gridscope
