// See scene_edits.h.
#include "app/frame/scene_edits.h"

#include <algorithm>
#include <iterator>

#include <glm/gtc/matrix_transform.hpp>

#include "core/base/error.h"

namespace gridscope {

// A mesh without triangles: what is taken out becomes an instance of it.
static uint32_t emptyMesh(Scene& scene) {
  const auto found = std::ranges::find_if(scene.meshes, [](const Mesh& mesh) { return mesh.positions.empty(); });
  const auto index = uint32_t(found - scene.meshes.begin());
  if (found == scene.meshes.end()) scene.meshes.push_back({.name = "nothing"});
  return index;
}

// Moved in the world: the offset is applied behind the node's transform, which the instance's own matrix must undo first.
static void move(const mat4& node, SceneInstance& instance, const vec3& offset) {
  instance.local = glm::inverse(node) * glm::translate(mat4(1.0f), offset) * node * instance.local;
}

void applyEdits(Scene& scene, std::span<const SceneInstance> loaded, std::span<const InstanceEdit> edits) {
  scene.instances.assign(loaded.begin(), loaded.end());
  if (edits.empty()) return;
  const std::vector<mat4> nodes = nodeTransforms(scene, 0.0f);
  for (size_t i = 0; i < edits.size(); ++i) {
    const InstanceEdit& edit = edits[i];
    CHECK_LT(edit.sceneInstance, scene.instances.size());
    const bool replaced = std::any_of(edits.begin() + ptrdiff_t(i) + 1, edits.end(),
                                      [&](const InstanceEdit& later) { return later.sceneInstance == edit.sceneInstance; });
    if (replaced) continue;
    SceneInstance& instance = scene.instances[edit.sceneInstance];
    if (edit.kind != InstanceEdit::Kind::makeDynamic) {
      instance.mesh = emptyMesh(scene);
      continue;
    }
    instance.dynamic = true;
    move(nodes[instance.node], instance, edit.offset);
  }
}

std::vector<InstanceEdit> editsWithin(std::span<const InstanceEdit> edits, size_t instanceCount) {
  std::vector<InstanceEdit> kept;
  std::ranges::copy_if(edits, std::back_inserter(kept), [&](const InstanceEdit& edit) { return edit.sceneInstance < instanceCount; });
  return kept;
}

bool differInOffsetsAlone(std::span<const InstanceEdit> before, std::span<const InstanceEdit> after) {
  return before.size() == after.size() &&
         std::equal(before.begin(), before.end(), after.begin(),
                    [](const InstanceEdit& a, const InstanceEdit& b) { return a.sceneInstance == b.sceneInstance && a.kind == b.kind; });
}

}  // namespace gridscope
