// Checks a glTF file before tinygltf sees it: Debian's tinygltf 2.7.0 ends the program on some damaged files. What passes holds
// only keys that the loader knows, indices in range, and accessors that lie inside their buffers.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/gltf_files.h"
#include "core/gltf/warnings.h"

namespace gridscope {

struct GltfImageSource {
  std::string name{};  // for messages; the file's name for it, its URI, or "image 3"
  std::string uri{};   // empty: in a buffer view
  int bufferView = -1;
};

struct CheckedGltf {
  std::string json;                     // for tinygltf: without buffers and images
  std::vector<Bytes> buffers;           // at least as long as the document says
  std::vector<GltfImageSource> images;  // not read yet: a texture that can't be read is no reason to refuse the scene
};

CheckedGltf checkGltf(std::span<const std::byte> file, const std::filesystem::path& folder, GltfWarnings& warnings);

}  // namespace gridscope
