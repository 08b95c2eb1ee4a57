// What is drawn over the picture of a view, in 3D: boxes of cells, the selected ray with its steps, tested triangles, the selection, the clip box.
#include "app/ui/viewport/overlay.h"

#include <algorithm>
#include <cstring>

#include "app/base/beside.h"
#include "app/base/text.h"
#include "app/frame/cell_boxes.h"
#include "app/frame/table_rows.h"
#include "app/ui/widgets/step_parts.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

constexpr size_t kMostBoxes = 3000;
constexpr uint32_t kColourSaturatedBox = 0xFBC4E4;  // light pink: lines over what is shaded pink

ImU32 packedColour(const vec3& colour, float alpha) {
  const uint32_t bytes = packBytes(colour);
  return IM_COL32(bytes & 255u, (bytes >> 8) & 255u, (bytes >> 16) & 255u, int(255.0f * alpha));
}

// --- Boxes of cells ---------------------------------------------------------------------------------------------------------------

// A visible piece of an edge, in pixels of the frame.
struct BoxLine {
  vec2 a, b;
  ImU32 colour;
  float width;
};

// The cells that boxes can stand for: a scan of the whole grid, made beside the window.
struct OccupiedCells {
  std::shared_ptr<const Grid> grid;
  std::vector<BoxCell> cells;
};

// The last ones made, of the frame's grid or of the one before; nullptr before the first.
std::shared_ptr<const OccupiedCells> occupiedOf(const FrameSnapshot& frame) {
  static Beside<std::shared_ptr<const OccupiedCells>> job;
  job.want({frame.grid.get(), frame.cellRays.get()}, [grid = frame.grid, rays = frame.cellRays] {
    return std::make_shared<const OccupiedCells>(
        OccupiedCells{grid, occupiedCells(*grid, rays ? std::span<const CellRays>(*rays) : std::span<const CellRays>())});
  });
  return job.value().value_or(nullptr);
}

// The boxes of one state of frame and overlays, worked out once.
struct BoxLines {
  std::shared_ptr<const OccupiedCells> occupied;
  std::shared_ptr<const std::vector<GatherPixel>> gather;
  CameraParameters camera{};
  Overlays overlays;
  uint32_t colourMap = 0;
  float top = 1.0f;  // value at the end of the colours
  std::vector<BoxLine> lines;
  BoxChoice choice;
};

bool sameBoxes(const Overlays& a, const Overlays& b) {
  return a.cellBoxes == b.cellBoxes && a.saturatedBoxes == b.saturatedBoxes && a.boxMeasure == b.boxMeasure && a.boxRange == b.boxRange &&
         a.clip == b.clip && a.clipBox.low == b.clipBox.low && a.clipBox.high == b.clipBox.high;
}

void addEdge(BoxLines& boxes, const BoxEdge& edge, float farthest, const WindowModel& model) {
  const GridParameters& grid = boxes.occupied->grid->parameters;
  const std::span<const GatherPixel> gather = boxes.gather ? std::span<const GatherPixel>(*boxes.gather) : std::span<const GatherPixel>();
  const float fill = float(edge.value) / boxes.top;
  // Beyond the capacity the map ends; rays have no such end.
  const bool pink = edge.saturated && (model.overlays.saturatedBoxes || boxMeasure(model.overlays).byCapacity);
  const vec3 colour = pink ? unpackColour(kColourSaturatedBox) : gridscope::colourMap(model.colourMap, fill);
  for (const ProjectedLine& piece : projectLine(boxes.camera, gather, edge.line, 0.1f * grid.cellEdge)) {
    if (piece.hidden) continue;
    const float fade = 1.0f - 0.75f * std::clamp(0.5f * (piece.a.depth + piece.b.depth) / farthest, 0.0f, 1.0f);
    boxes.lines.push_back(
        {piece.a.pixel, piece.b.pixel, packedColour(colour, pink ? std::min(1.0f, fade * 1.2f) : 0.85f * fade), pink ? 1.3f : 1.0f});
  }
}

const BoxLines& boxLines(const WindowModel& model, const CameraParameters& camera) {
  static BoxLines boxes;
  const FrameSnapshot& frame = *model.frame;
  const std::shared_ptr<const OccupiedCells> occupied = occupiedOf(frame);
  if (!occupied) return boxes;
  const bool same = boxes.occupied == occupied && boxes.gather == frame.gather &&
                    std::memcmp(&boxes.camera, &camera, sizeof(camera)) == 0 && sameBoxes(boxes.overlays, model.overlays) &&
                    boxes.colourMap == model.colourMap;
  if (same) return boxes;
  boxes.occupied = occupied, boxes.gather = frame.gather, boxes.camera = camera, boxes.overlays = model.overlays,
  boxes.colourMap = model.colourMap;
  const GridParameters& grid = occupied->grid->parameters;
  const BoxMeasure& measure = boxMeasure(model.overlays);
  boxes.top = boxTop(measure, occupied->cells, grid.capacity);
  boxes.choice = chooseBoxes(occupied->cells, grid, model.overlays, camera, kMostBoxes);
  boxes.lines.clear();
  if (boxes.choice.cells.empty()) return boxes;
  const Bounds last = cellBounds(grid, boxes.choice.cells.back().full.cell);
  const float farthest = std::max(glm::length(0.5f * (last.low + last.high) - camera.eye), 1e-6f);
  for (const BoxEdge& edge : boxEdgesOf(boxes.choice.cells, grid, measure)) addEdge(boxes, edge, farthest, model);
  return boxes;
}

// What the boxes stand for, with the colours' ends, and how many are left out.
void drawBoxNote(const WindowModel& model, const OverlayPainter& painter, const BoxLines& boxes) {
  const BoxMeasure& measure = boxMeasure(model.overlays);
  std::string text;
  if (model.overlays.cellBoxes)
    text = measure.ofRays && !model.frame->cellRays ? "boxes: rays are being counted"
                                                    : std::string("boxes: ") + measure.name + printed(", 0 to %.0f", double(boxes.top));
  if (boxes.choice.wanted > boxes.choice.cells.size())
    text += (text.empty() ? "boxes: " : "; ") + std::string("the nearest ") + grouped(boxes.choice.cells.size()) + " of " +
            grouped(boxes.choice.wanted);
  if (text.empty()) return;
  ImFont* font = windowFonts().sansSmall;
  const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.c_str()).x;
  const ImVec2 low(0.5f * (painter.pane.min.x + painter.pane.max.x - width) - unit(8), painter.pane.min.y + unit(8));
  painter.list->AddRectFilled(low, ImVec2(low.x + width + unit(16), low.y + unit(20)), IM_COL32(20, 23, 27, 200), unit(3));
  painter.list->AddText(font, font->FontSize, ImVec2(low.x + unit(8), low.y + unit(3)), IM_COL32(217, 223, 229, 255), text.c_str());
}

void drawBoxes(const WindowModel& model, const OverlayPainter& painter) {
  if (!model.overlays.cellBoxes && !model.overlays.saturatedBoxes) return;
  const BoxLines& boxes = boxLines(model, painter.pane.camera);
  for (const BoxLine& line : boxes.lines)
    painter.list->AddLine(painter.pane.toScreen(line.a), painter.pane.toScreen(line.b), line.colour, unit(line.width));
  drawBoxNote(model, painter, boxes);
}

// --- The selection ----------------------------------------------------------------------------------------------------------------

constexpr LineStyle kSelectedStyle{.colour = IM_COL32(255, 255, 255, 255), .width = 2.4f, .hidden = HiddenParts::dashed, .halo = 1.5f};

void drawSelection(const WindowModel& model, const OverlayPainter& painter) {
  const FrameSnapshot& frame = *model.frame;
  const Selection& selected = model.selected();
  if (!model.overlays.selection) return;
  if (selected.last == Selected::cell && selected.cell && gridContains(frame.grid->parameters, *selected.cell)) {
    painter.box(cellBounds(frame.grid->parameters, *selected.cell), kSelectedStyle);
    const CellFacts full = cellFacts(*frame.grid, *selected.cell);
    drawSelectionCallout(model, painter, gridCellCentre(frame.grid->parameters, *selected.cell), "Cell " + cellNumbers(*selected.cell),
                         grouped(full.tried()) + " tried, " + grouped(full.stored) + " stored", full.saturated);
  }
  if (selected.last == Selected::triangle && selected.reference)
    if (const Triangle* triangle = worldTriangle(frame, *selected.reference)) {
      painter.triangle(*triangle, kSelectedStyle);
      const TriangleName name = nameTriangle(frame.scene->numbered, *selected.reference);
      drawSelectionCallout(model, painter, (triangle->a + triangle->b + triangle->c) / 3.0f, "Triangle " + grouped(name.triangle),
                           meshName(*frame.scene, name.mesh), false);
    }
  if (selected.last == Selected::instance && selected.instance) {
    const Bounds bounds = boundsOfInstance(frame, *selected.instance);
    LineStyle style = kSelectedStyle;
    style.width = 1.6f;
    if (!bounds.empty()) painter.box(bounds, style);
  }
}

}  // namespace

std::span<const BoxCell> drawnBoxes(const WindowModel& model, const PaneRect& pane) {
  if (!model.frame->grid || (!model.overlays.cellBoxes && !model.overlays.saturatedBoxes)) return {};
  return boxLines(model, pane.camera).choice.cells;
}

void drawOverlays(const WindowModel& model, const PaneRect& pane) {
  const FrameSnapshot* frame = model.frame.get();
  if (!frame || !frame->grid || !frame->scene) return;
  const CameraParameters& camera = pane.camera;
  const bool seen = frame->gather && frame->gather->size() == size_t(camera.width) * camera.height;
  const Overlays& overlays = model.overlays;
  OverlayPainter painter{.list = ImGui::GetWindowDrawList(), .pane = pane, .bias = 0.12f * frame->grid->parameters.cellEdge};
  if (seen) painter.gather = *frame->gather;
  if (overlays.clip && !overlays.clipBox.empty()) painter.clip = &overlays.clipBox;

  painter.list->PushClipRect(pane.min, pane.max, true);
  drawBoxes(model, painter);
  drawRayOverlay(model, painter);
  drawSelection(model, painter);
  if (painter.clip) {
    painter.clip = nullptr;
    painter.box(overlays.clipBox, {.colour = packed(uiColour(UiColour::accent)), .width = 1.4f, .hidden = HiddenParts::dashed});
  }
  painter.list->PopClipRect();
}

}  // namespace gridscope
