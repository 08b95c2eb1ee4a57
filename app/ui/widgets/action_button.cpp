// See action_button.h.
#include "app/ui/widgets/action_button.h"

#include "app/ui/widgets/widgets.h"

namespace gridscope {

void actionTooltip(const WindowModel& model, const Action& one) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const std::string why = whyNot(model, one);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(unit(340));
  ImGui::Text("%s%s%s", one.about, *one.key ? "  " : "", one.key);
  if (!why.empty()) textDim(why);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void actionButton(WindowModel& model, const char* name, const char* label) {
  const Action& one = action(name);
  const bool enabled = whyNot(model, one).empty();
  if (keyButton(label ? label : one.name, one.key, enabled)) one.run(model);
  actionTooltip(model, one);
}

void actionEntry(WindowModel& model, const Action& one) {
  const bool enabled = whyNot(model, one).empty();
  if (ImGui::MenuItem(one.name, one.key, false, enabled)) one.run(model);
  actionTooltip(model, one);
}

}  // namespace gridscope
