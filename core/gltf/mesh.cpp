// The triangles of a glTF primitive as a Mesh, see mesh.h.
#include "core/gltf/mesh.h"

#include <cmath>

#include <tiny_gltf.h>

#include "core/base/error.h"
#include "core/gltf/accessor.h"
#include "core/gltf/material.h"

namespace gridscope {

namespace {

constexpr uint64_t kTriangleLimit = 16'000'000;

// Enough for a small file that shares its indices between meshes.
constexpr uint64_t kFreeTriangles = 100'000;

std::optional<AccessorView> attribute(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end()) return std::nullopt;
  return AccessorView(model, found->second);
}

// An attribute that all vertices must have, with one of two component counts.
std::optional<AccessorView> vertexAttribute(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& name,
                                            int fewest, int most) {
  auto view = attribute(model, primitive, name);
  if (!view) return view;
  if (view->componentCount() < fewest || view->componentCount() > most)
    throw Error(name + " has the wrong number of components; export the file again");
  const size_t vertexCount = model.accessors[static_cast<size_t>(primitive.attributes.at("POSITION"))].count;
  if (view->count() < vertexCount)
    throw Error(name + " has " + std::to_string(view->count()) + " vertices instead of " + std::to_string(vertexCount) +
                "; export the file again");
  return view;
}

// Which corners of the index list make triangle k. Strips turn every second triangle round, fans end in their first corner, as
// section 3.7.2.1 of the specification orders them.
struct Corners {
  size_t a, b, c;
};
Corners triangleCorners(int mode, size_t k) {
  if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) return {k, k + 1 + k % 2, k + 2 - k % 2};
  if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {k + 1, k + 2, 0};
  return {3 * k, 3 * k + 1, 3 * k + 2};
}

uint64_t triangleCount(int mode, uint64_t cornerCount) {
  if (mode == TINYGLTF_MODE_TRIANGLES) return cornerCount / 3;
  return cornerCount < 3 ? 0 : cornerCount - 2;
}

// The vertex of every corner of every triangle.
std::vector<uint32_t> cornerVertices(const tinygltf::Model& model, const tinygltf::Primitive& primitive, size_t vertexCount,
                                     TriangleBudget& budget) {
  std::optional<AccessorView> indices;
  if (primitive.indices >= 0) indices.emplace(model, primitive.indices);
  if (indices && (indices->componentCount() != 1 || !indices->isUnsignedInteger()))
    throw Error("its indices are not unsigned integers; export the file again");

  const uint64_t count = triangleCount(primitive.mode, indices ? indices->count() : vertexCount);
  if (count > budget.left) throw Error("the meshes unfold to more triangles than a file of this size can hold; split or repair the file");
  budget.left -= count;

  std::vector<uint32_t> vertices;
  vertices.reserve(count * 3);
  for (uint64_t k = 0; k < count; ++k) {
    const Corners corners = triangleCorners(primitive.mode, k);
    for (size_t corner : {corners.a, corners.b, corners.c}) {
      const uint32_t vertex = indices ? indices->indexAt(corner) : static_cast<uint32_t>(corner);
      if (vertex >= vertexCount)
        throw Error("index " + std::to_string(vertex) + " is beyond its " + std::to_string(vertexCount) +
                    " vertices; export the file again");
      vertices.push_back(vertex);
    }
  }
  return vertices;
}

bool finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void readPositions(Mesh& mesh, const AccessorView& view, const std::vector<uint32_t>& vertices) {
  mesh.positions.reserve(vertices.size());
  for (uint32_t vertex : vertices) {
    const vec3 position = view.at(vertex);
    if (!finite(position)) throw Error("vertex " + std::to_string(vertex) + " is not a finite position; repair it in a modelling program");
    mesh.positions.push_back(position);
  }
}

// Leaves zero where the file has nothing usable; makeFlatNormals fills it.
void readNormals(Mesh& mesh, const AccessorView& view, const std::vector<uint32_t>& vertices) {
  mesh.normals.reserve(vertices.size());
  for (uint32_t vertex : vertices) {
    const glm::dvec3 normal = vec3(view.at(vertex));
    const double length = glm::length(normal);
    mesh.normals.push_back(length > 1e-12 && std::isfinite(length) ? vec3(normal / length) : vec3(0.0f));
  }
}

void readUvs(Mesh& mesh, const AccessorView& view, const UvMapping& mapping, const std::vector<uint32_t>& vertices) {
  mesh.uvs.reserve(vertices.size());
  for (uint32_t vertex : vertices) {
    const vec2 uv = mapping.apply(vec2(view.at(vertex)));
    mesh.uvs.push_back(std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : vec2(0.0f));
  }
}

void readColours(Mesh& mesh, const AccessorView& view, const std::vector<uint32_t>& vertices) {
  mesh.colours.reserve(vertices.size());
  for (uint32_t vertex : vertices) {
    vec4 colour = view.at(vertex);
    if (view.componentCount() == 3) colour.w = 1.0f;
    for (int c = 0; c < 4; ++c) colour[c] = colour[c] >= 0.0f ? std::min(colour[c], 1.0f) : 0.0f;  // NaN becomes 0
    mesh.colours.push_back(colour);
  }
}

bool isTriangles(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

}  // namespace

TriangleBudget TriangleBudget::forBytes(uint64_t fileBytes) { return {std::min(kTriangleLimit, kFreeTriangles + fileBytes)}; }

std::optional<Mesh> loadPrimitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& name,
                                  TriangleBudget& budget, GltfWarnings& warnings) {
  if (!isTriangles(primitive.mode)) {
    warnings.add("points and lines are left out", "mesh '" + name + "'");
    return std::nullopt;
  }
  const auto positions = attribute(model, primitive, "POSITION");
  if (!positions) {
    warnings.add("primitives without positions are left out", "mesh '" + name + "'");
    return std::nullopt;
  }
  if (positions->componentCount() != 3) throw Error("POSITION is not a VEC3; export the file again");

  const std::vector<uint32_t> vertices = cornerVertices(model, primitive, positions->count(), budget);
  if (vertices.empty()) {
    warnings.add("primitives without a whole triangle are left out", "mesh '" + name + "'");
    return std::nullopt;
  }
  Mesh mesh;
  readPositions(mesh, *positions, vertices);
  if (const auto normals = vertexAttribute(model, primitive, "NORMAL", 3, 3)) readNormals(mesh, *normals, vertices);
  makeFlatNormals(mesh);
  if (const auto colours = vertexAttribute(model, primitive, "COLOR_0", 3, 4)) readColours(mesh, *colours, vertices);

  // Texture coordinates that nothing uses would only cost memory.
  if (primitive.material < 0) return mesh;
  const tinygltf::Material& material = model.materials[static_cast<size_t>(primitive.material)];
  if (material.pbrMetallicRoughness.baseColorTexture.index < 0) return mesh;
  const UvMapping mapping = baseColourMapping(material);
  const auto uvs = vertexAttribute(model, primitive, "TEXCOORD_" + std::to_string(mapping.set), 2, 2);
  if (uvs) readUvs(mesh, *uvs, mapping, vertices);
  return mesh;
}

}  // namespace gridscope
