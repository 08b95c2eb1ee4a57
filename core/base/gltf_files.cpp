// Bytes that a glTF file asks for, see gltf_files.h.
#include "core/base/gltf_files.h"

#include <fstream>

#include "core/base/error.h"

namespace gridscope {

namespace fs = std::filesystem;

namespace {

int base64Value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' || c == '-' ? 62 : c == '/' || c == '_' ? 63 : -1;
}

Bytes decodeBase64(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  uint32_t bits = 0;
  int bitCount = 0;
  for (char c : text) {
    const int value = base64Value(c);
    if (value < 0) throw Error("a data: URI holds a character that is not base64; export the file again");
    bits = bits << 6 | static_cast<uint32_t>(value);
    bitCount += 6;
    if (bitCount < 8) continue;
    bitCount -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> bitCount));
    bits &= (1u << bitCount) - 1u;
  }
  return bytes;
}

int hexValue(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

std::string percentDecode(std::string_view uri) {
  std::string text;
  for (size_t i = 0; i < uri.size(); ++i) {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && hexValue(uri[i + 1]) >= 0 && hexValue(uri[i + 2]) >= 0;
    text += coded ? static_cast<char>(hexValue(uri[i + 1]) * 16 + hexValue(uri[i + 2])) : uri[i];
    if (coded) i += 2;
  }
  return text;
}

Bytes readDataUri(std::string_view uri) {
  const size_t comma = uri.find(',');
  if (comma == std::string_view::npos || uri.substr(0, comma).find(";base64") == std::string_view::npos)
    throw Error("a data: URI is not base64; export the file again");
  return decodeBase64(uri.substr(comma + 1));
}

// Links inside the folder are followed: whoever made the folder made them. Only the file's own text is not trusted.
fs::path pathInsideFolder(const std::string& uri, const fs::path& folder) {
  std::string text = percentDecode(uri);
  for (char& c : text) c = c == '\\' ? '/' : c;
  const fs::path path = text;
  const bool odd = text.empty() || text.find('\0') != std::string::npos || text.find(':') < text.find('/');
  bool climbs = false;
  for (const fs::path& part : path) climbs = climbs || part == "..";
  if (odd || climbs || path.is_absolute())
    throw Error("'" + plainName(uri) + "' is outside the file's own folder; put the file beside the scene and name it without a path");
  return folder / path;
}

}  // namespace

Bytes readGltfFile(const fs::path& file, uint64_t limit) {
  std::error_code problem;
  if (!fs::exists(file, problem)) throw Error("there is no such file; check its name and place");
  if (!fs::is_regular_file(file, problem)) throw Error("this is not a plain file; name a .gltf or .glb file");
  const uint64_t size = fs::file_size(file, problem);
  if (problem) throw Error("its size can't be read: " + problem.message());
  if (size > limit)
    throw Error("the file has " + std::to_string(size) + " bytes, more than the " + std::to_string(limit) + " that are read; split it");
  Bytes bytes(size);
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (static_cast<uint64_t>(stream.gcount()) != size) throw Error("the file can't be read; check its permissions");
  return bytes;
}

Bytes readGltfUri(const std::string& uri, const fs::path& folder) {
  if (uri.starts_with("data:")) return readDataUri(uri);
  if (folder.empty()) throw Error("'" + plainName(uri) + "' is a file of its own, but the scene was given without a folder; use a .glb");
  const fs::path path = pathInsideFolder(uri, folder);
  try {
    return readGltfFile(path);
  } catch (const Error& error) {
    throw error.within("'" + plainName(uri) + "'");
  }
}

std::string plainName(std::string_view name) {
  constexpr size_t kLongest = 120;
  bool cut = false;
  if (name.size() > kLongest) {
    size_t end = kLongest - 3;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;  // not inside a UTF-8 sequence
    name = name.substr(0, end);
    cut = true;
  }
  std::string plain(name);
  for (char& c : plain) c = static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
  return cut ? plain + "..." : plain;
}

}  // namespace gridscope
