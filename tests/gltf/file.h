// Small glTF files made in code, for the tests of the loader.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <stb/stb_image_write.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/gltf/gltf.h"

namespace gridscope {

using nlohmann::json;

inline constexpr int kByte = 5120, kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;

// A glTF file made in code: a document and the one buffer of a .glb.
struct GltfFile {
  json document = {{"asset", {{"version", "2.0"}}}};
  std::string binary;

  template <typename T>
  int addView(const std::vector<T>& values) {
    binary.resize((binary.size() + 3) / 4 * 4);
    document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", values.size() * sizeof(T)}});
    binary.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    return static_cast<int>(document["bufferViews"].size()) - 1;
  }

  template <typename T>
  int add(const std::vector<T>& values, const char* type, int componentType, size_t count) {
    const int view = addView(values);
    document["accessors"].push_back({{"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}});
    return static_cast<int>(document["accessors"].size()) - 1;
  }
  int addVec3(const std::vector<float>& values) { return add(values, "VEC3", kFloat, values.size() / 3); }

  // A mesh of one primitive on a node of its own; returns the primitive.
  json& addMesh(const json& attributes) {
    document["meshes"].push_back({{"name", "thing"}, {"primitives", {{{"attributes", attributes}}}}});
    document["nodes"].push_back({{"mesh", document["meshes"].size() - 1}});
    return document["meshes"].back()["primitives"][0];
  }

  std::string glb() const {
    json finished = document;
    if (!binary.empty()) finished["buffers"] = {{{"byteLength", binary.size()}}};
    std::string text = finished.dump(), data = binary;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    data.resize((data.size() + 3) / 4 * 4, '\0');
    const uint32_t header[5] = {0x46546C67, 2, static_cast<uint32_t>(28 + text.size() + data.size()), static_cast<uint32_t>(text.size()),
                                0x4E4F534A};
    const uint32_t chunk[2] = {static_cast<uint32_t>(data.size()), 0x004E4942};
    return std::string(reinterpret_cast<const char*>(header), sizeof header) + text +
           std::string(reinterpret_cast<const char*>(chunk), sizeof chunk) + data;
  }
};

inline Scene load(const std::string& bytes, const std::filesystem::path& folder = {}) {
  return loadGltfMemory(std::as_bytes(std::span(bytes)), "made.glb", folder);
}
inline Scene load(const GltfFile& file) { return load(file.glb()); }

// The message of the Error that the bytes cause; fails when there is none, or it is not one line that begins with the file's name.
inline std::string refusal(const std::string& bytes, const std::filesystem::path& folder = {}) {
  try {
    load(bytes, folder);
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("made.glb: ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(error.exitCode(), kExitBadInput);
    return message;
  }
  ADD_FAILURE() << "the file was not refused";
  return "";
}
inline std::string refusal(const GltfFile& file) { return refusal(file.glb()); }

inline void expectContains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << '"' << text << "\" does not contain \"" << part << '"';
}

inline const std::vector<float> kCorner = {0, 0, 0, 1, 0, 0, 0, 1, 0};
inline const std::vector<float> kSquare = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

// One triangle, not indexed.
inline GltfFile oneTriangle() {
  GltfFile file;
  file.addMesh({{"POSITION", file.addVec3(kCorner)}});
  return file;
}

// Four vertices and the indices of two triangles.
inline GltfFile indexedSquare() {
  GltfFile file;
  const int positions = file.addVec3(kSquare);
  const int indices = file.add<uint16_t>({0, 1, 2, 2, 1, 3}, "SCALAR", kUnsignedShort, 6);
  file.addMesh({{"POSITION", positions}})["indices"] = indices;
  return file;
}

inline std::vector<vec3> cornersOf(const Scene& scene) { return scene.meshes.at(0).positions; }

inline std::string pngBytes(int width, int height, const std::vector<uint8_t>& rgba) {
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<size_t>(size));
  };
  stbi_write_png_to_func(append, &bytes, width, height, 4, rgba.data(), width * 4);
  return bytes;
}

// A square with texture coordinates whose material's base colour is an image of these bytes.
inline GltfFile texturedSquare(const std::string& image) {
  GltfFile file;
  const int positions = file.addVec3(kSquare);
  const int uvs = file.add<float>({0, 0, 1, 0, 0, 1, 1, 1}, "VEC2", kFloat, 4);
  json& primitive = file.addMesh({{"POSITION", positions}, {"TEXCOORD_0", uvs}});
  primitive["mode"] = 5;
  primitive["material"] = 0;
  file.document["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  file.document["textures"] = {{{"source", 0}}};
  const int view = file.addView(std::vector<char>(image.begin(), image.end()));
  file.document["images"] = {{{"name", "picture"}, {"bufferView", view}, {"mimeType", "image/png"}}};
  return file;
}

}  // namespace gridscope
