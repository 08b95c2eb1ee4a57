// Nodes, instances and cameras of a checked glTF model: everything that has a place.
#pragma once

#include <vector>

#include "core/gltf/warnings.h"
#include "core/scene/scene.h"

namespace tinygltf {
class Model;
}

namespace gridscope {

// The nodes of the default scene (or the first, or all roots), parents before children, each node before its next sibling.
struct NodeTree {
  std::vector<int> fileNodes;       // of each of the scene's nodes, the file's
  std::vector<int32_t> sceneNodes;  // of each of the file's nodes, the scene's; -1: not in it
};

NodeTree loadNodes(const tinygltf::Model& model, Scene& scene);

// One instance for each mesh of each node, and for each placement of EXT_mesh_gpu_instancing. The meshes of the file's mesh i are
// meshBegins[i] .. meshBegins[i + 1] of the scene's.
void loadInstances(const tinygltf::Model& model, const NodeTree& tree, const std::vector<uint32_t>& meshBegins, Scene& scene);

// Cameras as they stand at time 0; an orthographic one becomes a perspective one that sees the middle of the scene alike.
void loadCameras(const tinygltf::Model& model, const NodeTree& tree, const Bounds& bounds, Scene& scene, GltfWarnings& warnings);

}  // namespace gridscope
