// From a scene to instances and triangles: cuts meshes into pieces, orders the pieces, numbers what references name.
#include "core/scene/numbering.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <string>

#include "core/base/error.h"

namespace gridscope {

namespace {

// World triangles of all instances together; beyond it their memory (36 bytes each) is no longer reasonable: 2.4 GB.
constexpr uint64_t kMostTriangles = uint64_t{1} << 26;

// Triangles of a mesh that one instance can hold.
struct Piece {
  uint32_t begin;  // into MeshOrder::triangles
  uint32_t end;
};

// A mesh's triangles in the order in which they are numbered, and where it is cut.
struct MeshOrder {
  std::vector<uint32_t> triangles;
  std::vector<double> areas;  // by falling area only: of each entry of `triangles`
  std::vector<Piece> pieces;
  uint32_t firstObjectTriangle = 0;
};

// A piece of a scene's instance: becomes one instance of the grid.
struct Placement {
  uint32_t sceneInstance;
  uint32_t piece;
  double meanArea = 0.0;  // world space, of its triangles
};

double triangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) { return 0.5 * glm::length(glm::cross(b - a, c - a)); }

double triangleArea(const Mesh& mesh, uint32_t triangle, const glm::dmat4& toWorld) {
  std::array<glm::dvec3, 3> corners;
  for (uint32_t k = 0; k < 3; ++k) corners[k] = glm::dvec3(toWorld * glm::dvec4(glm::dvec3(mesh.positions[3 * triangle + k]), 1.0));
  return triangleArea(corners[0], corners[1], corners[2]);
}

// Class of an area: its power of 4^coarseness. Areas near zero share the lowest class.
int areaClass(double area, int coarseness) { return static_cast<int>(std::floor(std::log2(std::max(area, 1e-30)) / (2.0 * coarseness))); }

MeshOrder orderMesh(const Mesh& mesh, NumberBy by) {
  MeshOrder order;
  order.triangles.resize(mesh.triangleCount());
  std::iota(order.triangles.begin(), order.triangles.end(), 0u);
  if (by == NumberBy::file) return order;

  std::vector<double> areas(mesh.triangleCount());
  for (uint32_t i = 0; i < areas.size(); ++i) areas[i] = triangleArea(mesh, i, glm::dmat4(1.0));
  std::stable_sort(order.triangles.begin(), order.triangles.end(), [&](uint32_t a, uint32_t b) { return areas[a] > areas[b]; });
  for (uint32_t triangle : order.triangles) order.areas.push_back(areas[triangle]);
  return order;
}

// Cuts where a piece is full, and where the area falls into another class. Coarseness 0: no classes.
void cutMesh(MeshOrder& order, int coarseness) {
  order.pieces.clear();
  const uint32_t count = static_cast<uint32_t>(order.triangles.size());
  for (uint32_t i = 0; i < count; ++i) {
    bool cut = i == 0 || i - order.pieces.back().begin == kMostTrianglesPerInstance;
    if (!cut && coarseness > 0) cut = areaClass(order.areas[i], coarseness) != areaClass(order.areas[i - 1], coarseness);
    if (cut) order.pieces.push_back({i, i});
    order.pieces.back().end = i + 1;
  }
}

uint64_t countInstances(const Scene& scene, const std::vector<MeshOrder>& orders) {
  uint64_t count = 0;
  for (const SceneInstance& instance : scene.instances) count += orders[instance.mesh].pieces.size();
  return count;
}

std::vector<MeshOrder> orderMeshes(const Scene& scene, NumberBy by) {
  std::vector<bool> used(scene.meshes.size());
  for (const SceneInstance& instance : scene.instances) used[instance.mesh] = true;
  std::vector<MeshOrder> orders(scene.meshes.size());
  for (size_t i = 0; i < orders.size(); ++i)
    if (used[i]) orders[i] = orderMesh(scene.meshes[i], by);

  // Classes by powers of 4; coarser ones, at last none, where that makes too many instances.
  static constexpr int kCoarseness[] = {1, 2, 4, 8, 0};
  for (int coarseness : kCoarseness) {
    if (by == NumberBy::file && coarseness != 0) continue;
    for (MeshOrder& order : orders) cutMesh(order, coarseness);
    if (countInstances(scene, orders) <= kMostInstances) return orders;
  }
  throw Error("the scene needs " + std::to_string(countInstances(scene, orders)) +
              " instances of at most 65,536 triangles; a reference can name " + std::to_string(kMostInstances) +
              ": join small meshes, or leave some out");
}

mat4 worldMatrix(const Scene& scene, const SceneInstance& instance, const std::vector<mat4>& nodes) {
  const mat4 matrix = nodes[instance.node] * instance.local;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      if (!std::isfinite(matrix[column][row]))
        throw Error("the transform of '" + instance.name + "' (" + scene.meshes[instance.mesh].name +
                    ") is not finite; correct its node's transform or animation");
  return matrix;
}

void setRows(Instance& instance, const mat4& m) {
  auto row = [&](int r) { return vec4(stored(m[0][r]), stored(m[1][r]), stored(m[2][r]), stored(m[3][r])); };
  instance.row0 = row(0);
  instance.row1 = row(1);
  instance.row2 = row(2);
}

bool sameRows(const Instance& a, const Instance& b) { return std::memcmp(&a, &b, 3 * sizeof(vec4)) == 0; }

double meanWorldArea(const Mesh& mesh, const MeshOrder& order, Piece piece, const mat4& toWorld) {
  double sum = 0.0;
  for (uint32_t i = piece.begin; i < piece.end; ++i) sum += triangleArea(mesh, order.triangles[i], glm::dmat4(toWorld));
  return sum / (piece.end - piece.begin);
}

// All pieces of all instances: static before dynamic, then in the file's order or by falling area.
std::vector<Placement> orderPlacements(const Scene& scene, const std::vector<MeshOrder>& orders, const std::vector<mat4>& nodes,
                                       NumberBy by) {
  std::vector<Placement> placements;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const SceneInstance& instance = scene.instances[i];
    const MeshOrder& order = orders[instance.mesh];
    for (uint32_t piece = 0; piece < order.pieces.size(); ++piece) {
      Placement placement{i, piece};
      if (by == NumberBy::area)
        placement.meanArea = meanWorldArea(scene.meshes[instance.mesh], order, order.pieces[piece], worldMatrix(scene, instance, nodes));
      placements.push_back(placement);
    }
  }
  std::stable_sort(placements.begin(), placements.end(), [&](const Placement& a, const Placement& b) {
    const bool aDynamic = scene.instances[a.sceneInstance].dynamic, bDynamic = scene.instances[b.sceneInstance].dynamic;
    if (aDynamic != bDynamic) return bDynamic;
    return a.meanArea > b.meanArea;
  });
  return placements;
}

uint32_t packColour(const vec4& colour) {
  uint32_t packed = 0;
  for (int i = 0; i < 4; ++i) packed |= static_cast<uint32_t>(std::lround(glm::clamp(colour[i], 0.0f, 1.0f) * 255.0f)) << (8 * i);
  return packed;
}

vec3 storedPoint(const vec3& point) { return vec3(stored(point.x), stored(point.y), stored(point.z)); }

Corner makeCorner(const Mesh& mesh, uint32_t corner) {
  const vec2 uv = mesh.uvs.empty() ? vec2(0.0f) : mesh.uvs[corner];
  const vec4 colour = mesh.colours.empty() ? vec4(1.0f) : mesh.colours[corner];
  return {storedPoint(mesh.normals[corner]), vec2(stored(uv.x), stored(uv.y)), packColour(colour)};
}

void addMesh(NumberedScene& numbered, const Mesh& mesh, MeshOrder& order) {
  CHECK_EQ(mesh.normals.size(), mesh.positions.size());
  CHECK(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
  CHECK(mesh.colours.empty() || mesh.colours.size() == mesh.positions.size());
  order.firstObjectTriangle = static_cast<uint32_t>(numbered.objectTriangles.size());
  for (uint32_t triangle : order.triangles) {
    const vec3* corners = &mesh.positions[3 * triangle];
    numbered.objectTriangles.push_back({storedPoint(corners[0]), storedPoint(corners[1]), storedPoint(corners[2])});
    for (uint32_t k = 0; k < 3; ++k) numbered.corners.push_back(makeCorner(mesh, 3 * triangle + k));
    numbered.meshTriangles.push_back(triangle);
  }
}

void addInstance(NumberedScene& numbered, const Scene& scene, const Placement& placement, const MeshOrder& order) {
  const SceneInstance& source = scene.instances[placement.sceneInstance];
  const Piece piece = order.pieces[placement.piece];
  Instance instance{};
  instance.firstTriangle = order.firstObjectTriangle + piece.begin;
  instance.triangleCount = piece.end - piece.begin;
  instance.firstWorldTriangle = numbered.triangleCount;
  instance.material = scene.meshes[source.mesh].materialIndex;
  numbered.instances.push_back(instance);
  numbered.sources.push_back({placement.sceneInstance, source.mesh, instance.firstTriangle});
  numbered.triangleCount += instance.triangleCount;
  if (source.dynamic) return;
  numbered.staticInstanceCount += 1;
  numbered.staticTriangleCount += instance.triangleCount;
}

// The lowest byte of the alpha map whose opacity reaches the cutoff; 256 when even 255 does not.
uint32_t alphaThreshold(const Material& material) {
  const double cutoff = material.alphaMode == AlphaMode::blend ? 0.5 : double(material.alphaCutoff);
  for (uint32_t byte = 0; byte < 256; ++byte)
    if (byte / 255.0 * double(material.baseColour.a) >= cutoff) return byte;
  return 256;
}

// Appends an image's alpha to the packed bytes and returns the number of its first byte.
uint32_t addAlphaMap(std::vector<uint32_t>& words, uint64_t& byteCount, const Image& image) {
  const uint64_t first = byteCount;
  const uint64_t size = uint64_t(image.width) * image.height;
  CHECK_EQ(image.rgba.size(), 4 * size);
  byteCount += size;
  if (byteCount > UINT32_MAX) throw Error("the alpha maps of the scene take more than 4 GiB; use smaller images for '" + image.name + "'");
  words.resize((byteCount + 3) / 4);
  for (uint64_t i = 0; i < size; ++i) words[(first + i) / 4] |= uint32_t(image.rgba[4 * i + 3]) << (8 * ((first + i) % 4));
  return static_cast<uint32_t>(first);
}

TraceMaterial makeMaterial(const Material& material) {
  TraceMaterial result{};
  result.baseColour = material.baseColour;
  result.metallic = material.metallic;
  result.roughness = material.roughness;
  result.flags = (material.unlit ? kMaterialUnlit : 0u) | (material.doubleSided ? kMaterialDoubleSided : 0u);
  result.layer = material.imageIndex < 0 ? kNoLayer : static_cast<uint32_t>(material.imageIndex);
  result.wrapU = static_cast<uint32_t>(material.wrapU);
  result.wrapV = static_cast<uint32_t>(material.wrapV);
  return result;
}

void addMaterials(NumberedScene& numbered, const Scene& scene) {
  static constexpr uint32_t kNotYet = UINT32_MAX;
  std::vector<uint32_t> firstBytes(scene.images.size(), kNotYet);
  uint64_t byteCount = 0;
  for (const Material& material : scene.materials) {
    TraceMaterial result = makeMaterial(material);
    if (material.alphaMode != AlphaMode::opaque) {
      result.flags |= kMaterialAlphaKeyed;
      result.alphaThreshold = alphaThreshold(material);

      // Materials that use one image share its alpha map. Without an image the base colour alone decides, for all hits alike.
      if (material.imageIndex >= 0) {
        const Image& image = scene.images[material.imageIndex];
        uint32_t& firstByte = firstBytes[material.imageIndex];
        if (firstByte == kNotYet) firstByte = addAlphaMap(numbered.alphaBytes, byteCount, image);
        result.alphaFirstByte = firstByte;
        result.alphaWidth = image.width;
        result.alphaHeight = image.height;
      } else {
        result.alphaThreshold = result.alphaThreshold <= 255 ? 0 : 256;
      }
    }
    numbered.materials.push_back(result);
  }
}

}  // namespace

NumberedScene numberScene(const Scene& scene, NumberBy order) {
  // The order of each mesh's triangles, then of the instances.
  const std::vector<mat4> nodes = nodeTransforms(scene, 0.0f);
  std::vector<MeshOrder> orders = orderMeshes(scene, order);
  uint64_t triangleCount = 0;
  for (const SceneInstance& instance : scene.instances) triangleCount += scene.meshes[instance.mesh].triangleCount();
  if (triangleCount > kMostTriangles)
    throw Error("the scene places " + std::to_string(triangleCount) + " triangles; at most " + std::to_string(kMostTriangles) +
                " are supported: leave some instances out");
  const std::vector<Placement> placements = orderPlacements(scene, orders, nodes, order);

  // Object space, once a mesh.
  NumberedScene numbered;
  for (size_t i = 0; i < orders.size(); ++i) addMesh(numbered, scene.meshes[i], orders[i]);
  addMaterials(numbered, scene);

  // Instances.
  for (const Placement& placement : placements) {
    const SceneInstance& source = scene.instances[placement.sceneInstance];
    addInstance(numbered, scene, placement, orders[source.mesh]);
    setRows(numbered.instances.back(), worldMatrix(scene, source, nodes));
  }
  return numbered;
}

std::vector<uint32_t> setTransforms(NumberedScene& numbered, const Scene& scene, float timeSeconds) {
  const std::vector<mat4> nodes = nodeTransforms(scene, timeSeconds);
  std::vector<uint32_t> moved;
  for (uint32_t i = numbered.staticInstanceCount; i < numbered.instanceCount(); ++i) {
    Instance& instance = numbered.instances[i];
    const Instance before = instance;
    setRows(instance, worldMatrix(scene, scene.instances[numbered.sources[i].sceneInstance], nodes));
    if (!sameRows(before, instance)) moved.push_back(i);
  }
  return moved;
}

TriangleName nameTriangle(const NumberedScene& numbered, uint32_t reference) {
  const uint32_t instance = reference >> 16, triangle = reference & 0xFFFFu;
  CHECK_LT(instance, numbered.instanceCount());
  CHECK_LT(triangle, numbered.instances[instance].triangleCount);
  const InstanceSource& source = numbered.sources[instance];
  return {source.sceneInstance, source.mesh, numbered.meshTriangles[source.firstTriangle + triangle]};
}

}  // namespace gridscope
