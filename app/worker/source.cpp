// See source.h.
#include "app/worker/source.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <thread>

#include "app/base/low_priority.h"
#include "app/session/capture_files.h"
#include "app/session/load_rays.h"
#include "core/pipeline/frame_capture.h"

namespace gridscope {

FrameSource sourceOf(const Options& options) {
  return {.scene = options.scene, .teapots = options.teapots, .moving = options.moving, .rays = options.rays.string()};
}

// Later sources come with the defaults: options were given for the first.
static Options optionsFor(const FrameSource& source, const Options& start) {
  FrameSource first = sourceOf(start);
  first.loadCount = source.loadCount;
  if (first == source) return start;
  Options options;
  options.scene = source.scene;
  options.teapots = source.teapots;
  options.moving = source.moving;
  options.rays = source.rays;
  return options;
}

static std::vector<CameraPose> camerasOf(const Scene& scene, const CameraPose& chosen) {
  std::vector<CameraPose> cameras = scene.cameras;
  const bool known =
      std::ranges::any_of(cameras, [&](const CameraPose& one) { return one.eye == chosen.eye && one.target == chosen.target; });
  if (!known) cameras.insert(cameras.begin(), chosen);
  for (size_t i = 0; i < cameras.size(); ++i)
    if (cameras[i].name.empty()) cameras[i].name = i == 0 ? "default" : "camera " + std::to_string(i);
  return cameras;
}

// Where the frames of a captured sequence were seen from: one camera each where they differ, else the one of all.
static std::vector<CameraPose> camerasOf(const Capture& capture) {
  const CameraPose& first = capture.settings.camera;
  const auto differs = [&](const CaptureFrame& frame) {
    const CameraParameters &a = frame.camera, &b = capture.frames.front().camera;
    return a.eye != b.eye || a.forward != b.forward || a.up != b.up || a.tanHalfHeight != b.tanHalfHeight;
  };
  std::vector<CameraPose> cameras{first};
  if (cameras[0].name.empty()) cameras[0].name = "captured";
  if (std::ranges::none_of(capture.frames, differs)) return cameras;
  const float distance = glm::distance(first.eye, first.target);
  for (size_t i = 1; i < capture.frames.size(); ++i) {
    const CameraParameters& camera = capture.frames[i].camera;
    cameras.push_back({.name = "frame " + std::to_string(i),
                       .eye = camera.eye,
                       .target = camera.eye + distance * camera.forward,
                       .up = camera.up,
                       .verticalFovDegrees = glm::degrees(2.0f * std::atan(camera.tanHalfHeight))});
  }
  return cameras;
}

LoadedSource loadSource(const FrameSource& source, const Options& start) {
  const Options options = optionsFor(source, start);
  LoadedSource loaded{.source = source};
  if (isCapturePath(source.scene)) {
    loaded.capture = readSceneCapture(options);
    LoadedScene scene = sceneOfCapture(options, *loaded.capture);
    loaded.scene = std::move(scene.scene);
    loaded.settings = scene.settings;
    loaded.bounds = loaded.capture->bounds;
    loaded.cameras = camerasOf(*loaded.capture);
    return loaded;
  }
  LoadedScene scene = loadScene(options);
  loaded.scene = std::move(scene.scene);
  loaded.settings = scene.settings;
  LoadedRays rays = loadRays(options);
  if (!rays.rays.empty()) {
    loaded.settings.width = rays.size.width, loaded.settings.height = rays.size.height;
    loaded.rays = std::move(rays.rays);
  }
  loaded.bounds = sceneBounds(loaded.scene);
  loaded.cameras = camerasOf(loaded.scene, loaded.settings.camera);
  for (const Animation& animation : loaded.scene.animations) loaded.duration = std::max(loaded.duration, double(animation.duration));
  return loaded;
}

static std::atomic<uint32_t>& runningLoads() {
  static std::atomic<uint32_t> running = 0;
  return running;
}

std::future<LoadedSource> loadAside(const FrameSource& source, const Options& start) {
  std::packaged_task<LoadedSource()> task([source, start] { return loadSource(source, start); });
  std::future<LoadedSource> loaded = task.get_future();
  ++runningLoads();
  std::thread([task = std::move(task)]() mutable {
    lowerThreadPriority();
    task();
    task = {};  // what nobody took goes before this is said to be over
    --runningLoads();
  }).detach();
  return loaded;
}

uint32_t loadsUnderWay() { return runningLoads(); }

SceneFacts factsOf(const LoadedSource& loaded) {
  SceneFacts facts;
  facts.path = loaded.source.scene;
  facts.name = loaded.capture ? std::filesystem::path(loaded.source.scene).filename().string() : loaded.scene.name;
  facts.bounds = loaded.bounds;
  facts.cameras = loaded.cameras;
  facts.duration = loaded.duration;
  facts.warnings = loaded.scene.warnings;
  facts.ownSettings = loaded.settings;
  if (loaded.capture) {
    facts.names = loaded.capture->names;
    facts.captureFrames = uint32_t(loaded.capture->frames.size());
    facts.foreign = !gridAbilities(loaded.capture->grid).built;
    facts.note = loaded.capture->note;
    facts.lacksDiffuseMaps = lacksDiffuseMaps(*loaded.capture);
    facts.meshOfInstance.resize(facts.names.instances.size());
    for (const InstanceSource& source : loaded.capture->scene.sources)
      if (source.sceneInstance < facts.meshOfInstance.size() && source.mesh < facts.names.meshes.size())
        facts.meshOfInstance[source.sceneInstance] = facts.names.meshes[source.mesh];
  } else {
    facts.names = namesOf(loaded.scene);
    for (const SceneInstance& instance : loaded.scene.instances) facts.meshOfInstance.push_back(loaded.scene.meshes[instance.mesh].name);
  }
  return facts;
}

}  // namespace gridscope
