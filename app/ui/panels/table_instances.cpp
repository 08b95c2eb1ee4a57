// The table of the scene's instances, with what a person can do to them: hide, and make dynamic.
#include "app/frame/instance_edits.h"
#include "app/ui/panels/panels.h"
#include "app/ui/panels/sheet.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

void drawToggles(WindowModel& model, uint32_t instance, bool animated) {
  using Kind = InstanceEdit::Kind;
  std::vector<InstanceEdit>& edits = model.request.edits;
  const InstanceEdit* edit = editOf(edits, instance);
  const bool captured = model.frame->scene->captureFrames > 0, gone = isTakenOut(edit), made = isMadeDynamic(edit);
  const char* captureWhy = "A capture's instances stay as they were captured";
  if (rowButton(gone ? "Show" : "Hide", "hide",
                gone ? "Puts it back; the static grid is built again" : "Takes it away; the static grid is built again", !captured,
                captureWhy)) {
    if (gone)
      dropEdit(edits, instance);
    else
      setEdit(edits, {.sceneInstance = instance, .kind = Kind::hide});
  }
  ImGui::SameLine(0.0f, unit(4));
  const char* why = captured ? captureWhy : gone ? "It was taken out: show it first" : "It is dynamic in the scene already";
  if (rowButton(made ? "Static" : "Dynamic", "dynamic",
                made ? "Makes it static again, where it was" : "Makes it dynamic: cleared and added again every frame, and can be dragged",
                !captured && !gone && (made || !animated), why)) {
    if (made)
      dropEdit(edits, instance);
    else
      setEdit(edits, {.sceneInstance = instance, .kind = Kind::makeDynamic});
  }
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
