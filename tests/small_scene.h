// Scenes of a few triangles for tests of the stages, and a scene taken through numbering and build.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/grid/build.h"
#include "core/grid/derive.h"
#include "core/grid/invariants.h"
#include "core/trace/derive.h"
#include "core/trace/trace.h"
#include "tests/grid_words.h"

namespace gridscope {

inline Mesh meshOf(const std::vector<Triangle>& triangles, uint32_t material = 0) {
  Mesh mesh;
  mesh.name = "mesh";
  mesh.materialIndex = material;
  for (const Triangle& triangle : triangles)
    for (const vec3& corner : {triangle.a, triangle.b, triangle.c}) mesh.positions.push_back(corner);
  mesh.normals.assign(mesh.positions.size(), vec3(0.0f, 1.0f, 0.0f));
  return mesh;
}

inline Scene emptyScene() {
  Scene scene;
  scene.name = "test";
  scene.materials.resize(1);
  return scene;
}

// Places a mesh with a root node of its own and returns the number of the instance.
inline uint32_t placeMesh(Scene& scene, uint32_t mesh, const vec3& translation = vec3(0.0f), bool dynamic = false) {
  Node node;
  node.name = "node " + std::to_string(scene.nodes.size());
  node.translation = translation;
  scene.nodes.push_back(node);
  SceneInstance instance;
  instance.name = node.name;
  instance.node = static_cast<uint32_t>(scene.nodes.size() - 1);
  instance.mesh = mesh;
  instance.dynamic = dynamic;
  scene.instances.push_back(instance);
  return static_cast<uint32_t>(scene.instances.size() - 1);
}

inline uint32_t addMesh(Scene& scene, const Mesh& mesh) {
  scene.meshes.push_back(mesh);
  return static_cast<uint32_t>(scene.meshes.size() - 1);
}

inline Scene sceneOf(const std::vector<Triangle>& triangles) {
  Scene scene = emptyScene();
  placeMesh(scene, addMesh(scene, meshOf(triangles)));
  return scene;
}

inline vec3 randomPoint(std::mt19937& random, float low, float high) {
  std::uniform_real_distribution<float> number(low, high);
  const float x = number(random), y = number(random), z = number(random);
  return vec3(x, y, z);
}

inline vec3 randomDirection(std::mt19937& random) {
  for (;;) {
    const vec3 point = randomPoint(random, -1.0f, 1.0f);
    const float length = glm::length(point);
    if (length > 0.1f && length < 1.0f) return point / length;
  }
}

// Triangles of about `size` with their first corner in the cube of -extent..extent.
inline std::vector<Triangle> randomTriangles(uint32_t count, float extent, float size, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Triangle> triangles(count);
  for (Triangle& triangle : triangles) {
    triangle.a = randomPoint(random, -extent, extent);
    triangle.b = triangle.a + randomPoint(random, -size, size);
    triangle.c = triangle.a + randomPoint(random, -size, size);
  }
  return triangles;
}

// A scene after numbering and build, with its dynamic instances added.
struct BuiltScene {
  NumberedScene numbered;
  std::vector<Triangle> worldTriangles;
  Grid grid;
  BuildReport staticReport{};
  BuildReport dynamicReport{};

  BuiltScene(const Scene& scene, const GridSettings& settings)
      : numbered(numberScene(scene, settings.numberBy)), worldTriangles(numbered.triangleCount) {
    grid = buildGrid(deriveGrid(settings, sceneBounds(scene), numbered), numbered, worldTriangles, staticReport);
    dynamicReport = updateAll(numbered, worldTriangles, grid).added;
  }
  TraceInput traceInput(const TraceSettings& settings) const {
    return {grid, numbered, worldTriangles, deriveTrace(settings, grid.parameters)};
  }
};

// The settings with the smallest capacity at which no cell of the scene refuses a reference.
inline GridSettings unsaturated(const Scene& scene, GridSettings settings) {
  settings.capacity = 1;
  settings.capacity = std::max(1u, countGrid(BuiltScene(scene, settings).grid).statistics.maxDemand);
  return settings;
}

inline Ray makeRay(const vec3& origin, const vec3& direction, const vec3& launchNormal = vec3(0.0f)) {
  return {origin, glm::normalize(direction), launchNormal, 1u};
}

// The references that a cell stores.
inline std::vector<uint32_t> storedReferences(const Grid& grid, const ivec3& cell) {
  std::vector<uint32_t> references;
  for (int slot = 0; slot < grid.parameters.capacity; ++slot) {
    const uint32_t reference = slotAt(grid, cell, slot);
    if (reference == kNoReference) break;
    references.push_back(reference);
  }
  return references;
}

// Calls visit for every cell of a grid.
template <typename Visit>
void forEachCell(const GridParameters& grid, Visit visit) {
  ivec3 cell;
  for (cell.z = 0; cell.z < grid.cellCount.z; ++cell.z)
    for (cell.y = 0; cell.y < grid.cellCount.y; ++cell.y)
      for (cell.x = 0; cell.x < grid.cellCount.x; ++cell.x) visit(cell);
}

}  // namespace gridscope
