// A scene as a person knows it: named meshes, materials, nodes, animations, cameras. Loaded from glTF (gltf.h), made in code
// (built_in_scenes.h); numbering.h turns it into the instances and triangles that references name.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/base/image.h"

namespace gridscope {

using glm::mat4;
using glm::quat;
using glm::vec2;
using glm::vec3;
using glm::vec4;

// Coordinates beyond this (world space, either sign) are refused on load: products of them would leave the range of a float.
inline constexpr float kCoordinateLimit = 1e6f;

enum class WrapMode : uint32_t { repeat = 0, mirror = 1, clamp = 2 };
enum class AlphaMode : uint32_t { opaque = 0, mask = 1, blend = 2 };  // blend is traced as mask with cutoff 0.5

struct Material {
  std::string name;
  vec4 baseColour{1.0f};    // linear, multiplies image and vertex colour; a: opacity
  float metallic = 0.0f;    // 0..1
  float roughness = 0.5f;   // perceptual, 0..1
  int32_t imageIndex = -1;  // into Scene::images; -1: none
  WrapMode wrapU = WrapMode::repeat;
  WrapMode wrapV = WrapMode::repeat;
  AlphaMode alphaMode = AlphaMode::opaque;
  float alphaCutoff = 0.5f;  // for mask
  bool doubleSided = false;  // shading only: the trace never culls
  bool unlit = false;
};

// One primitive: a plain list of triangles, three corners each; triangle k has corners 3k, 3k+1, 3k+2, in the file's order.
struct Mesh {
  std::string name;  // the file's mesh name, with the material's when a mesh has several primitives
  uint32_t materialIndex = 0;
  std::vector<vec3> positions;  // object space; size 3 * triangleCount()
  std::vector<vec3> normals;    // unit, same size as positions (made when the file has none)
  std::vector<vec2> uvs;        // same size as positions, texture transform applied; or empty: all (0, 0)
  std::vector<vec4> colours;    // linear, same size as positions; or empty: all white
  uint32_t triangleCount() const { return static_cast<uint32_t>(positions.size() / 3); }
};

// A node of the transform tree. Parents come before their children. local = translation * rotation * scale, then * matrix.
struct Node {
  std::string name;
  int32_t parent = -1;  // -1: a root
  vec3 translation{0.0f};
  quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  // w, x, y, z; unit
  vec3 scale{1.0f};
  mat4 matrix{1.0f};  // for files that give a matrix instead; never animated
};

enum class ChannelPath { translation, rotation, scale };
enum class Interpolation { step, linear, cubicSpline };

// Key frames of one property of one node. times rise; values hold one vec4 a key (three for cubicSpline: in-tangent, value,
// out-tangent); a rotation is x, y, z, w, a translation or scale uses x, y, z.
struct Channel {
  uint32_t node = 0;
  ChannelPath path = ChannelPath::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;  // seconds
  std::vector<vec4> values;
};

// All animations of a scene play at once; each repeats after its duration.
struct Animation {
  std::string name;
  float duration = 0.0f;  // seconds, the last key of all channels
  std::vector<Channel> channels;
};

// A mesh placed in the world: what a person sees as one thing. Becomes one instance of the grid, or several (numbering.h).
struct SceneInstance {
  std::string name;  // the node's name
  uint32_t node = 0;
  uint32_t mesh = 0;
  mat4 local{1.0f};      // applied before the node's transform (EXT_mesh_gpu_instancing)
  bool dynamic = false;  // its references are cleared and added again each frame; true when an animation can move it
};

struct CameraPose {
  std::string name;
  vec3 eye{0.0f};
  vec3 target{0.0f, 0.0f, -1.0f};
  vec3 up{0.0f, 1.0f, 0.0f};
  float verticalFovDegrees = 60.0f;
};

struct Scene {
  std::string name;  // file name or built-in name
  std::vector<Image> images;
  std::vector<Material> materials;  // at least one
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<Animation> animations;
  std::vector<SceneInstance> instances;
  std::vector<CameraPose> cameras;    // at time 0, world space; the first is the default; may be empty
  std::vector<std::string> warnings;  // one line per kind of thing that was left out or replaced
};

struct Bounds {
  vec3 low{INFINITY};
  vec3 high{-INFINITY};
  bool empty() const { return !(low.x <= high.x); }
  void include(const vec3& point) { low = glm::min(low, point), high = glm::max(high, point); }
  void include(const Bounds& other) { low = glm::min(low, other.low), high = glm::max(high, other.high); }
};

// World matrix of every node at a time in seconds.
std::vector<mat4> nodeTransforms(const Scene& scene, float timeSeconds);

// Bounds of all instances: the static ones as they are, the dynamic ones united over the whole animation (sampled at every key and
// 16 times between two keys). Throws Error for a scene without triangles, or with non-finite or too large coordinates.
Bounds sceneBounds(const Scene& scene);

// Marks every instance whose node, or a node above it, is moved by an animation as dynamic.
void markAnimatedInstances(Scene& scene);

// The camera to start with: the scene's first, or one placed inside the bounds with a view along the longest horizontal side.
CameraPose defaultCamera(const Scene& scene);

// Where missing, makes a mesh's normals: the geometric normal of each triangle; (0, 1, 0) for one without area.
void makeFlatNormals(Mesh& mesh);

}  // namespace gridscope
