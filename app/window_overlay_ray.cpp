// The selected ray over the viewport (window_overlay.h).
#include <algorithm>
#include <cmath>
#include <set>

#include "app/panel_step_parts.h"
#include "app/ray_stepping.h"
#include "app/table_rows.h"
#include "app/text.h"
#include "app/window_overlay.h"
#include "app/window_widgets.h"
#include "shaders/shared/palette.h"

namespace gridscope {

namespace {

constexpr size_t kMostTriangles = 400;                 // tested ones that are drawn
constexpr float kLeastCallout = 480.0f;                // width of a pane that has room for callouts, pixels at UI scale 1

// In pictures colours are the dark theme's, whatever the window's.
ImU32 pictureColour(uint32_t colour, float alpha = 1.0f) {
  return IM_COL32((colour >> 16) & 255u, (colour >> 8) & 255u, colour & 255u, int(255.0f * alpha));
}

// Where a step of the ray ends: where the ray does, in its last step.
float shownEnd(const FrameSnapshot& frame, const RecordedRay& ray, uint32_t step) {
  const std::vector<StepRecord>& steps = ray.record.steps;
  const bool hits = ray.record.hit.kind == kHitTriangle || ray.record.hit.kind == kHitVoxel;
  if (step + 1 < steps.size()) return steps[step + 1].start;
  if (hits) return ray.record.hit.t;
  return steps[step].outcome == kStepOutside ? steps[step].start : steps[step].start + frame.grid->parameters.cellEdge;
}

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
    painter.box(cellBounds(grid, ray.record.steps[selected].cell), {.colour = IM_COL32_WHITE, .width = 1.8f, .hidden = HiddenParts::dashed, .halo = 1.0f});
}

void drawTriangles(const WindowModel& model, const OverlayPainter& painter, const StepFacts& facts) {
  size_t drawn = 0;
  for (const TestFacts& test : facts.tests) {
    const Triangle* triangle = worldTriangle(*model.frame, test.test.reference);
    if (!triangle || ++drawn > kMostTriangles) continue;
    const bool hit = test.test.verdict == kTestHit;
    painter.triangle(*triangle, {.colour = pictureColour(hit ? kColourTriangleHit : kColourTested, hit ? 1.0f : 0.7f), .width = hit ? 2.0f : 1.0f});
  }
  for (const RefusedFacts& refused : facts.refusedTests) {
    const Triangle* triangle = worldTriangle(*model.frame, refused.test.reference);
    if (!triangle || ++drawn > kMostTriangles) continue;
    painter.triangle(*triangle, {.colour = pictureColour(kColourSaturated, refused.wouldHit ? 1.0f : 0.6f), .width = refused.wouldHit ? 2.2f : 1.0f, .dashed = !refused.wouldHit});
  }
}

void drawSegments(const OverlayPainter& painter, const FrameSnapshot& frame, const RecordedRay& ray) {
  for (uint32_t step = 0; step < ray.record.steps.size(); ++step) {
    const StepOutcome outcome = stepOutcome(ray.record, step);
    const WorldLine line{rayPoint(ray.ray, ray.record.steps[step].start), rayPoint(ray.ray, shownEnd(frame, ray, step))};
    painter.line(line, {.colour = pictureColour(stepLook(outcome).colour), .width = 3.2f, .hidden = HiddenParts::dashed, .halo = 1.4f, .dashed = outcome == StepOutcome::revisit});
  }
}

// Rings where steps start, as far apart as they can be told apart; the selected one with its glyph.
void drawStepMarks(const OverlayPainter& painter, const RecordedRay& ray, uint32_t selected) {
  ImVec2 last(-1e6f, -1e6f);
  for (uint32_t step = 1; step < ray.record.steps.size(); ++step) {
    const std::optional<ImVec2> at = painter.place(rayPoint(ray.ray, ray.record.steps[step].start));
    if (!at || !painter.inPane(*at) || std::hypot(at->x - last.x, at->y - last.y) < unit(9)) continue;
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
    painter.list->AddQuadFilled(ImVec2(at->x, at->y - half), ImVec2(at->x + half, at->y), ImVec2(at->x, at->y + half), ImVec2(at->x - half, at->y), colour);
  };
  diamond(unit(9), IM_COL32(20, 23, 27, 230));
  diamond(unit(6.5f), pictureColour(hit.kind == kHitVoxel ? kColourVoxelHit : kColourTriangleHit));
}

// --- Callouts ---------------------------------------------------------------------------------------------------------------------

struct CalloutLine {
  std::string text;
  ImFont* font;
  ImU32 colour;
};

ImVec2 textSize(const CalloutLine& line) { return line.font->CalcTextSizeA(line.font->FontSize, FLT_MAX, 0.0f, line.text.c_str()); }

// A box with lines of text at the end of a leader from `at`, which goes `way` (about one box's size).
void drawCallout(const OverlayPainter& painter, ImVec2 at, ImVec2 way, std::span<const CalloutLine> lines) {
  ImVec2 size(0.0f, unit(8));
  for (const CalloutLine& line : lines) {
    const ImVec2 text = textSize(line);
    size = ImVec2(std::max(size.x, text.x + unit(18)), size.y + text.y + unit(3));
  }
  const PaneRect& pane = painter.pane;
  ImVec2 low(at.x + way.x - 0.5f * size.x, at.y + way.y - 0.5f * size.y);
  low.x = std::floor(std::clamp(low.x, pane.min.x + unit(8), std::max(pane.max.x - size.x - unit(8), pane.min.x + unit(8))));
  const float top = pane.min.y + unit(30);  // below the legend
  low.y = std::floor(std::clamp(low.y, top, std::max(pane.max.y - size.y - unit(8), top)));
  const ImVec2 high(low.x + size.x, low.y + size.y);
  const ImVec2 end(std::clamp(at.x, low.x, high.x), std::clamp(at.y, low.y, high.y));
  painter.list->AddLine(at, end, IM_COL32(0, 0, 0, 150), unit(3));
  painter.list->AddLine(at, end, IM_COL32(255, 255, 255, 220), unit(1));
  painter.list->AddRectFilled(low, high, IM_COL32(20, 23, 27, 232), unit(3));
  painter.list->AddRect(low, high, IM_COL32(70, 78, 88, 255), unit(3));
  float y = low.y + unit(5);
  for (const CalloutLine& line : lines) {
    painter.list->AddText(line.font, line.font->FontSize, ImVec2(low.x + unit(9), y), line.colour, line.text.c_str());
    y += textSize(line).y + unit(3);
  }
}

std::vector<CalloutLine> stepLines(const FrameSnapshot& frame, const RecordedRay& ray, const StepFacts& facts) {
  const StepLook& look = stepLook(facts.kind);
  std::vector<CalloutLine> lines{{printed("Step %u, ", facts.index) + std::string(look.word), windowFonts().sansBold, pictureColour(look.colour)}};
  const bool ends = facts.index + 1 == ray.record.steps.size() && (ray.record.hit.kind == kHitVoxel || ray.record.hit.kind == kHitTriangle);
  lines.push_back({printed("cell %d, %d, %d | t %.3f", facts.cell.x, facts.cell.y, facts.cell.z, ends ? ray.record.hit.t : facts.startT), windowFonts().mono, IM_COL32(217, 223, 229, 255)});
  const auto would = std::find_if(facts.refusedTests.begin(), facts.refusedTests.end(), [](const RefusedFacts& refused) { return refused.wouldHit; });
  if (would != facts.refusedTests.end())
    lines.push_back({"triangle " + grouped(would->name.triangle) + " was refused", windowFonts().sansSmall, pictureColour(kColourSaturated)});
  else if (facts.refused > 0)
    lines.push_back({printed("%u stored, %u refused", facts.stored, facts.refused), windowFonts().sansSmall, pictureColour(kColourSaturated)});
  else if (!facts.tests.empty())
    lines.push_back({printed("%zu tested", facts.tests.size()), windowFonts().sansSmall, IM_COL32(143, 154, 166, 255)});
  if (ends && facts.kind == StepOutcome::hit) lines.push_back({meshName(*frame.scene, nameTriangle(frame.scene->numbered, ray.record.hit.reference).mesh), windowFonts().sansSmall, IM_COL32(143, 154, 166, 255)});
  return lines;
}

std::vector<CalloutLine> originLines(const FrameSnapshot& frame, const RecordedRay& ray) {
  const uint32_t width = frame.request.settings->width;
  std::vector<CalloutLine> lines{{printed("Origin, pixel %u, %u", ray.pixel % width, ray.pixel / width), windowFonts().sansBold, IM_COL32(217, 223, 229, 255)}};
  if (!frame.gather || ray.pixel >= frame.gather->size() || (*frame.gather)[ray.pixel].reference == kBlank) return lines;
  const TriangleName name = nameTriangle(frame.scene->numbered, (*frame.gather)[ray.pixel].reference);
  lines.push_back({meshName(*frame.scene, name.mesh) + ", triangle " + grouped(name.triangle), windowFonts().sansSmall, IM_COL32(143, 154, 166, 255)});
  return lines;
}

// Callouts stand across the ray, above it the step's and below it the origin's, so that they do not cover it.
void drawCallouts(const OverlayPainter& painter, const FrameSnapshot& frame, const RecordedRay& ray, const StepFacts& facts) {
  if (painter.pane.max.x - painter.pane.min.x < unit(kLeastCallout)) return;
  const uint32_t last = static_cast<uint32_t>(ray.record.steps.size()) - 1;
  const std::optional<ImVec2> origin = painter.place(ray.ray.origin), end = painter.place(rayPoint(ray.ray, shownEnd(frame, ray, last)));
  ImVec2 along(1.0f, 0.0f);
  if (origin && end)
    if (const float length = std::hypot(end->x - origin->x, end->y - origin->y); length > 1.0f) along = ImVec2((end->x - origin->x) / length, (end->y - origin->y) / length);
  ImVec2 across(along.y, -along.x);
  if (across.y > 0.0f) across = ImVec2(-across.x, -across.y);
  const bool atEnd = facts.index == last && (ray.record.hit.kind == kHitVoxel || ray.record.hit.kind == kHitTriangle);
  const std::optional<ImVec2> step = painter.place(rayPoint(ray.ray, atEnd ? ray.record.hit.t : facts.startT));
  if (step && painter.inPane(*step)) drawCallout(painter, *step, ImVec2(across.x * unit(130), across.y * unit(80) - unit(16)), stepLines(frame, ray, facts));
  if (origin && painter.inPane(*origin) && frame.request.settings && facts.index > 0)
    drawCallout(painter, *origin, ImVec2(-across.x * unit(120) - along.x * unit(60), -across.y * unit(60) + unit(16)), originLines(frame, ray));
}

// What the colours mean: only the outcomes that this ray has.
void drawLegend(const OverlayPainter& painter, const RecordedRay& ray) {
  if (painter.pane.max.x - painter.pane.min.x < unit(kLeastCallout)) return;
  std::set<StepOutcome> outcomes;
  for (uint32_t step = 0; step < ray.record.steps.size(); ++step) outcomes.insert(stepOutcome(ray.record, step));
  ImFont* font = windowFonts().sansSmall;
  float width = unit(8);
  for (const StepOutcome outcome : outcomes) width += unit(30) + font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, stepLook(outcome).word.data()).x;
  const ImVec2 low(painter.pane.min.x + unit(10), painter.pane.min.y + unit(10)), high(low.x + width, low.y + unit(22));
  painter.list->AddRectFilled(low, high, IM_COL32(20, 23, 27, 215), unit(3));
  float x = low.x + unit(8);
  for (const StepOutcome outcome : outcomes) {
    const StepLook& look = stepLook(outcome);
    drawStepGlyph(painter.list, ImVec2(x + unit(6), low.y + unit(11)), unit(10), outcome);
    painter.list->AddText(font, font->FontSize, ImVec2(x + unit(16), low.y + unit(4)), IM_COL32(217, 223, 229, 255), look.word.data(), look.word.data() + look.word.size());
    x += unit(30) + font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, look.word.data()).x;
  }
}

}  // namespace

void drawRayOverlay(const WindowModel& model, const OverlayPainter& painter) {
  const Overlays& overlays = model.overlays;
  const ShownStep* shown = shownStepFacts(model);
  if (!shown) return;
  const FrameSnapshot& frame = *model.frame;
  const RecordedRay& ray = *shown->ray;
  if (overlays.visitedCells) drawVisitedCells(painter, frame, ray, shown->facts.index);
  if (overlays.testedTriangles) drawTriangles(model, painter, shown->facts);
  if (!overlays.raySegments) return;
  drawSegments(painter, frame, ray);
  drawStepMarks(painter, ray, shown->facts.index);
  drawEnds(painter, ray);
  drawCallouts(painter, frame, ray, shown->facts);
  drawLegend(painter, ray);
}

}  // namespace gridscope
