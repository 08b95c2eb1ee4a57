// gridscope ray: the steps of one ray as text.
#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/report.h"
#include "app/session/capture_files.h"
#include "core/base/error.h"
#include "core/capture/compare.h"
#include "core/checks/record_check.h"
#include "shaders/shared/trace/triangle_test.h"

namespace gridscope {

namespace {

const char* outcomeName(uint32_t outcome) {
  static constexpr const char* kNames[] = {"starts outside the grid", "the cell visited last: skipped", "empty", "read"};
  return outcome < std::size(kNames) ? kNames[outcome] : "unknown";
}

std::string verdictText(const TestRecord& test) {
  switch (test.verdict) {
    case kTestHit: return printed("hit at t %.7g", test.t);
    case kTestParallel: return "runs along its plane";
    case kTestOutside: return "passes beside it";
    case kTestBefore: return printed("at t %.7g, before the window", test.t);
    case kTestBeyond: return printed("at t %.7g, beyond the window", test.t);
    case kTestFarther: return printed("at t %.7g, farther than the best so far", test.t);
    case kTestAlpha: return printed("at t %.7g, turned down: alpha %u", test.t, test.alphaByte);
    default: return "unknown verdict";
  }
}

void printStep(std::FILE* out, const StepRecord& step, const Comparison& how) {
  std::fprintf(out, "%4d  at %-10.6g %-22s %s", step.segment, step.start, cellText(step.cell).c_str(), outcomeName(step.outcome));
  if (step.outcome == kStepRead)
    std::fprintf(out, ", %d references%s, %.4g from the launch plane", step.stored, step.saturated ? ", saturated" : "", step.travel);
  std::fprintf(out, "\n");
  for (const TestRecord& test : step.tests)
    std::fprintf(out, "        slot %-3u %s: %s\n", test.slot, referenceText(how, test.reference).c_str(), verdictText(test).c_str());
}

nlohmann::ordered_json stepJson(const StepRecord& step, const Comparison& how) {
  nlohmann::ordered_json json = {{"segment", step.segment},
                                 {"start", step.start},
                                 {"cell", {step.cell.x, step.cell.y, step.cell.z}},
                                 {"outcome", outcomeName(step.outcome)},
                                 {"references", step.stored},
                                 {"saturated", step.saturated}};
  json["tests"] = nlohmann::ordered_json::array();
  for (const TestRecord& test : step.tests)
    json["tests"].push_back(
        {{"slot", test.slot}, {"reference", test.reference}, {"name", referenceText(how, test.reference)}, {"verdict", verdictText(test)}});
  return json;
}

// Exit code 1 when the recorded rays do not end as the frame's did.
int compareRandomRays(const Options& options, Session& session) {
  const RecordComparison comparison = compareRecords(session.pipeline(), options.captures.randomPixels);
  const uint32_t width = session.pipeline().settings().width;
  std::FILE* out = textStream(options);
  std::fprintf(out, "%s of %s recorded rays of %s end with the frame's hit\n",
               grouped(comparison.compared - comparison.different.size()).c_str(), grouped(comparison.compared).c_str(),
               session.scene().name.c_str());
  nlohmann::ordered_json json = {{"compared", comparison.compared}, {"different", nlohmann::ordered_json::array()}};
  for (uint32_t pixel : comparison.different) {
    std::fprintf(out, "  %s does not\n", pixelText(pixel, width).c_str());
    json["different"].push_back({pixel % width, pixel / width});
  }
  writeJson(options, json);
  return comparison.different.empty() && session.validationMessages() == 0 ? kExitDone : kExitDifferent;
}

}  // namespace

void addRayOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  addFrameNumberOption(command, options);
  addPixelOption(command, options);
  addRandomPixelsOption(command, options);
  addJsonOption(command, options);
}

int runRay(const Options& options) {
  Progress progress(5);
  Session session(options, progress);
  Pipeline& pipeline = session.pipeline();
  const FrameSettings& settings = pipeline.settings();
  const uint32_t x = options.captures.pixelX, y = options.captures.pixelY;
  if (x >= settings.width || y >= settings.height)
    throw Error(printed("--pixel %u,%u: the frame has %u x %u pixels", x, y, settings.width, settings.height));

  progress.step("trace");
  session.build();
  session.update(options.frame);
  session.makeRays(options.frame);
  if (options.captures.randomPixels > 0) {
    pipeline.trace(false);
    progress.clear();
    return compareRandomRays(options, session);
  }
  const uint32_t pixel = y * settings.width + x;
  const Ray ray = pipeline.rays()[pixel];
  const RayRecord record = pipeline.record(pixel);
  progress.clear();

  const CaptureNames names = session.names();
  const Comparison how{"", "", pipeline.numbered(), &names};
  std::FILE* out = textStream(options);
  std::fprintf(out, "%s of %s: from (%.7g, %.7g, %.7g) along (%.7g, %.7g, %.7g)\n", pixelText(pixel, settings.width).c_str(),
               session.scene().name.c_str(), ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z);
  nlohmann::ordered_json json = {
      {"pixel", {x, y}}, {"valid", ray.valid != 0}, {"hit", hitText(how, record.hit)}, {"steps", nlohmann::ordered_json::array()}};
  for (const StepRecord& step : record.steps) {
    printStep(out, step, how);
    json["steps"].push_back(stepJson(step, how));
  }
  std::fprintf(out, "ends: %s\n", hitText(how, record.hit).c_str());
  writeJson(options, json);
  return session.validationMessages() > 0 ? kExitDifferent : kExitDone;
}

}  // namespace gridscope
