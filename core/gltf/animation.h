// The animations of a checked glTF model: translation, rotation and scale of nodes.
#pragma once

#include <span>

#include "core/gltf/warnings.h"
#include "core/scene/scene.h"

namespace tinygltf {
class Model;
}

namespace gridscope {

// sceneNodes gives the scene's node for each of the file's, -1 for one that is not in the scene.
void loadAnimations(const tinygltf::Model& model, std::span<const int32_t> sceneNodes, Scene& scene, GltfWarnings& warnings);

}  // namespace gridscope
