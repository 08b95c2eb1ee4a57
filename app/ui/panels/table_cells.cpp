// The table of cells that were asked to take something.
#include <cmath>

#include "app/ui/panels/panels.h"
#include "app/ui/panels/sheet.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

void drawCellsTable(WindowModel& model) {
  static SheetPanel panel{.kind = TableKind::cells, .order = {size_t(CellColumn::tried), true}};
  SheetActions actions;
  if (const auto& cell = model.selected().cell; cell && model.frame && gridContains(model.frame->gridShape(), *cell))
    actions.selectedId = idOfCell(model.frame->gridShape(), *cell);
  actions.click = [&](uint32_t id) {
    const GridParameters& grid = panel.job.result()->wish.frame->gridShape();
    panel.shownId = id;
    model.selection.selectCell(cellOfId(grid, id));
    model.focusWanted = cellBox(grid, cellOfId(grid, id));
  };
  actions.swatch = [](size_t column, double value) -> std::optional<uint32_t> {
    const bool loss = column == size_t(CellColumn::refused) || column == size_t(CellColumn::raysLost);
    return loss && value > 0.0 ? std::optional(kColourSaturated) : std::nullopt;
  };
  actions.unknownWhy = "Not known yet: it needs the truth (Causes tab)";
  drawSheet(model, panel, actions);
}

}  // namespace gridscope
