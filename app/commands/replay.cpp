// gridscope replay: verdicts on captures, for people, for programs and for CI.
#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/junit.h"
#include "app/report/replay_jobs.h"
#include "app/report/report.h"
#include "app/session/capture_files.h"
#include "core/base/error.h"
#include "core/base/version.h"

namespace gridscope {

namespace {

// Every product that differs, in words; nothing for none.
std::vector<std::string> differences(const ReplayReport& report) {
  std::vector<std::string> lines;
  for (const auto& [name, product] : report["products"].items()) {
    if (!product["equal"])
      lines.push_back(name + ": " + grouped(product["different"].get<uint64_t>()) + " of " + grouped(product["total"].get<uint64_t>()) +
                      " differ; the first: " + product["first"].get<std::string>());
    if (product.value("distinct", 1u) > 1)
      lines.push_back(
          printed("%s: %u distinct results in %u runs", name.c_str(), product["distinct"].get<uint32_t>(), report.value("runs", 1u)));
  }
  return lines;
}

std::string comparedText(const ReplayReport& report) {
  std::vector<std::string> parts;
  for (const auto& [name, product] : report["products"].items()) {
    const uint64_t total = product["total"];
    parts.push_back((total > 0 ? grouped(total) + " " : "") + name);
  }
  const uint32_t runs = report.value("runs", 1u);
  return joined(parts, ", ") + (runs > 1 ? printed(" in %u runs", runs) : "");
}

// A line a file. What gives no verdict is a fault, and goes where faults go.
void print(std::FILE* out, const ReplayReport& report) {
  const std::string verdict = report["verdict"], file = report["file"];
  if (verdict == "unusable" || verdict == "unsupported") {
    std::fprintf(stderr, "gridscope: %s: %s\n", verdict.c_str(), report["reason"].get<std::string>().c_str());
    return;
  }
  std::fprintf(out, "%-10s %s: %s\n", verdict.c_str(), file.c_str(), comparedText(report).c_str());
  for (const std::string& line : differences(report)) std::fprintf(out, "           %s\n", line.c_str());
  for (const std::string& fault : report.value("leftOut", std::vector<std::string>{}))
    std::fprintf(out, "           left out: %s\n", fault.c_str());
  for (const std::string picture : report["pictures"]) std::fprintf(out, "           %s\n", picture.c_str());
}

JUnitCase junitCase(const ReplayReport& report) {
  using Outcome = JUnitCase::Outcome;
  const std::string verdict = report["verdict"];
  JUnitCase one{.name = report["file"], .message = "", .details = "", .seconds = report.value("seconds", 0.0)};
  if (verdict == "equal") return one;
  one.outcome = verdict == "different" ? Outcome::failure : verdict == "unusable" ? Outcome::error : Outcome::skipped;
  const std::vector<std::string> lines = differences(report);
  one.message = lines.empty() ? verdict + ": " + report["reason"].get<std::string>() : lines.front();
  one.details = joined(lines, "\n");
  return one;
}

// A difference is what one looks for, so it goes before a file or a device that gave no verdict.
int exitCodeOf(const std::vector<ReplayReport>& reports) {
  const auto any = [&](const char* verdict) {
    return std::ranges::any_of(reports, [&](const ReplayReport& report) { return report["verdict"] == verdict; });
  };
  if (any("different")) return kExitDifferent;
  if (any("unsupported")) return kExitDevice;
  return any("unusable") ? kExitBadInput : kExitDone;
}

}  // namespace

void addReplayOptions(CLI::App& command, Options& options) {
  addFilesOption(command, options, "Captures, or folders of them");
  addReplayChoices(command, options);
  addDeviceOption(command, options);
  addValidationOption(command, options);
  addJsonOption(command, options);
}

int runReplay(const Options& options) {
  const CaptureOptions& captures = options.captures;
  const std::vector<std::filesystem::path> files = shardOf(captureFiles(captures.files), captures.shard, captures.shards);
  Progress progress(files.size() + 1);
  std::vector<ReplayReport> reports;
  if (!files.empty())
    reports = captures.jobs > 1 && files.size() > 1 ? replayInProcesses(files, options, progress) : replayFiles(files, options, progress);
  progress.clear();

  std::vector<JUnitCase> cases;
  size_t equal = 0;
  for (const ReplayReport& report : reports) {
    print(textStream(options), report);
    cases.push_back(junitCase(report));
    equal += report["verdict"] == "equal" ? 1 : 0;
  }
  if (reports.size() != 1) std::fprintf(textStream(options), "%zu of %zu captures equal\n", equal, reports.size());
  if (!captures.junit.empty()) writeJUnit(captures.junit, "gridscope replay", cases);
  writeJson(options, {{"version", kVersion}, {"captures", reports}});
  return exitCodeOf(reports);
}

}  // namespace gridscope
