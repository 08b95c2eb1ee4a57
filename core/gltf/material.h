// Materials and the images they need, from a checked glTF model.
#pragma once

#include <filesystem>

#include "core/gltf/guard.h"
#include "core/gltf/warnings.h"
#include "core/scene/scene.h"

namespace tinygltf {
class Model;
struct Material;
}  // namespace tinygltf

namespace gridscope {

// Which texture coordinates a material's base colour wants, and KHR_texture_transform's change of them.
struct UvMapping {
  int set = 0;
  vec2 offset{0.0f};
  vec2 scale{1.0f};
  float rotation = 0.0f;  // radians

  vec2 apply(const vec2& uv) const;
};

UvMapping baseColourMapping(const tinygltf::Material& material);

// Fills scene.materials (the file's, in its order) and scene.images (those used as base colour).
void loadMaterials(const tinygltf::Model& model, const CheckedGltf& checked, const std::filesystem::path& folder, Scene& scene,
                   GltfWarnings& warnings);

}  // namespace gridscope
