// The inspector of a cell: its slots with what they name, what it refused, and the rays that it cost.
#include <algorithm>

#include "app/base/text.h"
#include "app/frame/scene_places.h"
#include "app/frame/table_exports.h"
#include "app/frame/table_rows.h"
#include "app/model/exports.h"
#include "app/model/ray_stepping.h"
#include "app/ui/panels/inspector.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

// The selected cell's contents, read once.
const CellContents& shownContents(const FrameSnapshot& frame, ivec3 cell) {
  struct Cached {
    std::shared_ptr<const Grid> grid;
    std::shared_ptr<const Demand> demand;
    ivec3 cell{-1};
    CellContents contents;
  };
  static Cached cached;
  if (cached.grid != frame.grid || cached.demand != frame.demand || cached.cell != cell)
    cached = {.grid = frame.grid, .demand = frame.demand, .cell = cell, .contents = cellContents(frame, cell)};
  return cached.contents;
}

// Stored and refused as one bar: the capacity in the middle of what was tried.
void drawFillBar(const FrameSnapshot& frame, const CellContents& contents) {
  const float width = ImGui::GetContentRegionAvail().x, height = unit(10);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float stored = float(contents.stored.size()), refused = float(contents.refusedCount);
  const float whole = std::max({stored + refused, float(frame.grid->parameters.capacity), 1.0f});
  const vec3 colour = colourMap(kColourMapViridis, stored / float(frame.grid->parameters.capacity));
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(low, ImVec2(low.x + width, low.y + height), packed(uiColour(UiColour::control)));
  const float middle = low.x + width * stored / whole, end = low.x + width * (stored + refused) / whole;
  list->AddRectFilled(low, ImVec2(middle, low.y + height), packed(ImVec4(colour.x, colour.y, colour.z, 1.0f)));
  if (refused > 0.0f) {
    list->AddRectFilled(ImVec2(middle, low.y), ImVec2(end, low.y + height), packed(meaningColour(kColourSaturated)));
    hatch(list, ImVec2(middle, low.y), ImVec2(end, low.y + height), packed(uiColour(UiColour::panel)));
  }
  ImGui::Dummy(ImVec2(width, height));
  smallText(printed("%zu stored of %d", contents.stored.size(), frame.grid->parameters.capacity), uiColour(UiColour::text));
  if (contents.refusedCount == 0) return;
  ImGui::SameLine(0.0f, unit(16));
  smallText(grouped(contents.refusedCount) + " refused", meaningColour(kColourSaturated));
  ImGui::SameLine(0.0f, unit(16));
  smallText(grouped(contents.stored.size() + contents.refusedCount) + " tried", uiColour(UiColour::text));
}

void drawFacts(WindowModel& model, ivec3 cell, const CellContents& contents) {
  const FrameSnapshot& frame = *model.frame;
  const Bounds bounds = cellBox(frame.grid->parameters, cell);
  factValue("Bounds, low", pointText(bounds.low));
  factValue("Bounds, high", pointText(bounds.high));
  const uint32_t firstDynamic = firstDynamicReference(frame.grid->parameters);
  const auto dynamic = static_cast<size_t>(
      std::count_if(contents.stored.begin(), contents.stored.end(), [&](uint32_t reference) { return reference >= firstDynamic; }));
  factValue("Static, dynamic",
            printed("%zu, %zu stored", contents.stored.size() - dynamic, dynamic) +
                (contents.refusedCount ? printed("; %u, %u refused", contents.staticRefused, contents.dynamicRefused) : ""));
  if (frame.cellRays) {
    const CellRays& rays = (*frame.cellRays)[idOfCell(frame.grid->parameters, cell)];
    factValue("Queried by", grouped(rays.read + rays.empty) + " rays");
  }
  factLabel("Cause of");
  const CellLoss* loss = lossOf(frame.ledger.get(), frame.grid->parameters, cell);
  if (!frame.truths) return textDim("known once the truth is told");
  if (!loss || loss->rays == 0) return textMono("no ray");
  if (link(grouped(loss->rays) + (loss->rays == 1 ? " ray" : " rays"), "cause of"))
    if (const auto pixel = nextRayOfCell(frame, cell, model.selected().pixel)) model.selection.selectPixel(*pixel);
  whyTooltip("Rays that do not agree with the exact hit because of what happened in this cell. Click: the next one");
}

// --- Slots and refused ------------------------------------------------------------------------------------------------------------

void drawReferenceRow(WindowModel& model, uint32_t place, uint32_t reference, bool refused) {
  const FrameSnapshot& frame = *model.frame;
  const TriangleName name = nameTriangle(frame.scene->numbered, reference);
  ImGui::TableNextRow(0, tableRowHeight());
  ImGui::TableSetColumnIndex(0);
  ImGui::PushID(static_cast<int>(place));
  const bool selected = refused ? model.selected().reference == reference : model.selected().slot == place;
  if (rowSelectable(selected)) model.selection.selectTriangle(reference);
  whyTooltip((printed("Reference 0x%08X\n", reference) + instanceName(*frame.scene, name.sceneInstance) + "\n" +
              materialName(*frame.scene, reference))
                 .c_str());
  rightNumber(std::to_string(place), refused ? meaningColour(kColourSaturated) : uiColour(UiColour::dim));
  ImGui::TableSetColumnIndex(1);
  leftNumber(printed("%08X", reference), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(2);
  smallText(meshName(*frame.scene, name.mesh), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(3);
  smallText(materialName(*frame.scene, reference), uiColour(UiColour::dim));
  ImGui::TableSetColumnIndex(4);
  rightNumber(grouped(name.triangle), uiColour(UiColour::link));
  ImGui::TableSetColumnIndex(5);
  const TriangleLoss* loss = lossOf(frame.ledger.get(), reference);
  rightNumber(loss && frame.truths ? grouped(loss->rays) : "-", uiColour(UiColour::dim));
  ImGui::PopID();
}

void drawReferenceTable(WindowModel& model, const char* id, const std::vector<uint32_t>& references, bool refused, float height) {
  TableStyle style;
  if (!ImGui::BeginTable(id, 6, kTableFlags | ImGuiTableFlags_ScrollY, ImVec2(0.0f, height))) return;
  const std::pair<const char*, float> columns[] = {
      {refused ? "#" : "slot", 0.5f}, {"reference", 1.15f}, {"mesh", 1.2f}, {"material", 1.2f}, {"triangle", 0.95f}, {"rays", 0.6f}};
  for (const auto& [title, weight] : columns) ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthStretch, weight);
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, tableRowHeight());
  for (int column = 0; column < 6; ++column)
    if (ImGui::TableSetColumnIndex(column)) tableTitle(columns[column].first, column == 0 || column > 3);
  const auto first = static_cast<uint32_t>(refused ? model.frame->grid->parameters.capacity : 0);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(references.size()), tableRowHeight());
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
      drawReferenceRow(model, first + uint32_t(row), references[size_t(row)], refused);
  ImGui::EndTable();
}

void drawRefused(WindowModel& model, const CellContents& contents, float height) {
  if (!contents.refusedKnown) {
    emptyState("Which ones is found by running the overlap test again over all triangles.");
    if (keyButton("Tell the truth", "")) model.request.truth = true;
    return;
  }
  if (contents.refused.empty()) return emptyState("The overlap test finds no other triangle for this cell.");
  drawReferenceTable(model, "refused references", contents.refused, true, height);
}

float rowsHeight(size_t rows) { return float(rows + 1) * tableRowHeight() + unit(4); }

std::string plainContents(const SceneFacts& scene, const CellContents& contents) {
  std::string text;
  for (const auto* list : {&contents.stored, &contents.refused})
    for (const uint32_t reference : *list) {
      const TriangleName name = nameTriangle(scene.numbered, reference);
      text += printed("%s 0x%08X %s triangle %u\n", list == &contents.stored ? "stored" : "refused", reference,
                      meshName(scene, name.mesh).c_str(), name.triangle);
    }
  return text;
}

}  // namespace

void drawCellInspector(WindowModel& model, ivec3 cell) {
  const FrameSnapshot& frame = *model.frame;
  const CellContents& contents = shownContents(frame, cell);
  InspectorTitle title{
      .name = "Cell " + cellNumbers(cell), .focus = cellBox(frame.grid->parameters, cell), .text = plainContents(*frame.scene, contents)};
  title.word = contents.saturated ? "saturated" : contents.stored.empty() ? "empty" : "in use";
  title.colour = contents.saturated ? kColourSaturated : contents.stored.empty() ? kColourEmpty : kColourTested;
  title.hatched = contents.saturated;
  drawInspectorTitle(model, title);
  drawFillBar(frame, contents);
  drawFacts(model, cell, contents);
  ImGui::Dummy(ImVec2(0.0f, unit(2)));

  const bool refused = contents.refusedCount > 0;
  const float room = ImGui::GetContentRegionAvail().y - unit(36) - (refused ? unit(34) : 0.0f);
  const float refusedHeight = refused ? std::min(rowsHeight(std::max<size_t>(contents.refused.size(), 3)),
                                                 std::max(0.4f * room, room - rowsHeight(contents.stored.size())))
                                      : 0.0f;
  bool csv = false;
  const bool open =
      tableSection("Slots", printed("%zu of %d", contents.stored.size(), frame.grid->parameters.capacity), contents.stored.size(), csv);
  if (csv) exportCsv(model, printed("slots_%d_%d_%d", cell.x, cell.y, cell.z), slotRows(*frame.scene, contents));
  if (open) {
    if (contents.stored.empty())
      emptyState("Every slot is blank: rays pass through this cell with one read.");
    else
      drawReferenceTable(model, "slots", contents.stored, false,
                         std::max(unit(80), std::min(rowsHeight(contents.stored.size()), room - refusedHeight)));
  }
  if (refused && sectionHeader("Refused", contents.refusedKnown ? grouped(contents.refused.size()) + ", recomputed from the overlap test"
                                                                : grouped(contents.refusedCount)))
    drawRefused(model, contents, std::max(unit(80), refusedHeight));
}

}  // namespace gridscope
