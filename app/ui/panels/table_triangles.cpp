// The table of all triangles that the grid was to take.
#include "app/ui/panels/panels.h"
#include "app/ui/panels/sheet.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

void drawTrianglesTable(WindowModel& model) {
  static SheetPanel panel{.kind = TableKind::triangles, .order = {size_t(TriangleColumn::stored), true}};
  SheetActions actions;
  actions.selectedId = model.selected().reference;
  actions.click = [&](uint32_t id) {
    panel.shownId = id;
    model.selection.selectTriangle(id);
    if (const Bounds bounds = boundsOfTriangle(*panel.job.result()->wish.frame, id); !bounds.empty()) model.focusWanted = bounds;
  };
  actions.swatch = [](size_t column, double value) -> std::optional<uint32_t> {
    const bool loss = column == size_t(TriangleColumn::lost) || column == size_t(TriangleColumn::raysLost);
    return loss && value > 0.0 ? std::optional(kColourSaturated) : std::nullopt;
  };
  actions.unknownWhy = "Not known yet: it needs the truth (Causes tab)";
  drawSheet(model, panel, actions);
}

}  // namespace gridscope
