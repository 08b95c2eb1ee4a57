// Checks a glTF file before tinygltf sees it, see guard.h. Container, versions and extensions are here; ranges and the node
// tree in ranges.cpp, keys and types in shape.cpp.
#include "core/gltf/guard.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/gltf/ranges.h"
#include "core/gltf/shape.h"

namespace gridscope {

using nlohmann::json;

namespace {

// A parsed value costs up to 100 bytes, and a file can hold one in 2 bytes: 4 million are enough for 65,535 placed meshes.
constexpr uint64_t kJsonValueLimit = 4'000'000;
constexpr int kJsonDepthLimit = 64;
constexpr uint64_t kBufferBytesLimit = uint64_t{2} << 30;

constexpr std::array kSupportedExtensions = {"KHR_texture_transform", "KHR_materials_unlit", "EXT_mesh_gpu_instancing",
                                             "KHR_mesh_quantization"};

struct Container {
  std::string_view json{};
  std::span<const std::byte> binary{};
  bool hasBinary = false;
};

uint32_t wordAt(std::span<const std::byte> bytes, size_t offset) {
  uint32_t word;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

std::string_view asText(std::span<const std::byte> bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

// One chunk of a binary glTF at the offset; throws when it is cut short.
std::span<const std::byte> chunkAt(std::span<const std::byte> file, size_t offset, const char* what) {
  const uint64_t length = wordAt(file, offset);
  const uint64_t left = file.size() - offset - 8;
  if (length > left)
    throw Error("the " + std::string(what) + " chunk ends " + std::to_string(length - left) + " bytes early; copy the file again");
  return file.subspan(offset + 8, length);
}

Container splitBinaryGltf(std::span<const std::byte> file) {
  constexpr uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
  if (file.size() < 20) throw Error("the file ends inside its header; copy the file again");
  if (const uint32_t version = wordAt(file, 4); version != 2)
    throw Error("this is binary glTF of version " + std::to_string(version) + "; export it as glTF 2.0");
  const uint64_t length = wordAt(file, 8);
  if (length > file.size()) throw Error("the file ends " + std::to_string(length - file.size()) + " bytes early; copy the file again");
  if (length < 20 || wordAt(file, 16) != kJsonChunk) throw Error("the file does not begin with a JSON chunk; export it again");
  file = file.first(length);

  const auto jsonChunk = chunkAt(file, 12, "JSON");
  Container container{.json = asText(jsonChunk)};
  const size_t next = 20 + (jsonChunk.size() + 3) / 4 * 4;
  if (next + 8 <= file.size() && wordAt(file, next + 4) == kBinaryChunk) {
    container.binary = chunkAt(file, next, "binary");
    container.hasBinary = true;
  }
  return container;
}

Container split(std::span<const std::byte> file) {
  if (file.empty()) throw Error("the file is empty; copy it again");
  if (asText(file).starts_with("glTF")) return splitBinaryGltf(file);
  return {.json = asText(file)};
}

// Before the parser builds anything: it has no such limits itself, and its callback, which could have them, takes time quadratic in
// the length of an array.
void checkJsonSize(std::string_view text) {
  uint64_t valueCount = 1;
  int depth = 0;
  bool inString = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString && c == '\\') {
      ++i;
    } else if (c == '"') {
      inString = !inString;
    } else if (!inString && (c == '[' || c == '{')) {
      ++depth, ++valueCount;
    } else if (!inString && (c == ']' || c == '}')) {
      --depth;
    } else if (!inString && c == ',') {
      ++valueCount;
    }
    if (depth > kJsonDepthLimit) throw Error("the JSON is nested more than 64 deep; export the file again");
    if (valueCount > kJsonValueLimit) throw Error("the JSON holds more than 4 million values; split the file");
  }
}

json parseJson(std::string_view text) {
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.remove_suffix(1);
  checkJsonSize(text);
  try {
    return json::parse(text.begin(), text.end());
  } catch (const json::exception& exception) {
    std::string reason = exception.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    if (const size_t bracket = reason.find("] "); bracket != std::string::npos) reason = reason.substr(bracket + 2);
    throw Error("this is not a glTF file, or a damaged one: " + plainName(reason));
  }
}

void checkVersion(const json& document) {
  const std::string version = document["asset"]["version"];
  const std::string needed = document["asset"].value("minVersion", "2.0");
  if (!version.starts_with("2.") || !needed.starts_with("2.0"))
    throw Error("this is glTF " + plainName(version.starts_with("2.") ? needed : version) + "; export it as glTF 2.0");
}

std::string join(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + plainName(name);
  return text;
}

std::set<std::string> unsupportedNames(const json& raw, const char* key) {
  std::set<std::string> names;
  const auto list = raw.find(key);
  if (list == raw.end() || !list->is_array()) return names;
  for (const json& name : *list) {
    if (!name.is_string()) throw Error(std::string(key) + " holds something that is not a name; export the file again");
    const std::string text = name;
    if (std::ranges::find(kSupportedExtensions, text) == kSupportedExtensions.end() && names.size() < 8) names.insert(text);
  }
  return names;
}

void checkExtensions(const json& raw, GltfWarnings& warnings) {
  const auto needed = unsupportedNames(raw, "extensionsRequired");
  if (!needed.empty()) throw Error("it requires " + join(needed) + ", which is not supported; export the file without it");
  const auto used = unsupportedNames(raw, "extensionsUsed");
  if (!used.empty()) warnings.add("extensions that are not supported were left out", join(used));
}

// The raw document's member, or null; never throws, whatever the types are.
const json& member(const json& value, const char* key) {
  static const json null;
  const auto found = value.is_object() ? value.find(key) : value.end();
  return value.is_object() && found != value.end() ? *found : null;
}

void notePrimitive(const json& raw, const json& accessors, const std::string& meshName, GltfWarnings& warnings) {
  if (!member(raw, "targets").is_null()) warnings.add("morph targets are not supported, the mesh keeps its base shape", meshName);
  if (member(member(raw, "extensions"), "KHR_draco_mesh_compression").is_null()) return;
  const json& positions = member(member(raw, "attributes"), "POSITION");
  const bool plainCopy = positions.is_number_unsigned() && positions.get<uint64_t>() < accessors.size() &&
                         accessors[positions.get<uint64_t>()].contains("bufferView");
  if (!plainCopy)
    throw Error("mesh " + meshName + " is compressed with KHR_draco_mesh_compression, which is not supported; export it uncompressed");
}

// Warns of what the tables of shape.cpp are about to leave out.
void noteUnsupported(const json& raw, const json& known, GltfWarnings& warnings) {
  const json &meshes = member(raw, "meshes"), &accessors = member(known, "accessors");
  for (size_t i = 0; i < meshes.size(); ++i) {
    const std::string name = "'" + plainName(known["meshes"][i].value("name", "mesh " + std::to_string(i))) + "'";
    for (const json& primitive : meshes[i]["primitives"]) notePrimitive(primitive, accessors, name, warnings);
  }
  const json& nodes = member(raw, "nodes");
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (!member(nodes[i], "skin").is_null())
      warnings.add("skins are not supported, the mesh keeps its bind shape", "node " + std::to_string(i));
  }
  const json& materials = member(raw, "materials");
  for (size_t i = 0; i < materials.size(); ++i) {
    for (const char* map : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
      if (!member(materials[i], map).is_null())
        warnings.add("normal, occlusion and emissive maps are not used", "material " + std::to_string(i));
    }
  }
}

Bytes bufferBytes(const json& buffer, size_t index, const Container& container, const std::filesystem::path& folder) {
  if (buffer.contains("uri")) return readGltfUri(buffer["uri"], folder);
  if (index != 0 || !container.hasBinary) throw Error("it has no data; export the file again, without EXT_meshopt_compression");
  const auto* begin = reinterpret_cast<const unsigned char*>(container.binary.data());
  return Bytes(begin, begin + container.binary.size());
}

std::vector<Bytes> readBuffers(const json& document, const Container& container, const std::filesystem::path& folder) {
  std::vector<Bytes> buffers;
  std::set<std::string> uris;
  uint64_t total = 0;
  if (!document.contains("buffers")) return buffers;
  for (const json& buffer : document["buffers"]) {
    const size_t index = buffers.size();
    const std::string uri = buffer.value("uri", "");
    try {
      // One small file named by a thousand buffers would be read a thousand times.
      if (!uri.empty() && !uri.starts_with("data:") && !uris.insert(uri).second)
        throw Error("another buffer names '" + plainName(uri) + "' too; join the two");
      Bytes bytes = bufferBytes(buffer, index, container, folder);
      const uint64_t wanted = buffer["byteLength"];
      if (bytes.size() < wanted)
        throw Error("it has " + std::to_string(bytes.size()) + " bytes instead of " + std::to_string(wanted) + "; copy the file again");
      if ((total += bytes.size()) > kBufferBytesLimit) throw Error("all buffers together are larger than 2 GiB; split the file");
      buffers.push_back(std::move(bytes));
    } catch (const Error& error) {
      throw error.within("buffer " + std::to_string(index));
    }
  }
  return buffers;
}

std::vector<GltfImageSource> imageSources(const json& document) {
  std::vector<GltfImageSource> sources;
  if (!document.contains("images")) return sources;
  for (const json& image : document["images"]) {
    GltfImageSource source{.uri = image.value("uri", ""), .bufferView = image.value("bufferView", -1)};
    source.name = image.value("name", "");
    if (source.name.empty() && !source.uri.starts_with("data:")) source.name = source.uri;
    if (source.name.empty()) source.name = "image " + std::to_string(sources.size());
    source.name = plainName(source.name);
    sources.push_back(std::move(source));
  }
  return sources;
}

}  // namespace

CheckedGltf checkGltf(std::span<const std::byte> file, const std::filesystem::path& folder, GltfWarnings& warnings) {
  if (file.size() > kGltfFileLimit) throw Error("the file is larger than 1 GiB; split it");
  const Container container = split(file);
  const json raw = parseJson(container.json);
  json document = knownShape(raw);
  checkVersion(document);
  checkExtensions(raw, warnings);
  noteUnsupported(raw, document, warnings);

  CheckedGltf checked;
  checked.buffers = readBuffers(document, container, folder);
  checkRanges(document, checked.buffers);
  checkNodeTree(document);
  checked.images = imageSources(document);

  document.erase("buffers");
  document.erase("images");
  checked.json = document.dump();
  return checked;
}

}  // namespace gridscope
