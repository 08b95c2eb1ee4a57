// What a person does to a scene's instances: hide, remove, make dynamic and move. The scene keeps its numbers: whoever names an instance or
// a mesh means the same before and after.
#pragma once

#include <span>

#include "app/frame_request.h"

namespace gridscope {

// The scene with the edits, in their order; the last of an instance counts.
Scene editedScene(const Scene& scene, std::span<const InstanceEdit> edits);

// Do two lists differ in offsets alone? Then the numbering stays and only the dynamic instances moved.
bool differInOffsetsAlone(std::span<const InstanceEdit> before, std::span<const InstanceEdit> after);

}  // namespace gridscope
