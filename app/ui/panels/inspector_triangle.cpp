// The inspector of a triangle, with the cells that hold or refused it, and of an instance, with what can be done to it.
#include <algorithm>

#include "app/base/text.h"
#include "app/frame/find_next.h"
#include "app/frame/instance_edits.h"
#include "app/frame/scene_places.h"
#include "app/frame/table_exports.h"
#include "app/frame/table_rows.h"
#include "app/model/exports.h"
#include "app/ui/panels/inspector.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

constexpr float kMostOffset = 1e6f;  // world units

// The selected triangle's cells, found once.
const TriangleCells& shownCells(const FrameSnapshot& frame, uint32_t reference) {
  struct Cached {
    std::shared_ptr<const Grid> grid;
    std::shared_ptr<const Demand> demand;
    uint32_t reference = kNoReference;
    TriangleCells cells;
  };
  static Cached cached;
  if (cached.grid != frame.grid || cached.demand != frame.demand || cached.reference != reference)
    cached = {.grid = frame.grid, .demand = frame.demand, .reference = reference, .cells = cellsOfTriangle(frame, reference)};
  return cached.cells;
}

void drawTriangleRays(WindowModel& model, uint32_t reference) {
  factLabel("Rays lost");
  const TriangleLoss* loss = lossOf(model.frame->ledger.get(), reference);
  if (!model.frame->truths || !loss) return textDim("known once the truth is told");
  if (loss->rays == 0) return textMono("none");
  if (link(grouped(loss->rays), "rays"))
    if (const auto pixel = nextRayOfTriangle(*model.frame, reference, model.selected().pixel)) model.selection.selectPixel(*pixel);
  whyTooltip("Rays that should have hit it and do not agree. Click: the next one");
}

void drawCellRow(WindowModel& model, ivec3 cell, bool refused, int id) {
  ImGui::TableNextRow(0, tableRowHeight());
  ImGui::TableSetColumnIndex(0);
  ImGui::PushID(id);
  if (rowSelectable(model.selected().cell == cell)) model.selection.selectCell(cell);
  leftNumber(cellNumbers(cell), uiColour(UiColour::link));
  ImGui::TableSetColumnIndex(1);
  swatch(refused ? kColourSaturated : kColourTriangleHit, refused);
  smallText(refused ? "refused it" : "holds it", uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(2);
  const CellFacts full = cellFacts(*model.frame->grid, cell);
  rightNumber(grouped(full.tried()), uiColour(UiColour::text));
  ImGui::TableSetColumnIndex(3);
  rightNumber(grouped(full.refused), full.refused ? meaningColour(kColourSaturated) : uiColour(UiColour::dim));
  ImGui::PopID();
}

// Those that refused it come first.
void drawCells(WindowModel& model, const TriangleCells& cells) {
  TableStyle style;
  if (!ImGui::BeginTable("cells", 4, kTableFlags | ImGuiTableFlags_ScrollY,
                         ImVec2(0.0f, std::max(unit(80), ImGui::GetContentRegionAvail().y - unit(4)))))
    return;
  const std::pair<const char*, bool> columns[] = {{"cell", false}, {"", false}, {"tried", true}, {"refused", true}};
  for (const auto& [title, right] : columns) ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthStretch, right ? 0.8f : 1.2f);
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, tableRowHeight());
  for (int column = 0; column < 4; ++column)
    if (ImGui::TableSetColumnIndex(column)) tableTitle(columns[column].first, columns[column].second);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(cells.refused.size() + cells.stored.size()), tableRowHeight());
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const auto index = static_cast<size_t>(row);
      const bool refused = index < cells.refused.size();
      drawCellRow(model, refused ? cells.refused[index] : cells.stored[index - cells.refused.size()], refused, row);
    }
  ImGui::EndTable();
}

// --- Instances --------------------------------------------------------------------------------------------------------------------

// Hide, delete, make dynamic; drag what was made dynamic.
void drawEdits(WindowModel& model, uint32_t sceneInstance, bool isDynamic) {
  const bool foreign = model.frame->scene->foreign || model.frame->scene->captureFrames > 0;
  const char* why = "A capture's scene stays as it was captured";
  std::vector<InstanceEdit>& edits = model.request.edits;
  const bool changed = editOf(edits, sceneInstance) != nullptr, gone = isTakenOut(editOf(edits, sceneInstance));
  using Kind = InstanceEdit::Kind;
  if (keyButton("Hide", "", !foreign && !gone, foreign ? why : "It is gone already"))
    setEdit(edits, {.sceneInstance = sceneInstance, .kind = Kind::hide});
  whyTooltip("Takes it out of the scene, as if it were not drawn; the static grid is built again");
  ImGui::SameLine(0.0f, unit(6));
  if (keyButton("Delete", "", !foreign && !gone, foreign ? why : "It is gone already"))
    setEdit(edits, {.sceneInstance = sceneInstance, .kind = Kind::remove});
  whyTooltip("Takes it out for good, as destruction in a game does; the static grid is built again");
  ImGui::SameLine(0.0f, unit(6));
  if (keyButton("Make dynamic", "", !foreign && !gone && !isDynamic, foreign ? why : gone ? "It is gone" : "It is dynamic already"))
    setEdit(edits, {.sceneInstance = sceneInstance, .kind = Kind::makeDynamic});
  ImGui::SameLine(0.0f, unit(6));
  if (keyButton("Restore", "", changed, "Nothing was done to it")) return dropEdit(edits, sceneInstance);
  if (!isMadeDynamic(editOf(edits, sceneInstance))) return;
  InstanceEdit edit = *editOf(edits, sceneInstance);
  textDim("Offset");
  ImGui::SameLine(0.0f, unit(8));
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::PushFont(windowFonts().mono);
  const float speed = model.frame->grid ? 0.05f * model.frame->grid->parameters.cellEdge : 0.01f;
  if (ImGui::DragFloat3("##offset", &edit.offset.x, speed, 0.0f, 0.0f, "%.3f") && glm::length(edit.offset) < kMostOffset)
    setEdit(edits, edit);
  ImGui::PopFont();
  whyTooltip("World units. Drag here, or the handles at its centre in the viewport: the grid is updated, as for any moving thing");
}

struct InstanceShape {
  uint64_t triangles = 0;
  uint32_t first = kNoReference;  // its first piece in the grid's numbering; kNoReference: it has none
};

InstanceShape shapeOf(const NumberedScene& numbered, uint32_t sceneInstance) {
  InstanceShape shape;
  for (uint32_t i = 0; i < numbered.instances.size(); ++i) {
    if (numbered.sources[i].sceneInstance != sceneInstance) continue;
    shape.triangles += numbered.instances[i].triangleCount;
    if (shape.first == kNoReference) shape.first = i;
  }
  return shape;
}

void drawLosses(WindowModel& model, uint32_t sceneInstance) {
  const GroupLoss* loss = lossOfInstance(model.frame->ledger.get(), sceneInstance);
  if (!loss) return factValue("References", "known once the truth is told");
  factValue("References", grouped(loss->stored) + " stored");
  factLabel("Refused");
  leftNumber(grouped(loss->lost) + "  " + percentOf(loss->lost, loss->lost + loss->stored),
             loss->lost ? meaningColour(kColourSaturated) : uiColour(UiColour::text));
  factValue("Rays lost", model.frame->truths ? grouped(loss->rays) : "-");
}

}  // namespace

void drawTriangleInspector(WindowModel& model, uint32_t reference) {
  const FrameSnapshot& frame = *model.frame;
  const SceneFacts& scene = *frame.scene;
  const Triangle triangle = *worldTriangle(frame, reference);
  const TriangleName name = nameTriangle(scene.numbered, reference);
  const bool dynamic = referenceInstance(reference) >= scene.numbered.staticInstanceCount;
  InspectorTitle title{.name = "Triangle " + grouped(name.triangle),
                       .word = dynamic ? "dynamic" : "static",
                       .colour = dynamic ? kColourRevisit : kColourTested,
                       .focus = boundsOfTriangle(frame, reference)};
  title.text = meshName(scene, name.mesh) + printed(" 0x%08X\n", reference) + pointText(triangle.a) + "\n" + pointText(triangle.b) + "\n" +
               pointText(triangle.c);
  drawInspectorTitle(model, title);
  factValue("Mesh", meshName(scene, name.mesh));
  factLabel("Instance");
  if (link(instanceName(scene, name.sceneInstance), "instance")) model.selection.selectInstance(name.sceneInstance);
  factValue("Material", materialName(scene, reference));
  factValue("Reference", printed("0x%08X", reference));
  factValue("Corner a", pointText(triangle.a));
  factValue("Corner b", pointText(triangle.b));
  factValue("Corner c", pointText(triangle.c));
  factValue("Area", printed("%.5g", triangleArea(triangle)));
  if (!frame.grid) return;
  const TriangleCells& cells = shownCells(frame, reference);
  factLabel("Stored, refused");
  textMono(grouped(cells.stored.size()) + ",");
  ImGui::SameLine(0.0f, unit(5));
  leftNumber(cells.refusedKnown ? grouped(cells.refused.size()) : "?",
             cells.refused.empty() ? uiColour(UiColour::text) : meaningColour(kColourSaturated));
  if (!cells.refusedKnown) whyTooltip("Known once the truth is told");
  drawTriangleRays(model, reference);
  ImGui::Dummy(ImVec2(0.0f, unit(2)));
  bool csv = false;
  const size_t count = cells.stored.size() + cells.refused.size();
  const bool open = tableSection("Cells", grouped(count), count, csv);
  if (csv) exportCsv(model, printed("cells_of_%08X", reference), triangleCellRows(cells));
  if (!open) return;
  if (cells.stored.empty() && cells.refused.empty()) return emptyState("No cell holds it: it has no area, or lies outside the grid.");
  drawCells(model, cells);
}

void drawInstanceInspector(WindowModel& model, uint32_t sceneInstance) {
  const FrameSnapshot& frame = *model.frame;
  const SceneFacts& scene = *frame.scene;
  const InstanceShape shape = shapeOf(scene.numbered, sceneInstance);
  const bool gone = isTakenOut(editOf(model.request.edits, sceneInstance));
  const bool dynamic = shape.first != kNoReference && shape.first >= scene.numbered.staticInstanceCount;
  InspectorTitle title{.name = instanceName(scene, sceneInstance),
                       .word = gone      ? "taken out"
                               : dynamic ? "dynamic"
                                         : "static",
                       .colour = gone      ? kColourEmpty
                                 : dynamic ? kColourRevisit
                                           : kColourTested};
  if (shape.first != kNoReference) title.focus = boundsOfInstance(frame, sceneInstance);
  drawInspectorTitle(model, title);
  const uint32_t mesh = shape.first != kNoReference ? scene.numbered.sources[shape.first].mesh : 0;
  factValue("Instance", std::to_string(sceneInstance));
  factValue("Mesh", shape.first != kNoReference                   ? meshName(scene, mesh)
                    : sceneInstance < scene.meshOfInstance.size() ? scene.meshOfInstance[sceneInstance]
                                                                  : "-");
  if (shape.first != kNoReference) factValue("Material", materialName(scene, makeReference(shape.first, 0)));
  factValue("Triangles", grouped(shape.triangles));
  drawLosses(model, sceneInstance);
  if (title.focus) {
    factValue("Bounds, low", pointText(title.focus->low));
    factValue("Bounds, high", pointText(title.focus->high));
  }
  ImGui::Dummy(ImVec2(0.0f, unit(4)));
  drawEdits(model, sceneInstance, dynamic);
}

}  // namespace gridscope
