// See sheet.h.
#include "app/ui/panels/sheet.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/model/exports.h"
#include "app/model/flow.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

// --- The strip above the table ----------------------------------------------------------------------------------------------------

std::string areaText(const PixelArea& area) {
  return printed("area %d, %d to %d, %d", area.begin.x, area.begin.y, area.end.x - 1, area.end.y - 1);
}

// A filter at work, with a cross that ends it; true when clicked.
bool filterChip(const std::string& text, const char* id) {
  ImGui::SameLine(0.0f, unit(8));
  return smallButton((text + "  \u00d7").c_str(), id, "Ends this filter");
}

void drawExport(WindowModel& model, SheetPanel& panel) {
  const std::shared_ptr<const TableResult>& table = panel.job.result();
  if (!exportButton("Writes the rows shown, in this order, as a CSV file", table && !table->shown.rows.empty(), "The table has no rows"))
    return;
  exportCsv(model, table->sheet->name, table->shown.rows.size(), [table] { return sheetCsv(*table->sheet, table->shown.rows); });
}

void drawStrip(WindowModel& model, SheetPanel& panel) {
  const std::shared_ptr<const TableResult>& table = panel.job.result();
  const size_t total = table ? table->sheet->rowCount() : 0;
  std::string count = grouped(total) + " " + tableNoun(panel.kind, total != 1);
  if (table && table->shown.rows.size() != total) count = grouped(table->shown.rows.size()) + " of " + count;
  beginStrip();
  textMono(count);
  if (model.area && filterChip(areaText(*model.area), "area")) model.area.reset();
  if (!model.search.empty() && filterChip("search \u201c" + model.search + "\u201d", "search")) model.search.clear();
  if (panel.job.running()) ImGui::SameLine(0.0f, unit(8)), textDim("sorting...");
  drawExport(model, panel);
}

// --- An empty table ---------------------------------------------------------------------------------------------------------------

// Says which filter left nothing.
void drawEmpty(WindowModel& model, const SheetPanel& panel, const TableResult& table) {
  const std::string many = tableNoun(panel.kind, true);
  const size_t total = table.sheet->rowCount();
  if (total == 0)
    return emptyState(panel.kind == TableKind::rays ? "This frame has no rays." : ("The grid holds no " + many + ".").c_str());
  if (table.shown.inArea == 0) {
    emptyState(("The selected area leaves none of " + grouped(total) + " " + many + ".").c_str());
    if (link("Clear the area", "clear-area")) model.area.reset();
    return;
  }
  emptyState(("The search \u201c" + table.wish.search + "\u201d leaves none of " + grouped(table.shown.inArea) + " " + many + ".").c_str());
  if (link("Clear the search", "clear-search")) model.search.clear();
}

// --- Titles -----------------------------------------------------------------------------------------------------------------------

bool isNumber(const SheetColumn& column) {
  return column.kind != ColumnKind::word && column.kind != ColumnKind::place && column.kind != ColumnKind::reference;
}

float columnWeight(const SheetColumn& column) {
  if (column.kind == ColumnKind::word) return 1.5f;
  return column.kind == ColumnKind::place || column.kind == ColumnKind::reference ? 1.2f : 1.0f;
}

void setUpColumns(const Sheet& sheet, const SheetPanel& panel, const SheetActions& actions) {
  for (size_t index = 0; index < sheet.columns.size(); ++index) {
    const SheetColumn& column = sheet.columns[index];
    const bool fallsFirst = isNumber(column);
    ImGuiTableColumnFlags flags = fallsFirst ? ImGuiTableColumnFlags_PreferSortDescending : 0;
    if (index == panel.order.column) flags |= ImGuiTableColumnFlags_DefaultSort;
    ImGui::TableSetupColumn(column.title.c_str(), flags, columnWeight(column), static_cast<ImGuiID>(index));
  }
  if (actions.lastTitle)
    ImGui::TableSetupColumn(actions.lastTitle, ImGuiTableColumnFlags_NoSort, 2.7f, static_cast<ImGuiID>(sheet.columns.size()));
  ImGui::TableSetupScrollFreeze(0, 1);
}

void drawTitles(const Sheet& sheet, const SheetActions& actions) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, unit(20));
  for (size_t index = 0; index < sheet.columns.size(); ++index) {
    const SheetColumn& column = sheet.columns[index];
    if (!ImGui::TableSetColumnIndex(static_cast<int>(index))) continue;
    tableTitle(column.title.c_str(), isNumber(column));
    const std::string about = column.known ? column.about : column.about + ". " + actions.unknownWhy;
    whyTooltip(about.c_str());
  }
  if (actions.lastTitle && ImGui::TableSetColumnIndex(static_cast<int>(sheet.columns.size()))) tableTitle(actions.lastTitle, false);
}

void takeSorting(SheetPanel& panel) {
  ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (!specs || !specs->SpecsDirty || specs->SpecsCount == 0) return;
  panel.order = {.column = specs->Specs[0].ColumnUserID, .falling = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending};
  specs->SpecsDirty = false;
}

// --- Rows -------------------------------------------------------------------------------------------------------------------------

void drawValue(const SheetColumn& column, size_t row, const std::optional<uint32_t>& colour, bool names) {
  const std::string text = sheetText(column, row);
  const bool known = column.known && !std::isnan(column.values[row]);
  if (column.kind == ColumnKind::word) {
    if (colour) swatch(*colour), ImGui::SameLine(0.0f, unit(6));
    if (known)
      smallText(text, names ? uiColour(UiColour::link) : uiColour(UiColour::text));
    else
      smallText(text, uiColour(UiColour::disabled));
    return;
  }
  ImVec4 ink = colour ? meaningColour(*colour) : uiColour(UiColour::text);
  if (names) ink = uiColour(UiColour::link);
  if (!known) ink = uiColour(UiColour::disabled);
  if (isNumber(column))
    rightNumber(text, ink);
  else
    leftNumber(text, ink);
}

void drawRow(const Sheet& sheet, size_t row, const SheetActions& actions) {
  const uint32_t id = sheet.ids[row];
  ImGui::TableNextRow(0, unit(20));
  ImGui::TableSetColumnIndex(0);
  ImGui::PushID(static_cast<int>(id));
  if (rowSelectable(actions.selectedId == id)) actions.click(id);
  for (size_t index = 0; index < sheet.columns.size(); ++index) {
    if (index > 0 && !ImGui::TableSetColumnIndex(static_cast<int>(index))) continue;
    const SheetColumn& column = sheet.columns[index];
    const bool known = column.known && !std::isnan(column.values[row]);
    drawValue(column, row, known && actions.swatch ? actions.swatch(index, column.values[row]) : std::nullopt, index == 0);
  }
  if (actions.lastTitle && ImGui::TableSetColumnIndex(static_cast<int>(sheet.columns.size()))) actions.drawLast(id, row);
  ImGui::PopID();
}

// A selection made elsewhere comes into sight.
void scrollToSelection(SheetPanel& panel, const TableResult& table, const SheetActions& actions) {
  if (panel.shownId == actions.selectedId) return;
  panel.shownId = actions.selectedId;
  if (!actions.selectedId) return;
  const std::vector<uint32_t>& rows = table.shown.rows;
  const auto found = std::find_if(rows.begin(), rows.end(), [&](uint32_t row) { return table.sheet->ids[row] == *actions.selectedId; });
  if (found == rows.end()) return;
  const float top = float(found - rows.begin()) * tableRowHeight(), height = ImGui::GetWindowHeight() - unit(20);
  if (top < ImGui::GetScrollY() || top + tableRowHeight() > ImGui::GetScrollY() + height)
    ImGui::SetScrollY(std::max(0.0f, top - 0.5f * height));
}

// Up and Down: as a click on the row beside the selected one.
void stepRow(WindowModel& model, SheetPanel& panel, const TableResult& table, const SheetActions& actions) {
  if (model.rowStep == 0) return;
  const std::vector<uint32_t>& rows = table.shown.rows;
  std::optional<size_t> selected;
  for (size_t place = 0; actions.selectedId && place < rows.size() && !selected; ++place)
    if (table.sheet->ids[rows[place]] == *actions.selectedId) selected = place;
  if (const auto row = rowBeside(selected, model.rowStep, rows.size()); row && row != selected) {
    actions.click(table.sheet->ids[rows[*row]]);
    panel.shownId.reset();  // comes into sight, as a selection made elsewhere does
  }
}

void drawTable(SheetPanel& panel, const TableResult& table, const SheetActions& actions) {
  const Sheet& sheet = *table.sheet;
  const int columnCount = static_cast<int>(sheet.columns.size()) + (actions.lastTitle ? 1 : 0);
  TableStyle style;
  if (!ImGui::BeginTable(sheet.name.c_str(), columnCount, kTableFlags | ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollY)) return;
  setUpColumns(sheet, panel, actions);
  drawTitles(sheet, actions);
  takeSorting(panel);
  scrollToSelection(panel, table, actions);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(table.shown.rows.size()), tableRowHeight());
  while (clipper.Step())
    for (int at = clipper.DisplayStart; at < clipper.DisplayEnd; ++at) drawRow(sheet, table.shown.rows[size_t(at)], actions);
  ImGui::EndTable();
}

}  // namespace

void drawSheet(WindowModel& model, SheetPanel& panel, const SheetActions& actions) {
  if (!model.frame || !model.frame->scene) return emptyState("No frame yet: it shows here as soon as the first one is done.");
  // While the stages run again the last table stays.
  if (canMakeSheet(panel.kind, *model.frame))
    panel.job.want({.kind = panel.kind, .frame = model.frame, .area = model.area, .search = model.search, .order = panel.order});
  drawStrip(model, panel);
  const std::shared_ptr<const TableResult> table = panel.job.result();
  if (!table) return emptyState("Counting...");
  if (table->shown.rows.empty()) return drawEmpty(model, panel, *table);
  stepRow(model, panel, *table, actions);
  drawTable(panel, *table, actions);
}

}  // namespace gridscope
