// Bytes that a glTF file asks for: the file itself, what its URIs name, text made fit for one line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gridscope {

using Bytes = std::vector<unsigned char>;

// No single file, embedded or beside the scene, may be larger; tinygltf keeps some offsets in 31 bits.
inline constexpr uint64_t kGltfFileLimit = uint64_t{1} << 30;

// The whole file; throws Error when it is missing, not a plain file, or larger than the limit.
Bytes readGltfFile(const std::filesystem::path& file, uint64_t limit = kGltfFileLimit);

// What a URI names: a data: URI's own bytes, or a file beside the scene. Throws Error for everything that would leave the folder.
// An empty folder stands for "no files at all".
Bytes readGltfUri(const std::string& uri, const std::filesystem::path& folder);

// A name from a file as it may stand in a message or a list: one line, valid UTF-8 stays valid, at most 120 bytes.
std::string plainName(std::string_view name);

}  // namespace gridscope
