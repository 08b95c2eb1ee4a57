// Writes the seed corpus of the fuzzers: `seeds FOLDER` makes FOLDER/capture and FOLDER/gltf. tests/fuzz/build compiles it.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "core/capture/zip.h"
#include "tests/capture/small_capture.h"

using namespace gridscope;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
}

std::string textOf(std::span<const std::byte> bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

// A capture as a list of entries (fuzz_capture.cpp).
std::string listOf(std::span<const std::byte> file) {
  std::string list(1, '\x01');
  ZipReader zip(file);
  for (const ZipEntry& entry : zip.entries()) {
    list += static_cast<char>(entry.name.size());
    list += entry.name;
    for (int i = 0; i < 3; ++i) list += static_cast<char>(entry.bytes >> (8 * i) & 255);
    list += textOf(zip.read(entry));
  }
  return list;
}

// As a foreign engine writes it: geometry, grid, rays.
std::vector<std::byte> foreign(std::span<const std::byte> file) {
  ZipReader zip(file);
  ZipWriter writer;
  std::string entries;
  for (const ZipEntry& entry : zip.entries()) {
    if (entry.name != "triangles.npy" && entry.name != "grid.npy" && entry.name != "rays_origin.npy" && entry.name != "rays_direction.npy")
      continue;
    const std::vector<std::byte> bytes = zip.read(entry);
    const NpyHeader header = parseNpyHeader(bytes);
    std::string shape = npyShapeText(header.shape);
    shape.front() = '[', shape.back() = ']';
    entries +=
        (entries.empty() ? "" : ",") + ("\"" + entry.name + "\":{\"dtype\":\"" + npyTypeName(header.type) + "\",\"shape\":" + shape + "}");
    writer.add(entry.name, bytes);
  }
  const Capture capture = makeSmallCapture(1);
  const ivec3 cells = capture.grid.cellCount;
  const std::string manifest =
      "{\"format\":\"gridscope capture\",\"version\":1,\"grid\":{\"origin\":[-2,-2,-2],\"cellEdge\":2,\"cellCount\":[" +
      std::to_string(cells.x) + "," + std::to_string(cells.y) + "," + std::to_string(cells.z) +
      "],\"capacity\":1,\"reserved\":2,\"stretchAxis\":\"" + "xyz"[capture.grid.stretchAxis] + "\"},\"entries\":{" + entries + "}}";
  writer.add("manifest.json",
             {reinterpret_cast<const std::byte*>(manifest.data()), reinterpret_cast<const std::byte*>(manifest.data()) + manifest.size()});
  return writer.finish();
}

// A triangle, indexed, with an animation, a camera, a material and a texture in a data: URI.
constexpr const char* kGltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0,"translation":[1,0,0],"children":[2]},{"camera":0},{"mesh":0,"scale":[1,-1,1]}],
"cameras":[{"type":"perspective","perspective":{"yfov":0.8,"znear":0.1}}],
"materials":[{"alphaMode":"MASK","alphaCutoff":0.4,"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.2,1],"roughnessFactor":0.3,"baseColorTexture":{"index":0}}}],
"textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071,"wrapT":33648}],
"images":[{"uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="}],
"meshes":[{"name":"m","primitives":[{"attributes":{"POSITION":1,"TEXCOORD_0":2},"indices":0,"material":0}]}],
"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],"samplers":[{"input":3,"output":4,"interpolation":"LINEAR"}]}],
"accessors":[{"bufferView":0,"componentType":5123,"count":3,"type":"SCALAR"},{"bufferView":1,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[0,0,0]},
{"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"},{"bufferView":3,"componentType":5126,"count":2,"type":"SCALAR"},{"bufferView":4,"componentType":5126,"count":2,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":6},{"buffer":0,"byteOffset":8,"byteLength":36},{"buffer":0,"byteOffset":44,"byteLength":24},
{"buffer":0,"byteOffset":68,"byteLength":8},{"buffer":0,"byteOffset":76,"byteLength":24}],
"buffers":[{"byteLength":100%URI%}]})";

std::string binary() {
  const uint16_t indices[4] = {0, 1, 2, 0};
  const float floats[23] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 2, 0, 0, 0, 1, 2, 3};
  return std::string(reinterpret_cast<const char*>(indices), 8) + std::string(reinterpret_cast<const char*>(floats), 92);
}

std::string word(uint32_t value) { return {char(value & 255), char(value >> 8 & 255), char(value >> 16 & 255), char(value >> 24)}; }

std::string withUri(const std::string& uri) {
  std::string text = kGltf;
  return text.replace(text.find("%URI%"), 5, uri);
}

std::string base64(const std::string& text) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (size_t i = 0; i < text.size(); i += 3) {
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < text.size() ? uint8_t(text[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) result += i + k > text.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
  }
  return result;
}

std::string glb() {
  std::string json = withUri("");
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::string chunks = word(uint32_t(json.size())) + "JSON" + json + word(100) + std::string("BIN\0", 4) + binary();
  return "glTF" + word(2) + word(uint32_t(12 + chunks.size())) + chunks;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::cerr << "usage: seeds FOLDER\n", 2;
  const fs::path folder = arguments[1];
  fs::create_directories(folder / "capture");
  fs::create_directories(folder / "gltf");
  for (size_t frames : {1, 2}) {
    const std::vector<std::byte> file = formatCapture(makeSmallCapture(frames));
    write(folder / "capture" / ("file_" + std::to_string(frames)), std::string(1, '\0') + textOf(file));
    write(folder / "capture" / ("list_" + std::to_string(frames)), listOf(file));
  }
  write(folder / "capture" / "list_foreign", listOf(foreign(formatCapture(makeSmallCapture(1)))));
  write(folder / "gltf" / "triangle.glb", glb());
  write(folder / "gltf" / "triangle.gltf", withUri(",\"uri\":\"data:application/octet-stream;base64," + base64(binary()) + "\""));
  return 0;
}
