// What was done to instances, as a list with one entry for each: set, dropped, moved. scene_edits.h applies it. No ImGui here.
#pragma once

#include <span>
#include <vector>

#include "app/frame/request.h"

namespace gridscope {

// Null: nothing was done to it.
const InstanceEdit* editOf(std::span<const InstanceEdit> edits, uint32_t sceneInstance);

// Replaces what was done to the instance before.
void setEdit(std::vector<InstanceEdit>& edits, const InstanceEdit& edit);
void dropEdit(std::vector<InstanceEdit>& edits, uint32_t sceneInstance);

// Hidden or deleted.
bool isTakenOut(const InstanceEdit* edit);
bool isMadeDynamic(const InstanceEdit* edit);

}  // namespace gridscope
