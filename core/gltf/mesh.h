// The triangles of a glTF primitive as a Mesh: corners in the file's order, whatever the mode.
#pragma once

#include <optional>

#include "core/gltf/warnings.h"
#include "core/scene/scene.h"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace gridscope {

// What the meshes of one file may still unfold into. A few bytes of indices, named by many primitives, can ask for any number of
// triangles; so the limit follows from the file's size.
struct TriangleBudget {
  uint64_t left = 0;
  static TriangleBudget forBytes(uint64_t fileBytes);
};

// Empty for points, lines, and a primitive without positions or with less than three corners (with a warning). Throws Error, without
// the mesh's name, when indices are out of range or positions are not finite. name and materialIndex are left to the caller.
std::optional<Mesh> loadPrimitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& name,
                                  TriangleBudget& budget, GltfWarnings& warnings);

}  // namespace gridscope
