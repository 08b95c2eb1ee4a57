// See instance_edits.h.
#include "app/frame/instance_edits.h"

#include <algorithm>

namespace gridscope {

const InstanceEdit* editOf(std::span<const InstanceEdit> edits, uint32_t sceneInstance) {
  const auto found = std::ranges::find(edits, sceneInstance, &InstanceEdit::sceneInstance);
  return found == edits.end() ? nullptr : &*found;
}

void setEdit(std::vector<InstanceEdit>& edits, const InstanceEdit& edit) {
  const auto found = std::ranges::find(edits, edit.sceneInstance, &InstanceEdit::sceneInstance);
  if (found != edits.end())
    *found = edit;
  else
    edits.push_back(edit);
}

void dropEdit(std::vector<InstanceEdit>& edits, uint32_t sceneInstance) {
  std::erase_if(edits, [&](const InstanceEdit& edit) { return edit.sceneInstance == sceneInstance; });
}

bool isTakenOut(const InstanceEdit* edit) { return edit && edit->kind != InstanceEdit::Kind::makeDynamic; }

bool isMadeDynamic(const InstanceEdit* edit) { return edit && edit->kind == InstanceEdit::Kind::makeDynamic; }

}  // namespace gridscope
