// From a scene to the instances and triangles that references name: meshes are cut into pieces of at most 65,536 triangles, static
// instances come first, and each reference leads back to the person's own mesh and triangle number.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "shaders/shared/scene/scene.h"

namespace gridscope {

inline constexpr uint32_t kMostTrianglesPerInstance = 65536;
inline constexpr uint32_t kMostInstances = 65535;  // one fewer than 16 bits hold: reference 0xFFFFFFFF is blank

// Order of the references: the file's, or falling triangle area.
enum class NumberBy { file, area };
constexpr const char* numberingWord(NumberBy order) { return order == NumberBy::area ? "area" : "file"; }

// Where an instance of the grid comes from.
struct InstanceSource {
  uint32_t sceneInstance;  // into Scene::instances
  uint32_t mesh;           // into Scene::meshes
  uint32_t firstTriangle;  // of its piece in `objectTriangles`
};

// The scene as the stages see it. Instances [0, staticInstanceCount) are static.
struct NumberedScene {
  std::vector<Triangle> objectTriangles;  // every piece once, object space
  std::vector<Corner> corners;            // 3 for each object triangle
  std::vector<uint32_t> meshTriangles;    // for each object triangle: its number in its mesh, the file's order
  std::vector<Instance> instances;        // transforms as of the last setTransforms()
  std::vector<InstanceSource> sources;    // one for each instance
  std::vector<TraceMaterial> materials;
  std::vector<uint32_t> alphaBytes;  // alpha maps at their own size, 4 bytes a word, lowest first
  uint32_t staticInstanceCount = 0;
  uint32_t staticTriangleCount = 0;  // world triangles of the static instances; they come first
  uint32_t triangleCount = 0;        // world triangles of all instances

  uint32_t instanceCount() const { return static_cast<uint32_t>(instances.size()); }
  uint32_t dynamicInstanceCount() const { return instanceCount() - staticInstanceCount; }
};

// Numbers a scene's instances and triangles. NumberBy::area cuts meshes by triangle area and numbers the large ones first, so that
// saturated cells refuse the small ones. Throws Error when there are more than kMostInstances instances. Transforms are those of time 0.
NumberedScene numberScene(const Scene& scene, NumberBy order);

// Sets the dynamic instances' transforms to a time and returns the numbers of those that changed (rising).
std::vector<uint32_t> setTransforms(NumberedScene& numbered, const Scene& scene, float timeSeconds);

// The reference's triangle as the person knows it.
struct TriangleName {
  uint32_t sceneInstance;
  uint32_t mesh;
  uint32_t triangle;  // in the mesh, the file's order
};
TriangleName nameTriangle(const NumberedScene& numbered, uint32_t reference);

}  // namespace gridscope
