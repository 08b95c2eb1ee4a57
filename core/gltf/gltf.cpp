// Scenes from glTF 2.0 files, see gltf.h: the guard (guard.h), then tinygltf, then nodes, meshes, materials, animations.
#include "core/gltf/gltf.h"

#include <new>

#include <tiny_gltf.h>

#include "core/base/error.h"
#include "core/gltf/animation.h"
#include "core/gltf/guard.h"
#include "core/gltf/material.h"
#include "core/gltf/mesh.h"
#include "core/gltf/nodes.h"

namespace gridscope {

namespace {

tinygltf::Model parseModel(CheckedGltf& checked) {
  tinygltf::Model model;
  tinygltf::TinyGLTF parser;
  std::string problem, warning;
  if (!parser.LoadASCIIFromString(&model, &problem, &warning, checked.json.data(), static_cast<unsigned>(checked.json.size()), ""))
    throw Error("tinygltf refuses it: " + plainName(problem) + "; export the file again");
  for (Bytes& bytes : checked.buffers) model.buffers.emplace_back().data = std::move(bytes);
  return model;
}

std::string meshName(const tinygltf::Mesh& mesh, size_t index) {
  return mesh.name.empty() ? "mesh " + std::to_string(index) : plainName(mesh.name);
}

// The material that primitives without one get: the specification's, white and rough, but no metal (nothing would be seen of it).
uint32_t defaultMaterial(Scene& scene, const tinygltf::Model& model) {
  if (scene.materials.size() == model.materials.size()) scene.materials.push_back({.name = "default", .metallic = 0.0f, .roughness = 1.0f});
  return static_cast<uint32_t>(model.materials.size());
}

// All primitives of one mesh.
void loadMesh(const tinygltf::Model& model, size_t meshIndex, TriangleBudget& budget, Scene& scene, GltfWarnings& warnings) {
  const tinygltf::Mesh& source = model.meshes[meshIndex];
  const std::string name = meshName(source, meshIndex);
  for (const tinygltf::Primitive& primitive : source.primitives) {
    auto mesh = [&] {
      try {
        return loadPrimitive(model, primitive, name, budget, warnings);
      } catch (const Error& error) {
        throw error.within("mesh '" + name + "'");
      }
    }();
    if (!mesh) continue;
    mesh->materialIndex = primitive.material >= 0 ? static_cast<uint32_t>(primitive.material) : defaultMaterial(scene, model);
    mesh->name = source.primitives.size() == 1 ? name : name + "/" + scene.materials[mesh->materialIndex].name;
    scene.meshes.push_back(std::move(*mesh));
  }
}

// Meshes of the scene's nodes, in the file's order; returns for each of the file's meshes where its own begin, and one more.
std::vector<uint32_t> loadMeshes(const tinygltf::Model& model, const std::vector<bool>& wanted, Scene& scene, GltfWarnings& warnings) {
  uint64_t bytes = 0;
  for (const tinygltf::Buffer& buffer : model.buffers) bytes += buffer.data.size();
  TriangleBudget budget = TriangleBudget::forBytes(bytes);
  std::vector<uint32_t> begins = {0};
  for (size_t i = 0; i < model.meshes.size(); ++i) {
    if (wanted[i]) loadMesh(model, i, budget, scene, warnings);
    begins.push_back(static_cast<uint32_t>(scene.meshes.size()));
  }
  return begins;
}

Scene buildScene(const tinygltf::Model& model, const CheckedGltf& checked, const std::filesystem::path& folder, GltfWarnings& warnings) {
  Scene scene;
  const NodeTree tree = loadNodes(model, scene);
  std::vector<bool> wanted(model.meshes.size(), false);
  for (int node : tree.fileNodes) {
    if (const int mesh = model.nodes[static_cast<size_t>(node)].mesh; mesh >= 0) wanted[static_cast<size_t>(mesh)] = true;
  }
  loadMaterials(model, checked, folder, scene, warnings);
  const std::vector<uint32_t> meshBegins = loadMeshes(model, wanted, scene, warnings);
  if (scene.meshes.empty()) throw Error("it holds no triangles; name a file with a mesh in its default scene");
  if (scene.materials.empty()) defaultMaterial(scene, model);
  loadInstances(model, tree, meshBegins, scene);
  loadAnimations(model, tree.sceneNodes, scene, warnings);
  markAnimatedInstances(scene);
  const Bounds bounds = sceneBounds(scene);  // refuses what is not finite or too far out
  loadCameras(model, tree, bounds, scene, warnings);
  return scene;
}

}  // namespace

Scene loadGltfMemory(std::span<const std::byte> bytes, const std::string& name, const std::filesystem::path& baseFolder) {
  try {
    GltfWarnings warnings;
    CheckedGltf checked = checkGltf(bytes, baseFolder, warnings);
    const tinygltf::Model model = parseModel(checked);
    Scene scene = buildScene(model, checked, baseFolder, warnings);
    scene.name = std::filesystem::path(name).filename().string();
    scene.warnings = warnings.lines(name);
    return scene;
  } catch (const Error& error) {
    throw error.within(name);
  } catch (const std::bad_alloc&) {
    throw Error(name + ": there is not enough memory for it; close other programs or split the file");
  } catch (const std::exception& exception) {
    throw Error(name + ": it can't be read, " + plainName(exception.what()) + "; export the file again");
  }
}

Scene loadGltf(const std::filesystem::path& file) {
  const std::string name = file.string();
  const Bytes bytes = [&] {
    try {
      return readGltfFile(file);
    } catch (const Error& error) {
      throw error.within(name);
    }
  }();
  const std::filesystem::path folder = file.parent_path().empty() ? "." : file.parent_path();
  return loadGltfMemory(std::as_bytes(std::span(bytes)), name, folder);
}

}  // namespace gridscope
