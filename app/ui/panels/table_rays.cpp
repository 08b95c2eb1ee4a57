// The table of the frame's rays. Its order is the one that "previous ray" and "next ray" follow.
#include "app/ui/panels/panels.h"
#include "app/ui/panels/sheet.h"
#include "app/ui/panels/truth_marks.h"

namespace gridscope {

// Hands the order of the rows on, when it is a new one.
static void keepRayOrder(WindowModel& model, const SheetPanel& panel) {
  static uint64_t keptNumber = 0;
  const std::shared_ptr<const TableResult>& table = panel.job.result();
  if (!table || table->number == keptNumber) return;
  keptNumber = table->number;
  model.rayOrder.pixels.clear();
  for (const uint32_t row : table->shown.rows) model.rayOrder.pixels.push_back(table->sheet->ids[row]);
  if (!table->sheet->columns.empty()) model.rayOrder.name = "Rays, by " + table->sheet->columns[table->wish.order.column].title;
}

void drawRaysTable(WindowModel& model) {
  static SheetPanel panel{.kind = TableKind::rays, .order = {size_t(RayColumn::tests), true}};
  SheetActions actions;
  actions.selectedId = model.selected().pixel;
  actions.click = [&](uint32_t id) {
    panel.shownId = id;
    model.selection.selectPixel(id);
  };
  actions.swatch = [](size_t column, double value) -> std::optional<uint32_t> {
    if (column == size_t(RayColumn::kind)) return hitKindColour(uint32_t(value));
    if (column == size_t(RayColumn::verdict)) return verdictColour(uint32_t(value));
    if (column == size_t(RayColumn::cause)) return causeColour(uint32_t(value));
    return std::nullopt;
  };
  actions.unknownWhy =
      "Not known yet: verdicts and causes need the truth (Causes tab), visits and tests the counting trace (view them once)";
  drawSheet(model, panel, actions);
  keepRayOrder(model, panel);
}

}  // namespace gridscope
