// Captures on the command line: which files are meant, and a capture where a scene is expected.
#pragma once

#include <filesystem>
#include <vector>

#include "app/session/load_scene.h"
#include "app/session/options.h"
#include "core/capture/capture.h"

namespace gridscope {

bool isCapturePath(const std::filesystem::path& path);

// Files as given; a folder stands for the captures in it and in its folders, sorted. Throws Error for what is not there, and when there is none.
std::vector<std::filesystem::path> captureFiles(const std::vector<std::filesystem::path>& given);

// Files of this runner: every shards-th.
std::vector<std::filesystem::path> shardOf(const std::vector<std::filesystem::path>& files, uint32_t shard, uint32_t shards);

// The capture in place of a scene; refuses, by name, options whose settings it fixes. Throws Error.
Capture readSceneCapture(const Options& options);

// What reports say of it as a scene: name, materials, warnings.
LoadedScene sceneOfCapture(const Options& options, const Capture& capture);

}  // namespace gridscope
