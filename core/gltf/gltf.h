// Scenes from glTF 2.0 files, .gltf and .glb. Every file is taken for hostile: what comes out is a whole scene or an Error.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "core/scene/scene.h"

namespace gridscope {

// Throws Error whose message begins with the file's name. What was left out or replaced is in Scene::warnings, a line per kind.
Scene loadGltf(const std::filesystem::path& file);

// The same from memory. `name` stands in messages; baseFolder is where other files lie, empty: no other file is read.
Scene loadGltfMemory(std::span<const std::byte> bytes, const std::string& name, const std::filesystem::path& baseFolder);

}  // namespace gridscope
