// See session.h.
#include "app/session.h"

#include <algorithm>

#include "app/text.h"
#include "core/error.h"

namespace gridscope {

// The scene, announced: a step of the bar before, warnings behind.
static LoadedScene loadSceneWith(const Options& options, Progress& progress) {
  progress.step("load");
  LoadedScene loaded = loadScene(options);
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

Session::Session(const Options& options, Progress& progress)
    : options_(options),
      loaded_(loadSceneWith(options, progress)),
      rays_(loadRaysWith(options, loaded_.settings, progress)),
      gpu_(gpuOptions(options, progress)),
      pipeline_(gpu_, loaded_.scene, checkFrameFits(loaded_.settings, gpu_.report()), options.onCpu() ? StageDevice::cpu : StageDevice::vulkan) {
  const int axis = options.slice.axis, layers = pipeline_.parameters().grid.cellCount[axis];
  if (options.slice.index >= layers)
    throw Error(printed("--slice %c:%d: the grid has layers 0 to %d along %c", "xyz"[axis], options.slice.index, layers - 1, "xyz"[axis]));
}

std::string Session::deviceName() const { return options_.onCpu() ? "cpu" : gpu_.report().name; }

float Session::frameTime(uint32_t frame) const { return static_cast<float>(options_.time + double(frame) * options_.frameStep); }

void Session::makeRays(uint32_t frame) {
  pipeline_.gather();
  if (rays_.rays.empty()) pipeline_.bounce(frame);
  else pipeline_.useRays(rays_.rays);
}

}  // namespace gridscope
