// See replay_jobs.h.
#include "app/report/replay_jobs.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <fstream>
#include <memory>

#include "app/report/capture_pictures.h"
#include "core/base/error.h"
#include "core/capture/capture.h"
#include "core/checks/replay.h"

extern char** environ;

namespace gridscope {

namespace {

namespace fs = std::filesystem;

ReplayReport reportOf(const fs::path& file, const ReplayResult& result) {
  ReplayReport products = ReplayReport::object();
  for (const ReplayedProduct& product : result.products) {
    products[product.name] = {
        {"equal", product.different == 0}, {"different", product.different}, {"total", product.total}, {"first", product.first}};
    products[product.name]["distinct"] = product.distinct;
  }
  return {{"file", file.string()},
          {"verdict", verdictName(result.verdict)},
          {"reason", result.reason},
          {"device", result.device},
          {"products", products}};
}

// One file. A file that can't be read is unusable; the message says why.
ReplayReport replayFile(const fs::path& file, const Options& options, GpuContext* gpu) {
  const CaptureOptions& captures = options.captures;
  ReplayResult result{.device = gpu ? gpu->report().name : "cpu"};
  std::vector<std::string> pictures, leftOut;
  try {
    // All of it, though not all of it is compared: a damaged file must not pass.
    const Capture capture = readCapture(file, {.salvage = captures.salvage});
    leftOut = capture.faults;
    result = replay(capture, {.from = captures.from, .repeat = captures.repeat}, gpu);
    if (!result.reason.empty()) result.reason = file.string() + ": " + result.reason;
    if (result.different && !captures.differences.empty())
      pictures = writeDifference(captures.differences, pictureName(file), sidesOf(capture, *result.different));
  } catch (const Error& error) {
    result.verdict = error.exitCode() == kExitDevice ? Verdict::unsupported : Verdict::unusable;
    result.reason = error.what();
  }
  ReplayReport report = reportOf(file, result);
  report["runs"] = captures.repeat;
  report["pictures"] = pictures;
  if (captures.salvage) report["leftOut"] = leftOut;
  return report;
}

// A process of this program on every jobs-th file, its results in a file.
struct Child {
  pid_t process = -1;
  fs::path results;
  std::vector<fs::path> files;
};

std::vector<std::string> childArguments(const Child& child, const Options& options) {
  const CaptureOptions& captures = options.captures;
  static constexpr const char* kFrom[] = {"auto", "build", "update", "trace"};
  std::vector<std::string> arguments = {"gridscope", "replay",
                                        "--json",    child.results.string(),
                                        "--from",    kFrom[static_cast<size_t>(captures.from)],
                                        "--repeat",  std::to_string(captures.repeat)};
  if (!options.device.empty()) arguments.insert(arguments.end(), {"--device", options.device});
  if (!captures.differences.empty()) arguments.insert(arguments.end(), {"--out", captures.differences.string()});
  if (captures.salvage) arguments.push_back("--salvage");
  if (options.validation) arguments.push_back("--validation");
  for (const fs::path& file : child.files) arguments.push_back(file.string());
  return arguments;
}

void start(Child& child, const Options& options) {
  std::vector<std::string> arguments = childArguments(child, options);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);

  // Its text says nothing that its results don't; what a driver has to say goes to standard error as ever.
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  const int fault = posix_spawn(&child.process, "/proc/self/exe", &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (fault != 0) throw Error(std::string("--jobs: a process could not be started: ") + std::strerror(fault), kExitDevice);
}

std::vector<ReplayReport> finish(const Child& child) {
  int status = 0;
  waitpid(child.process, &status, 0);
  std::ifstream file(child.results);
  const nlohmann::ordered_json results = nlohmann::ordered_json::parse(file, nullptr, false);
  if (!results.is_discarded() && results.contains("captures") && results["captures"].size() == child.files.size())
    return results["captures"];
  std::vector<ReplayReport> reports;
  const std::string reason =
      WIFSIGNALED(status) ? "its process ended by signal " + std::to_string(WTERMSIG(status)) : "its process gave no result";
  for (const fs::path& path : child.files)
    reports.push_back(reportOf(path, {.verdict = Verdict::unsupported, .reason = path.string() + ": " + reason}));
  return reports;
}

}  // namespace

std::vector<ReplayReport> replayFiles(const std::vector<fs::path>& files, const Options& options, Progress& progress) {
  std::unique_ptr<GpuContext> gpu;
  std::string fault;
  if (!options.onCpu()) {
    progress.step("self-test of the device");
    gpu = std::make_unique<GpuContext>(GpuOptions{.device = options.device, .validation = options.validation});
    fault = whyUnsupported(*gpu);
  }
  std::vector<ReplayReport> reports;
  for (const fs::path& file : files) {
    progress.step(file.filename().string());
    const auto begin = std::chrono::steady_clock::now();
    if (fault.empty())
      reports.push_back(replayFile(file, options, gpu.get()));
    else
      reports.push_back(
          reportOf(file, {.verdict = Verdict::unsupported, .reason = file.string() + ": " + fault, .device = gpu->report().name}));
    reports.back()["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  if (gpu && gpu->validationMessages() > 0)
    throw Error("validation reported " + std::to_string(gpu->validationMessages()) + " messages", kExitDifferent);
  return reports;
}

std::vector<ReplayReport> replayInProcesses(const std::vector<fs::path>& files, const Options& options, Progress& progress) {
  const size_t jobs = std::min<size_t>(options.captures.jobs, files.size());
  std::vector<Child> children(jobs);
  for (size_t i = 0; i < files.size(); ++i) children[i % jobs].files.push_back(files[i]);
  for (size_t i = 0; i < jobs; ++i) {
    children[i].results = fs::temp_directory_path() / ("gridscope_replay_" + std::to_string(getpid()) + "_" + std::to_string(i) + ".json");
    start(children[i], options);
  }

  // In the files' order.
  std::vector<ReplayReport> reports(files.size());
  for (size_t i = 0; i < jobs; ++i) {
    progress.step("process " + std::to_string(i + 1) + " of " + std::to_string(jobs));
    std::vector<ReplayReport> own = finish(children[i]);
    for (size_t k = 0; k < own.size(); ++k) reports[k * jobs + i] = std::move(own[k]);
    std::error_code ignored;
    fs::remove(children[i].results, ignored);
  }
  return reports;
}

}  // namespace gridscope
