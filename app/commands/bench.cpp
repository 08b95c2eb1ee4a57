// gridscope bench: GPU time of each stage (with --device cpu: wall time of build, update and trace), over many runs.
#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/report.h"
#include "core/base/error.h"
#include "core/trace/statistics.h"

namespace gridscope {

namespace {

using Json = nlohmann::ordered_json;

struct StageRow {
  const char* name;
  const char* about;
  double (*timeOf)(const StageTimes& times);
  std::vector<double> times;  // milliseconds, one a run
};

std::vector<StageRow> stageRows() {
  return {{"build", "clear and insert the static instances", [](const StageTimes& t) { return t.build; }, {}},
          {"update", "clear and add", [](const StageTimes& t) { return t.clear + t.add; }, {}},
          {"clear", "take dynamic references out", [](const StageTimes& t) { return t.clear; }, {}},
          {"add", "transform and insert the dynamic instances", [](const StageTimes& t) { return t.add; }, {}},
          {"gather", "what the camera sees", [](const StageTimes& t) { return t.gather; }, {}},
          {"bounce", "one glossy ray a pixel", [](const StageTimes& t) { return t.bounce; }, {}},
          {"trace", "the fast trace", [](const StageTimes& t) { return t.trace; }, {}}};
}

// A frame's stages after the build.
void runFrame(Session& session, uint32_t frame) {
  session.update(frame);
  session.makeRays(frame);
  session.pipeline().trace(false);
}

// The build in every run; then updates that follow one another, as in an animation.
std::vector<StageRow> measure(Session& session, const Options& options, Progress& progress) {
  Pipeline& pipeline = session.pipeline();
  std::vector<StageRow> rows = stageRows();

  // Warm-up.
  progress.step("warm up");
  session.build();
  runFrame(session, 0);

  for (uint32_t run = 0; run < options.runs; ++run) {
    progress.step(printed("build %u of %u", run + 1, options.runs));
    session.build();
    rows[0].times.push_back(pipeline.times().build);
  }
  runFrame(session, 0);
  for (uint32_t run = 0; run < options.runs; ++run) {
    progress.step(printed("frame %u of %u", run + 1, options.runs));
    runFrame(session, run + 1);
    for (size_t row = 1; row < rows.size(); ++row) rows[row].times.push_back(rows[row].timeOf(pipeline.times()));
  }
  return rows;
}

double megaraysPerSecond(uint64_t rays, double milliseconds) { return milliseconds > 0.0 ? double(rays) / milliseconds / 1000.0 : 0.0; }

}  // namespace

void addBenchOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  addRunsOption(command, options);
  addJsonOption(command, options);
}

int runBench(const Options& options) {
  Progress progress(3 + 2 * uint64_t(options.runs));
  Session session(options, progress);
  const std::vector<StageRow> rows = measure(session, options, progress);
  progress.clear();

  // Times.
  const uint64_t rays = countRays(session.pipeline().hits()).count;
  Table table("lrrrl");
  table.add({"ms", "min", "median", "max", ""});
  Json stages = Json::object();
  for (const StageRow& row : rows) {
    const Spread spread = spreadOf(row.times);
    table.add({row.name, printed("%.3f", spread.min), printed("%.3f", spread.median), printed("%.3f", spread.max), row.about});
    stages[row.name] = {{"min", spread.min}, {"median", spread.median}, {"max", spread.max}, {"runs", row.times.size()}};
  }
  const double speed = megaraysPerSecond(rays, spreadOf(rows.back().times).median);

  // Text and JSON.
  std::FILE* out = textStream(options);
  const GridParameters& grid = session.pipeline().parameters().grid;
  std::fprintf(out, "%s on %s, %s; %u runs of each stage\n", session.scene().name.c_str(), session.deviceName().c_str(),
               session.deviceReport().driver.c_str(), options.runs);
  std::fprintf(out, "grid of %s: %s; %s rays, %.2f Mrays/s\n\n", gridText(grid).c_str(), byteText(gridByteCount(grid)).c_str(),
               grouped(rays).c_str(), speed);
  table.print(out);
  Json json = deviceJson(session);
  json["scene"] = sceneJson(session);
  json["grid"] = gridJson(grid);
  json["rays"] = {{"count", rays}};
  json["timesMs"] = stages;
  json["mraysPerSecond"] = speed;
  writeJson(options, json);
  return session.validationMessages() > 0 ? kExitDifferent : kExitDone;
}

}  // namespace gridscope
