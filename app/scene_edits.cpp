// See scene_edits.h.
#include "app/scene_edits.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "core/error.h"

namespace gridscope {

// Taken out of the frame: an instance of a mesh without triangles.
static void takeOut(Scene& scene, SceneInstance& instance, int64_t& nothing) {
  if (nothing < 0) {
    nothing = int64_t(scene.meshes.size());
    scene.meshes.push_back({.name = "nothing"});
  }
  instance.mesh = uint32_t(nothing);
}

// Moved in the world: the offset is applied behind the node's transform, which the instance's own matrix must undo first.
static void move(const Scene& scene, SceneInstance& instance, const vec3& offset) {
  const mat4 node = nodeTransforms(scene, 0.0f)[instance.node];
  instance.local = glm::inverse(node) * glm::translate(mat4(1.0f), offset) * node * instance.local;
}

Scene editedScene(const Scene& scene, std::span<const InstanceEdit> edits) {
  Scene edited = scene;
  int64_t nothing = -1;
  for (size_t i = 0; i < edits.size(); ++i) {
    const InstanceEdit& edit = edits[i];
    CHECK_LT(edit.sceneInstance, edited.instances.size());
    const bool replaced = std::any_of(edits.begin() + ptrdiff_t(i) + 1, edits.end(),
                                      [&](const InstanceEdit& later) { return later.sceneInstance == edit.sceneInstance; });
    if (replaced) continue;
    SceneInstance& instance = edited.instances[edit.sceneInstance];
    if (edit.kind != InstanceEdit::Kind::makeDynamic) {
      takeOut(edited, instance, nothing);
      continue;
    }
    instance.dynamic = true;
    move(edited, instance, edit.offset);
  }
  return edited;
}

bool differInOffsetsAlone(std::span<const InstanceEdit> before, std::span<const InstanceEdit> after) {
  return before.size() == after.size() && std::equal(before.begin(), before.end(), after.begin(), [](const InstanceEdit& a, const InstanceEdit& b) {
           return a.sceneInstance == b.sceneInstance && a.kind == b.kind;
         });
}

}  // namespace gridscope
