// gridscope capture: frames of a scene into a file.
#include <chrono>

#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/capture_pictures.h"
#include "app/report/report.h"
#include "app/session/capture_files.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "core/capture/capture.h"
#include "core/pipeline/frame_capture.h"

namespace gridscope {

namespace {

// The capture without its frames: of a scene, or of the capture that stands in its place.
Capture beginCapture(const Session& session, const Options& options) {
  Capture capture = startCapture(session.pipeline(), session.names(), session.bounds());
  capture.writer = std::string(kWriterName) + kVersion;
  capture.device = session.deviceName();
  capture.driver = session.deviceReport().driver;
  capture.note = options.captures.note;
  if (const Capture* before = session.capture()) {
    // What a foreign engine built stays its own: that name says from where a replay begins.
    if (!builtHere(*before)) capture.writer = before->writer;
    if (capture.note.empty()) capture.note = before->note;
    capture.unknownEntries = before->unknownEntries;
    capture.unknownKeys = before->unknownKeys;
    capture.scene.materials = before->scene.materials;
  }
  return capture;
}

// All frames, the session's stages run for each.
Capture captureFrames(Session& session, const Options& options, Progress& progress) {
  const CaptureProducts& products = options.captures.products;
  Pipeline& pipeline = session.pipeline();
  Capture capture;
  session.build();
  for (uint32_t frame = 0; frame < options.captures.sequence; ++frame) {
    progress.step(printed("frame %u of %u", frame + 1, options.captures.sequence));
    session.update(frame);
    session.makeRays(frame);
    pipeline.trace(true);
    if (frame == 0) capture = beginCapture(session, options);
    if (frame == 0 && products.preview) capture.preview = pngBytes(plainView(pipeline, "final"));
    capture.frames.push_back(takeFrame(pipeline, products, session.frameTime(frame)));
  }
  return capture;
}

}  // namespace

void addCaptureOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  addCaptureFileOptions(command, options);
  addJsonOption(command, options);
}

int runCapture(const Options& options) {
  const std::filesystem::path& file = options.captures.output;
  if (file.empty()) throw Error("no file to write; give -o FILE.gridcap");
  if (!isCapturePath(file)) throw Error("-o " + file.string() + ": the name of a capture ends in .gridcap");
  Progress progress(4 + uint64_t(options.captures.sequence));
  Session session(options, progress);
  const Capture capture = captureFrames(session, options, progress);

  progress.step("write");
  const auto start = std::chrono::steady_clock::now();
  writeCapture(file, capture);
  const double writeMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  progress.clear();

  const uint64_t bytes = std::filesystem::file_size(file);
  std::fprintf(textStream(options), "%s: %zu frame%s of %s, %s, written in %.0f ms\n", file.string().c_str(), capture.frames.size(),
               capture.frames.size() == 1 ? "" : "s", session.scene().name.c_str(), byteText(bytes).c_str(), writeMs);
  writeJson(options, {{"file", file.string()},
                      {"frames", capture.frames.size()},
                      {"bytes", bytes},
                      {"writeMs", writeMs},
                      {"scene", sceneJson(session)},
                      {"grid", gridJson(capture.grid)},
                      {"device", session.deviceName()}});
  return session.validationMessages() > 0 ? kExitDifferent : kExitDone;
}

}  // namespace gridscope
