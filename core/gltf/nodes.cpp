// Nodes, instances and cameras of a checked glTF model, see nodes.h.
#include "core/gltf/nodes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <tiny_gltf.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/base/error.h"
#include "core/base/gltf_files.h"
#include "core/gltf/accessor.h"

namespace gridscope {

namespace {

constexpr uint64_t kInstanceLimit = 65'535;  // a reference has 16 bits for it
constexpr uint64_t kPlacedTriangleLimit = 64'000'000;

vec3 vec3Of(const std::vector<double>& numbers, const vec3& otherwise) {
  return numbers.size() == 3 ? vec3(numbers[0], numbers[1], numbers[2]) : otherwise;
}

quat unitQuat(const vec4& xyzw) {
  const float length = glm::length(xyzw);
  if (!(length > 1e-12f) || !std::isfinite(length)) return quat(1.0f, 0.0f, 0.0f, 0.0f);
  return quat(xyzw.w / length, xyzw.x / length, xyzw.y / length, xyzw.z / length);
}

Node nodeOf(const tinygltf::Node& source, int fileIndex) {
  Node node;
  node.name = source.name.empty() ? "node " + std::to_string(fileIndex) : plainName(source.name);
  node.translation = vec3Of(source.translation, node.translation);
  node.scale = vec3Of(source.scale, node.scale);
  if (source.rotation.size() == 4)
    node.rotation = unitQuat(vec4(source.rotation[0], source.rotation[1], source.rotation[2], source.rotation[3]));
  if (source.matrix.size() != 16) return node;
  for (int i = 0; i < 16; ++i) node.matrix[i / 4][i % 4] = static_cast<float>(source.matrix[static_cast<size_t>(i)]);
  const vec4 lastRow(node.matrix[0][3], node.matrix[1][3], node.matrix[2][3], node.matrix[3][3] - 1.0f);
  if (glm::length(lastRow) > 1e-4f) throw Error("node '" + node.name + "' has a matrix with perspective; export the file again");
  for (int c = 0; c < 4; ++c) node.matrix[c][3] = c == 3 ? 1.0f : 0.0f;
  return node;
}

std::vector<int> rootsOf(const tinygltf::Model& model) {
  if (!model.scenes.empty()) return model.scenes[static_cast<size_t>(std::max(model.defaultScene, 0))].nodes;
  std::vector<bool> isChild(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (int child : node.children) isChild[static_cast<size_t>(child)] = true;
  }
  std::vector<int> roots;
  for (size_t i = 0; i < model.nodes.size(); ++i) {
    if (!isChild[i]) roots.push_back(static_cast<int>(i));
  }
  return roots;
}

mat4 placement(const std::optional<AccessorView>& translations, const std::optional<AccessorView>& rotations,
               const std::optional<AccessorView>& scales, size_t i) {
  mat4 matrix(1.0f);
  if (translations) matrix = glm::translate(matrix, vec3(translations->at(i)));
  if (rotations) matrix *= glm::mat4_cast(unitQuat(rotations->at(i)));
  return scales ? glm::scale(matrix, vec3(scales->at(i))) : matrix;
}

// The placements of EXT_mesh_gpu_instancing, or the identity for a node without it.
std::vector<mat4> placements(const tinygltf::Model& model, const tinygltf::Node& node) {
  const auto found = node.extensions.find("EXT_mesh_gpu_instancing");
  if (found == node.extensions.end()) return {mat4(1.0f)};
  const tinygltf::Value& attributes = found->second.Get("attributes");
  size_t count = 0;
  const auto view = [&](const char* key, int componentCount) -> std::optional<AccessorView> {
    if (!attributes.Has(key)) return std::nullopt;
    AccessorView accessor(model, attributes.Get(key).GetNumberAsInt());
    if (accessor.componentCount() != componentCount || (count != 0 && accessor.count() != count))
      throw Error("the instances' " + std::string(key) + " has the wrong size; export the file again");
    count = accessor.count();
    return accessor;
  };
  const auto translations = view("TRANSLATION", 3);
  const auto rotations = view("ROTATION", 4);
  const auto scales = view("SCALE", 3);
  if (count > kInstanceLimit) throw Error("it places " + std::to_string(count) + " instances, more than 65535; place fewer");
  std::vector<mat4> matrices;
  for (size_t i = 0; i < count; ++i) matrices.push_back(placement(translations, rotations, scales, i));
  return matrices;
}

// Places one node's meshes; throws before the instances or their triangles become too many.
class Placer {
 public:
  explicit Placer(Scene& scene) : scene_(scene) {}

  void place(uint32_t node, std::span<const mat4> matrices, uint32_t meshBegin, uint32_t meshEnd) {
    const std::string& name = scene_.nodes[node].name;
    if (scene_.instances.size() + matrices.size() * (meshEnd - meshBegin) > kInstanceLimit)
      throw Error("it places more than 65535 meshes; join some of them");
    for (size_t i = 0; i < matrices.size(); ++i) {
      for (uint32_t mesh = meshBegin; mesh < meshEnd; ++mesh) {
        placedTriangles_ += scene_.meshes[mesh].triangleCount();
        if (placedTriangles_ > kPlacedTriangleLimit) throw Error("it places more than 64 million triangles; use a simpler scene");
        const std::string number = matrices.size() > 1 ? "[" + std::to_string(i) + "]" : "";
        scene_.instances.push_back({.name = name + number, .node = node, .mesh = mesh, .local = matrices[i]});
      }
    }
  }

 private:
  Scene& scene_;
  uint64_t placedTriangles_ = 0;
};

float clampedFov(double radians) { return static_cast<float>(std::clamp(glm::degrees(radians), 1.0, 170.0)); }

}  // namespace

NodeTree loadNodes(const tinygltf::Model& model, Scene& scene) {
  NodeTree tree;
  tree.sceneNodes.assign(model.nodes.size(), -1);
  struct Visit {
    int fileNode;
    int32_t parent;
  };
  std::vector<Visit> stack;
  const auto push = [&](const std::vector<int>& nodes, int32_t parent) {
    for (size_t i = nodes.size(); i-- > 0;) stack.push_back({nodes[i], parent});
  };
  push(rootsOf(model), -1);
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    int32_t& sceneNode = tree.sceneNodes[static_cast<size_t>(visit.fileNode)];
    if (sceneNode >= 0) continue;  // listed twice as a root
    sceneNode = static_cast<int32_t>(scene.nodes.size());
    const tinygltf::Node& source = model.nodes[static_cast<size_t>(visit.fileNode)];
    scene.nodes.push_back(nodeOf(source, visit.fileNode));
    scene.nodes.back().parent = visit.parent;
    tree.fileNodes.push_back(visit.fileNode);
    push(source.children, sceneNode);
  }
  return tree;
}

void loadInstances(const tinygltf::Model& model, const NodeTree& tree, const std::vector<uint32_t>& meshBegins, Scene& scene) {
  Placer placer(scene);
  for (size_t i = 0; i < tree.fileNodes.size(); ++i) {
    const tinygltf::Node& source = model.nodes[static_cast<size_t>(tree.fileNodes[i])];
    if (source.mesh < 0) continue;
    const size_t mesh = static_cast<size_t>(source.mesh);
    if (meshBegins[mesh] == meshBegins[mesh + 1]) continue;  // nothing of it was kept
    try {
      placer.place(static_cast<uint32_t>(i), placements(model, source), meshBegins[mesh], meshBegins[mesh + 1]);
    } catch (const Error& error) {
      throw error.within("node '" + scene.nodes[i].name + "'");
    }
  }
}

void loadCameras(const tinygltf::Model& model, const NodeTree& tree, const Bounds& bounds, Scene& scene, GltfWarnings& warnings) {
  const std::vector<mat4> transforms = nodeTransforms(scene, 0.0f);
  const vec3 middle = 0.5f * (bounds.low + bounds.high);
  const float diagonal = glm::length(bounds.high - bounds.low);
  for (size_t i = 0; i < tree.fileNodes.size(); ++i) {
    const int index = model.nodes[static_cast<size_t>(tree.fileNodes[i])].camera;
    if (index < 0) continue;
    const tinygltf::Camera& source = model.cameras[static_cast<size_t>(index)];
    const vec3 forward = -vec3(transforms[i][2]), up = vec3(transforms[i][1]);
    const float size = glm::length(glm::cross(forward, up)), reach = glm::length(vec3(transforms[i][3]));
    if (!(size > 1e-12f && size < 1e12f && reach < 1e9f)) {
      warnings.add("cameras without a direction or a place are left out", "'" + scene.nodes[i].name + "'");
      continue;
    }

    CameraPose camera;
    camera.name = plainName(!source.name.empty() ? source.name : scene.nodes[i].name);
    camera.eye = vec3(transforms[i][3]);
    camera.up = glm::normalize(up);
    const float distance = std::max(glm::dot(middle - camera.eye, glm::normalize(forward)), 0.1f * diagonal);
    camera.target = camera.eye + distance * glm::normalize(forward);
    if (source.type == "perspective") {
      camera.verticalFovDegrees = clampedFov(source.perspective.yfov);
    } else {
      camera.verticalFovDegrees = clampedFov(2.0 * std::atan2(std::abs(source.orthographic.ymag), distance));
      warnings.add("orthographic cameras are replaced by perspective ones", "'" + camera.name + "'");
    }
    scene.cameras.push_back(std::move(camera));
  }
}

}  // namespace gridscope
