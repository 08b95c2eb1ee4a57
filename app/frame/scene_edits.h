// What a person does to a scene's instances: hide, remove, make dynamic and move. The scene keeps its numbers: whoever names an instance or
// a mesh means the same before and after.
#pragma once

#include <span>

#include "app/frame/request.h"

namespace gridscope {

// Gives the scene these instances, its own as they were loaded, with the edits in their order; the last of an instance counts. Nothing else of
// the scene is touched, but that it gets a mesh without triangles, the first time that something is taken out.
void applyEdits(Scene& scene, std::span<const SceneInstance> loaded, std::span<const InstanceEdit> edits);

// Edits of instances that a scene with that many has; another load of it may have fewer.
std::vector<InstanceEdit> editsWithin(std::span<const InstanceEdit> edits, size_t instanceCount);

// Do two lists differ in offsets alone? Then the numbering stays and only the dynamic instances moved.
bool differInOffsetsAlone(std::span<const InstanceEdit> before, std::span<const InstanceEdit> after);

}  // namespace gridscope
