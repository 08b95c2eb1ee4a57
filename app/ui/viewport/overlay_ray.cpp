// The selected ray over the viewport (overlay.h).
#include <algorithm>
#include <cmath>
#include <set>

#include "app/base/text.h"
#include "app/frame/table_rows.h"
#include "app/model/ray_stepping.h"
#include "app/ui/viewport/overlay.h"
#include "app/ui/viewport/pane_parts.h"
#include "app/ui/widgets/step_parts.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/trace/triangle_test.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

constexpr float kLeastBetween = 15.0f;  // from one step's ring to the next, pixels at UI scale 1
constexpr size_t kMostTriangles = 400;  // tested ones that are drawn

void drawVisitedCells(const OverlayPainter& painter, const FrameSnapshot& frame, const RecordedRay& ray, uint32_t selected) {
  const GridParameters& grid = frame.grid->parameters;
  for (uint32_t step = 0; step < ray.record.steps.size(); ++step) {
    const StepRecord& at = ray.record.steps[step];
    if (at.outcome == kStepRevisit || !gridContains(grid, at.cell) || step == selected) continue;
    const bool empty = at.outcome == kStepEmpty;
    const ImU32 colour = pictureColour(stepLook(stepOutcome(ray.record, step)).colour, empty ? 0.35f : 0.85f);
    painter.box(cellBounds(grid, at.cell), {.colour = colour, .width = 1.0f});
  }
  if (gridContains(grid, ray.record.steps[selected].cell))
    painter.box(cellBounds(grid, ray.record.steps[selected].cell),
                {.colour = IM_COL32_WHITE, .width = 1.8f, .hidden = HiddenParts::dashed, .halo = 1.0f});
}

void drawTriangles(const WindowModel& model, const OverlayPainter& painter, const StepFacts& facts) {
  size_t drawn = 0;
  for (const TestFacts& test : facts.tests) {
    const Triangle* triangle = worldTriangle(*model.frame, test.test.reference);
    if (!triangle || ++drawn > kMostTriangles) continue;
    const bool hit = test.test.verdict == kTestHit;
    painter.triangle(*triangle,
                     {.colour = pictureColour(hit ? kColourTriangleHit : kColourTested, hit ? 1.0f : 0.7f), .width = hit ? 2.0f : 1.0f});
  }
  for (const RefusedFacts& refused : facts.refusedTests) {
    const Triangle* triangle = worldTriangle(*model.frame, refused.test.reference);
    if (!triangle || ++drawn > kMostTriangles) continue;
    painter.triangle(*triangle, {.colour = pictureColour(kColourSaturated, refused.wouldHit ? 1.0f : 0.6f),
                                 .width = refused.wouldHit ? 2.2f : 1.0f,
                                 .dashed = !refused.wouldHit});
  }
}

void drawSegments(const OverlayPainter& painter, const FrameSnapshot& frame, const RecordedRay& ray) {
  for (uint32_t step = 0; step < ray.record.steps.size(); ++step) {
    const StepOutcome outcome = stepOutcome(ray.record, step);
    const WorldLine line{rayPoint(ray.ray, ray.record.steps[step].start), rayPoint(ray.ray, shownEnd(frame, ray, step))};
    painter.line(line, {.colour = pictureColour(stepLook(outcome).colour),
                        .width = 3.2f,
                        .hidden = HiddenParts::dashed,
                        .halo = 1.4f,
                        .dashed = outcome == StepOutcome::revisit});
  }
}

// Rings where steps start, as far apart as they can be told apart; the selected one with its glyph.
void drawStepMarks(const OverlayPainter& painter, const RecordedRay& ray, uint32_t selected) {
  ImVec2 last(-1e6f, -1e6f);
  for (uint32_t step = 1; step < ray.record.steps.size(); ++step) {
    const std::optional<ImVec2> at = painter.place(rayPoint(ray.ray, ray.record.steps[step].start));
    if (!at || !painter.inPane(*at) || std::hypot(at->x - last.x, at->y - last.y) < unit(kLeastBetween)) continue;
    last = *at;
    painter.list->AddCircleFilled(*at, unit(3.4f), IM_COL32(20, 23, 27, 255), 12);
    painter.list->AddCircle(*at, unit(3.0f), IM_COL32(255, 255, 255, 230), 12, unit(1.2f));
  }
  if (const std::optional<ImVec2> at = painter.place(rayPoint(ray.ray, ray.record.steps[selected].start)); at && painter.inPane(*at)) {
    painter.list->AddCircleFilled(*at, unit(8), IM_COL32(20, 23, 27, 220), 20);
    drawStepGlyph(painter.list, *at, unit(9), stepOutcome(ray.record, selected));
    painter.list->AddCircle(*at, unit(8), IM_COL32_WHITE, 20, unit(1.4f));
  }
}

void drawEnds(const OverlayPainter& painter, const RecordedRay& ray) {
  if (const std::optional<ImVec2> at = painter.place(ray.ray.origin); at && painter.inPane(*at)) {
    painter.list->AddCircle(*at, unit(6.5f), IM_COL32(0, 0, 0, 170), 20, unit(4));
    painter.list->AddCircle(*at, unit(6), IM_COL32_WHITE, 20, unit(1.8f));
    painter.list->AddCircle(*at, unit(2.5f), IM_COL32_WHITE, 12, unit(1.4f));
  }
  const Hit& hit = ray.record.hit;
  if (hit.kind != kHitTriangle && hit.kind != kHitVoxel) return;
  const std::optional<ImVec2> at = painter.place(rayPoint(ray.ray, hit.t));
  if (!at || !painter.inPane(*at)) return;
  const auto diamond = [&](float half, ImU32 colour) {
    painter.list->AddQuadFilled(ImVec2(at->x, at->y - half), ImVec2(at->x + half, at->y), ImVec2(at->x, at->y + half),
                                ImVec2(at->x - half, at->y), colour);
  };
  diamond(unit(9), IM_COL32(20, 23, 27, 230));
  diamond(unit(6.5f), pictureColour(hit.kind == kHitVoxel ? kColourVoxelHit : kColourTriangleHit));
}

// What the colours mean: only the outcomes that this ray has.
void drawLegend(const OverlayPainter& painter, const RecordedRay& ray) {
  std::set<StepOutcome> outcomes;
  for (uint32_t step = 0; step < ray.record.steps.size(); ++step) outcomes.insert(stepOutcome(ray.record, step));
  ImFont* font = windowFonts().sansSmall;
  const auto wordWidth = [&](StepOutcome outcome) {
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, stepLook(outcome).word.data()).x;
  };
  float width = unit(8);
  for (const StepOutcome outcome : outcomes) width += unit(30) + wordWidth(outcome);
  const ImVec2 low = lowerLeft(painter.pane, ImVec2(width, unit(22))), high(low.x + width, low.y + unit(22));
  painter.list->AddRectFilled(low, high, IM_COL32(20, 23, 27, 215), unit(3));
  float x = low.x + unit(8);
  for (const StepOutcome outcome : outcomes) {
    const StepLook& look = stepLook(outcome);
    drawStepGlyph(painter.list, ImVec2(x + unit(6), low.y + unit(11)), unit(10), outcome);
    painter.list->AddText(font, font->FontSize, ImVec2(x + unit(16), low.y + unit(4)), IM_COL32(217, 223, 229, 255), look.word.data(),
                          look.word.data() + look.word.size());
    x += unit(30) + wordWidth(outcome);
  }
}

void drawRay(const WindowModel& model, const OverlayPainter& painter, const ShownStep& shown) {
  const Overlays& overlays = model.overlays;
  const FrameSnapshot& frame = *model.frame;
  const RecordedRay& ray = *shown.ray;
  if (overlays.visitedCells) drawVisitedCells(painter, frame, ray, shown.facts.index);
  if (overlays.testedTriangles) drawTriangles(model, painter, shown.facts);
  if (!overlays.raySegments) return;
  drawSegments(painter, frame, ray);
  drawStepMarks(painter, ray, shown.facts.index);
  drawEnds(painter, ray);
}

}  // namespace

float shownEnd(const FrameSnapshot& frame, const RecordedRay& ray, uint32_t step) {
  const std::vector<StepRecord>& steps = ray.record.steps;
  const bool hits = ray.record.hit.kind == kHitTriangle || ray.record.hit.kind == kHitVoxel;
  if (step + 1 < steps.size()) return steps[step + 1].start;
  if (hits) return ray.record.hit.t;
  return steps[step].outcome == kStepOutside ? steps[step].start : steps[step].start + frame.grid->parameters.cellEdge;
}

bool rayLegendShown(const WindowModel& model, const PaneRect& pane) {
  return model.overlays.raySegments && pane.max.x - pane.min.x >= unit(kLeastCallout) && shownStepFacts(model);
}

void drawRayOverlay(const WindowModel& model, const OverlayPainter& painter) {
  const ShownStep* shown = shownStepFacts(model);
  if (!shown) return;
  drawRay(model, painter, *shown);
  if (!rayLegendShown(model, painter.pane)) return;
  drawCallouts(model, painter, *shown);
  drawLegend(painter, *shown->ray);
}

void drawRayInLens(const WindowModel& model, const OverlayPainter& painter) {
  if (const ShownStep* shown = shownStepFacts(model)) drawRay(model, painter, *shown);
}

}  // namespace gridscope
