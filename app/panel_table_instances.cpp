// The table of the scene's instances, with what a person can do to them: hide, and make dynamic.
#include <algorithm>

#include "app/panel_sheet.h"
#include "app/panel_table_parts.h"
#include "app/window_panels.h"
#include "app/window_widgets.h"
#include "shaders/shared/palette.h"

namespace gridscope {

namespace {

bool hasEdit(const WindowModel& model, uint32_t instance, InstanceEdit::Kind kind) {
  return std::any_of(model.request.edits.begin(), model.request.edits.end(),
                     [&](const InstanceEdit& edit) { return edit.sceneInstance == instance && edit.kind == kind; });
}

void toggleEdit(WindowModel& model, uint32_t instance, InstanceEdit::Kind kind) {
  std::vector<InstanceEdit>& edits = model.request.edits;
  if (hasEdit(model, instance, kind)) std::erase_if(edits, [&](const InstanceEdit& edit) { return edit.sceneInstance == instance && edit.kind == kind; });
  else edits.push_back({.sceneInstance = instance, .kind = kind});
}

void drawToggles(WindowModel& model, uint32_t instance, bool animated) {
  const bool captured = model.frame->scene->captureFrames > 0;
  const bool hidden = hasEdit(model, instance, InstanceEdit::Kind::hide), made = hasEdit(model, instance, InstanceEdit::Kind::makeDynamic);
  const char* captureWhy = "A capture's instances stay as they were captured";
  if (rowButton(hidden ? "Show" : "Hide", "hide", hidden ? "Puts it back; the static grid is built again" : "Takes it away; the static grid is built again",
                  !captured, captureWhy))
    toggleEdit(model, instance, InstanceEdit::Kind::hide);
  ImGui::SameLine(0.0f, unit(4));
  const char* why = captured ? captureWhy : hidden ? "It is hidden" : "It is dynamic in the scene already";
  if (rowButton(made ? "Static" : "Dynamic", "dynamic", made ? "Makes it static again" : "Makes it dynamic: cleared and added again every frame, and can be dragged",
                  !captured && !hidden && (made || !animated), why))
    toggleEdit(model, instance, InstanceEdit::Kind::makeDynamic);
}

}  // namespace

void drawInstancesTable(WindowModel& model) {
  static SheetPanel panel{.kind = TableKind::instances, .order = {size_t(InstanceColumn::triangles), true}};
  SheetActions actions;
  actions.selectedId = model.selected().instance;
  actions.click = [&](uint32_t id) {
    panel.shownId = id;
    model.selection.selectInstance(id);
    if (const Bounds bounds = boundsOfInstance(*panel.job.result()->wish.frame, id); !bounds.empty()) model.focusWanted = bounds;
  };
  actions.swatch = [](size_t column, double value) -> std::optional<uint32_t> {
    const bool loss = column == size_t(InstanceColumn::lost) || column == size_t(InstanceColumn::raysLost);
    return loss && value > 0.0 ? std::optional(kColourSaturated) : std::nullopt;
  };
  actions.unknownWhy = "Not known yet: it needs the truth (Causes tab)";
  actions.lastTitle = "";
  actions.drawLast = [&](uint32_t id, size_t row) {
    const SheetColumn& state = panel.job.result()->sheet->columns[size_t(InstanceColumn::state)];
    drawToggles(model, id, sheetText(state, row) == "dynamic");
  };
  drawSheet(model, panel, actions);
}

}  // namespace gridscope
