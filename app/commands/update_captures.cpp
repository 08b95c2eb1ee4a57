// gridscope update-captures: captures made anew after a wanted change. Inputs, gather and rays stay; grid, hits, counters and preview are made
// again by this program and device. A foreign grid stays too, and a preview with diffuse maps, which captures do not hold.
#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/capture_pictures.h"
#include "app/report/diff.h"
#include "app/report/report.h"
#include "app/session/capture_files.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "core/checks/replay.h"
#include "core/pipeline/frame_capture.h"

namespace gridscope {

namespace {

// Which products the frames hold.
CaptureProducts heldProducts(const Capture& capture) {
  const CaptureFrame& first = capture.frames.front();
  return {.grid = !first.grid.empty(),
          .gather = !first.gather.empty(),
          .rays = !first.rays.empty(),
          .hits = !first.hits.empty(),
          .counters = !first.counters.empty(),
          .preview = !capture.preview.empty(),
          .exact = !first.exact.empty()};
}

// The frame's products as the pipeline makes them now.
CaptureFrame remadeFrame(Pipeline& pipeline, const Capture& capture, size_t index) {
  const CaptureFrame& old = capture.frames[index];
  if (builtHere(capture))
    pipeline.update(frameInstances(capture, index));
  else
    pipeline.useGrid(old.grid);
  const CaptureProducts held = heldProducts(capture);
  CaptureFrame frame = old;
  if (held.grid && builtHere(capture)) frame.grid = pipeline.grid().words;
  if (!held.rays) return frame;
  pipeline.useRays(old.rays);
  pipeline.trace(true);
  if (held.hits) frame.hits = pipeline.hits();
  if (held.counters) frame.counters = pipeline.counters();
  if (held.exact)
    frame.exact =
        takeFrame(pipeline, {.grid = false, .gather = false, .rays = false, .hits = false, .counters = false, .exact = true}, 0.0f).exact;
  return frame;
}

std::vector<std::byte> remadePreview(Pipeline& pipeline, const Capture& capture) {
  pipeline.gather();
  if (!capture.frames.front().gather.empty()) pipeline.useGather(capture.frames.front().gather);
  if (capture.frames.front().rays.empty()) pipeline.bounce(capture.frames.front().bounce.frame), pipeline.trace(false);
  return pngBytes(plainView(pipeline, "final"));
}

Capture remade(GpuContext& gpu, const Capture& capture) {
  Capture result = capture;
  auto pipeline = std::make_unique<Pipeline>(gpu, pipelineInputs(capture, 0));
  if (builtHere(capture)) pipeline->build();
  for (size_t i = 0; i < capture.frames.size(); ++i) {
    // A foreign grid has no update that could move instances: each frame begins anew.
    if (i > 0 && !builtHere(capture)) pipeline = std::make_unique<Pipeline>(gpu, pipelineInputs(capture, i));
    result.frames[i] = remadeFrame(*pipeline, capture, i);
    if (i == 0 && !capture.preview.empty() && !lacksDiffuseMaps(capture)) result.preview = remadePreview(*pipeline, capture);
  }
  if (builtHere(capture)) result.writer = std::string(kWriterName) + kVersion;
  result.device = gpu.report().name;
  result.driver = gpu.report().driver;
  return result;
}

}  // namespace

void addUpdateCapturesOptions(CLI::App& command, Options& options) {
  addFilesOption(command, options, "Folders of captures, or captures");
  addDeviceOption(command, options);
  addValidationOption(command, options);
  addJsonOption(command, options);
}

int runUpdateCaptures(const Options& options) {
  if (options.onCpu()) throw Error("--device cpu: previews need a Vulkan device; name one, or leave it out");
  const std::vector<std::filesystem::path> files = captureFiles(options.captures.files);
  Progress progress(files.size() + 1);
  progress.step("start the device");
  GpuContext gpu({.device = options.device, .validation = options.validation});
  if (const std::string fault = whyUnsupported(gpu); !fault.empty()) throw Error(fault, kExitDevice);

  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const std::filesystem::path& file : files) {
    progress.step(file.filename().string());
    const Capture before = readCapture(file);
    const Capture after = remade(gpu, before);
    const CaptureDifferences differences = diffCaptures(before, after);
    const bool changed = !differences.equal() || before.preview != after.preview;

    // A file whose products are the same stays as it is, so that nothing shows in the repository's history.
    if (changed) writeCapture(file, after);
    progress.clear();
    std::fprintf(textStream(options), "%-9s %s\n", changed ? "changed" : "unchanged", file.string().c_str());
    for (const std::string& line : differenceLines(differences)) std::fprintf(textStream(options), "          %s\n", line.c_str());
    if (before.preview != after.preview) std::fprintf(textStream(options), "          preview: another picture\n");
    results.push_back({{"file", file.string()}, {"changed", changed}, {"differences", differencesJson(differences)}});
  }
  writeJson(options, {{"captures", results}});
  return gpu.validationMessages() > 0 ? kExitDifferent : kExitDone;
}

}  // namespace gridscope
