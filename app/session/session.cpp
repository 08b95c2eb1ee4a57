// See session.h.
#include "app/session/session.h"

#include <algorithm>

#include "app/base/text.h"
#include "app/session/capture_files.h"
#include "core/base/error.h"
#include "core/pipeline/frame_capture.h"

namespace gridscope {

static std::optional<Capture> loadCapture(const Options& options, Progress& progress) {
  if (!isCapturePath(options.scene)) return std::nullopt;
  progress.step("load");
  return readSceneCapture(options);
}

// The scene, announced: a step of the bar before, warnings behind.
static LoadedScene loadSceneWith(const Options& options, const std::optional<Capture>& capture, Progress& progress) {
  progress.step("load");
  LoadedScene loaded = capture ? sceneOfCapture(options, *capture) : loadScene(options);
  for (const std::string& warning : loaded.scene.warnings) progress.note("warning: " + warning);
  return loaded;
}

// The rays, to whose number the frame's size is set.
static LoadedRays loadRaysWith(const Options& options, FrameSettings& settings, Progress& progress) {
  LoadedRays loaded = loadRays(options);
  if (!loaded.note.empty()) progress.note("note: --rays: " + loaded.note);
  if (!loaded.rays.empty()) settings.width = loaded.size.width, settings.height = loaded.size.height;
  return loaded;
}

// Does the device hold frames of that size? Its largest buffer over the pixels is the gather's.
static const FrameSettings& checkFrameFits(const FrameSettings& settings, const DeviceReport& device) {
  const uint64_t mostPixels = device.maxStorageBufferBytes / sizeof(GatherPixel);
  if (settings.width > device.maxImage2DSide || settings.height > device.maxImage2DSide)
    throw Error(printed("--size %ux%u: images on %s are at most %u pixels a side; give a smaller size", settings.width, settings.height,
                        device.name.c_str(), device.maxImage2DSide));
  if (uint64_t(settings.width) * settings.height > mostPixels)
    throw Error(printed("--size %ux%u: frames on %s have at most %s pixels; give a smaller size", settings.width, settings.height,
                        device.name.c_str(), grouped(mostPixels).c_str()));
  return settings;
}

static GpuOptions gpuOptions(const Options& options, Progress& progress) {
  progress.step("start the device");
  return {.device = options.onCpu() ? "" : options.device, .validation = options.validation};
}

static Pipeline makePipeline(GpuContext& gpu, const LoadedScene& loaded, const std::optional<Capture>& capture, const Options& options) {
  const StageDevice device = options.onCpu() ? StageDevice::cpu : StageDevice::vulkan;
  const FrameSettings& settings = checkFrameFits(loaded.settings, gpu.report());
  if (!capture) return Pipeline(gpu, loaded.scene, settings, device);
  PipelineInputs inputs = pipelineInputs(*capture, options.frame);
  inputs.settings = settings;
  return Pipeline(gpu, std::move(inputs), device);
}

Session::Session(const Options& options, Progress& progress)
    : options_(options),
      capture_(loadCapture(options, progress)),
      loaded_(loadSceneWith(options, capture_, progress)),
      rays_(loadRaysWith(options, loaded_.settings, progress)),
      gpu_(gpuOptions(options, progress)),
      pipeline_(makePipeline(gpu_, loaded_, capture_, options)) {
  const int axis = options.slice.axis, layers = pipeline_.parameters().grid.cellCount[axis];
  if (options.slice.index >= layers)
    throw Error(printed("--slice %c:%d: the grid has layers 0 to %d along %c", "xyz"[axis], options.slice.index, layers - 1, "xyz"[axis]));
}

std::string Session::builtBy() const { return canRebuild() ? "" : capture_->writer.empty() ? "another program" : capture_->writer; }

std::string Session::deviceName() const { return options_.onCpu() ? "cpu" : gpu_.report().name; }

CaptureNames Session::names() const { return capture_ ? capture_->names : namesOf(loaded_.scene); }

Bounds Session::bounds() const { return capture_ ? capture_->bounds : loaded_.settings.grid.bounds.value_or(sceneBounds(loaded_.scene)); }

float Session::frameTime(uint32_t frame) const {
  return capture_ ? capturedFrame(frame).timeSeconds : static_cast<float>(options_.time + double(frame) * options_.frameStep);
}

uint32_t Session::frameCount() const { return capture_ ? uint32_t(capture_->frames.size()) : 1; }

void Session::build() {
  if (!capture_ || gridAbilities(capture_->grid).built) pipeline_.build();
}

void Session::update(uint32_t frame) {
  if (!capture_) return pipeline_.update(frameTime(frame));
  const std::vector<Instance> instances = frameInstances(*capture_, frame % capture_->frames.size());
  if (gridAbilities(capture_->grid).updated)
    pipeline_.update(instances);
  else
    pipeline_.useInstances(instances);
  if (!capturedFrame(frame).grid.empty()) pipeline_.useGrid(capturedFrame(frame).grid);
}

bool Session::canRebuild() const { return !capture_ || builtHere(*capture_); }

void Session::mustRebuild() const {
  if (!canRebuild()) throw Error(options_.scene + ": its grid was built by " + builtBy() + ", and can't be built again here");
}

void Session::rebuild(uint32_t frame) {
  mustRebuild();
  pipeline_.build();
  if (capture_)
    pipeline_.update(frameInstances(*capture_, frame % capture_->frames.size()));
  else
    pipeline_.update(frameTime(frame));
}

void Session::makeRays(uint32_t frame) {
  pipeline_.gather();
  if (capture_) {
    const CaptureFrame& captured = capturedFrame(frame);
    if (!captured.gather.empty()) pipeline_.useGather(captured.gather);
    if (!captured.rays.empty())
      pipeline_.useRays(captured.rays);
    else
      pipeline_.bounce(captured.bounce.frame);
  } else if (rays_.rays.empty()) {
    pipeline_.bounce(frame);
  } else {
    pipeline_.useRays(rays_.rays);
  }
}

std::optional<uint64_t> Session::useCapturedHits(uint32_t frame) {
  if (!hasCapturedHits(frame)) return std::nullopt;
  return gridscope::useCapturedHits(pipeline_, capturedFrame(frame).hits);
}

std::string foreignHitsText(uint64_t count) {
  return grouped(count) + " of the capture's hits are not what this trace ends with; they are taken as they are";
}

}  // namespace gridscope
