// See capture_files.h.
#include "app/session/capture_files.h"

#include <algorithm>
#include <array>

#include "app/base/text.h"
#include "core/base/error.h"
#include "core/pipeline/frame_capture.h"

namespace gridscope {

namespace fs = std::filesystem;

// Whatever decides the frame. The builder does not: both make the same bits.
static constexpr std::array kFixedOptions = {
    "--teapots",  "--moving", "--camera",  "--time",      "--frame-step", "--size",         "--texture-size", "--cells",     "--cell-edge",
    "--capacity", "--bounds", "--stretch", "--insertion", "--number-by",  "--overlap",      "--enlargement",  "--update",    "--traversal",
    "--back",     "--ahead",  "--tmin",    "--gap-fill",  "--gate",       "--max-segments", "--seed",         "--roughness", "--rays"};

static bool wasGiven(const Options& options, std::string_view name) {
  return std::ranges::find(options.given, name) != options.given.end();
}

bool isCapturePath(const fs::path& path) { return path.extension() == ".gridcap"; }

std::vector<fs::path> captureFiles(const std::vector<fs::path>& given) {
  std::vector<fs::path> files;
  for (const fs::path& path : given) {
    std::error_code fault;
    if (!fs::is_directory(path, fault)) {
      files.push_back(path);
      continue;
    }
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path, fault))
      if (isCapturePath(entry.path())) found.push_back(entry.path());
    if (fault) throw Error(path.string() + ": can't be listed: " + fault.message());
    if (found.empty()) throw Error(path.string() + ": holds no .gridcap file");
    std::ranges::sort(found);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

std::vector<fs::path> shardOf(const std::vector<fs::path>& files, uint32_t shard, uint32_t shards) {
  std::vector<fs::path> mine;
  for (size_t i = shard - 1; i < files.size(); i += shards) mine.push_back(files[i]);
  return mine;
}

Capture readSceneCapture(const Options& options) {
  for (const char* name : kFixedOptions)
    if (wasGiven(options, name)) throw Error(std::string(name) + ": " + options.scene + " fixes it; leave it out, or start from the scene");
  Capture capture = readCapture(options.scene, {.salvage = options.captures.salvage});
  const uint32_t frames = std::max(options.frames, options.captures.sequence);
  if (frames > capture.frames.size())
    throw Error(std::string(options.frames > 1 ? "--frames " : "--sequence ") + std::to_string(frames) + ": " + options.scene + " holds " +
                std::to_string(capture.frames.size()));
  if (options.frame >= capture.frames.size())
    throw Error("--frame " + std::to_string(options.frame) + ": " + options.scene + " holds " + std::to_string(capture.frames.size()) +
                (capture.frames.size() == 1 ? " frame; leave it out" : " frames, from 0 on"));
  if (frames > 1 && !gridAbilities(capture.grid).updated)
    throw Error("--frames " + std::to_string(frames) + ": " + options.scene +
                " has a foreign grid, which no update can follow; show its first frame, or use gridscope replay");
  if (options.checkCpu && !gridAbilities(capture.grid).built)
    throw Error("--check-cpu: " + options.scene + " has a grid with " + refusalText(capture.grid) +
                ", which the C++ path does not build; use gridscope replay");
  return capture;
}

LoadedScene sceneOfCapture(const Options& options, const Capture& capture) {
  LoadedScene loaded;
  loaded.settings = capture.settings;
  if (wasGiven(options, "--builder")) loaded.settings.grid.builder = options.settings.grid.builder;
  loaded.scene.name = capture.names.scene.empty() ? fs::path(options.scene).stem().string() : capture.names.scene;
  loaded.scene.materials.resize(capture.scene.materials.size());
  loaded.scene.warnings = capture.faults;
  if (lacksDiffuseMaps(capture)) loaded.scene.warnings.push_back("diffuse maps are not in a capture: surfaces show their base colour");
  return loaded;
}

}  // namespace gridscope
