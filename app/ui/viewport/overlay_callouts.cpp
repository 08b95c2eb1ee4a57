// Callouts over the viewport (overlay.h): of the selected ray, one at its step and one at its origin; of a selected cell, triangle or instance.
#include <algorithm>
#include <cmath>
#include <span>

#include "app/base/text.h"
#include "app/frame/callout_place.h"
#include "app/ui/viewport/overlay.h"
#include "app/ui/widgets/step_parts.h"
#include "app/ui/widgets/widgets.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

constexpr float kAxes = 92.0f, kFoot = 44.0f;  // corners that callouts leave free: the axes; legend and read-out, pixels at UI scale 1
constexpr int kRayPoints = 80;                 // of the ray on the screen, to keep callouts off it

struct CalloutLine {
  std::string text;
  ImFont* font;
  ImU32 colour;
};

ImVec2 textSize(const CalloutLine& line) { return line.font->CalcTextSizeA(line.font->FontSize, FLT_MAX, 0.0f, line.text.c_str()); }

ImVec2 calloutSize(std::span<const CalloutLine> lines) {
  ImVec2 size(0.0f, unit(8));
  for (const CalloutLine& line : lines) {
    const ImVec2 text = textSize(line);
    size = ImVec2(std::max(size.x, text.x + unit(18)), size.y + text.y + unit(3));
  }
  return size;
}

// A box with lines of text, and a leader to it from `at`.
void drawCallout(const OverlayPainter& painter, ImVec2 at, ImVec2 low, std::span<const CalloutLine> lines) {
  const ImVec2 size = calloutSize(lines), high(low.x + size.x, low.y + size.y);
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
  std::vector<CalloutLine> lines{
      {printed("Step %u, ", facts.index) + std::string(look.word), windowFonts().sansBold, pictureColour(look.colour)}};
  const bool ends = facts.index + 1 == ray.record.steps.size() && (ray.record.hit.kind == kHitVoxel || ray.record.hit.kind == kHitTriangle);
  lines.push_back({printed("cell %d, %d, %d | t %.3f", facts.cell.x, facts.cell.y, facts.cell.z, ends ? ray.record.hit.t : facts.startT),
                   windowFonts().mono, IM_COL32(217, 223, 229, 255)});
  const auto would =
      std::find_if(facts.refusedTests.begin(), facts.refusedTests.end(), [](const RefusedFacts& refused) { return refused.wouldHit; });
  if (would != facts.refusedTests.end())
    lines.push_back(
        {"triangle " + grouped(would->name.triangle) + " was refused", windowFonts().sansSmall, pictureColour(kColourSaturated)});
  else if (facts.refused > 0)
    lines.push_back(
        {printed("%u stored, %u refused", facts.stored, facts.refused), windowFonts().sansSmall, pictureColour(kColourSaturated)});
  else if (!facts.tests.empty())
    lines.push_back({printed("%zu tested", facts.tests.size()), windowFonts().sansSmall, IM_COL32(143, 154, 166, 255)});
  if (ends && facts.kind == StepOutcome::hit)
    lines.push_back({meshName(*frame.scene, nameTriangle(frame.scene->numbered, ray.record.hit.reference).mesh), windowFonts().sansSmall,
                     IM_COL32(143, 154, 166, 255)});
  return lines;
}

std::vector<CalloutLine> originLines(const FrameSnapshot& frame, const RecordedRay& ray) {
  const uint32_t width = frame.request.settings->width;
  std::vector<CalloutLine> lines{
      {printed("Origin, pixel %u, %u", ray.pixel % width, ray.pixel / width), windowFonts().sansBold, IM_COL32(217, 223, 229, 255)}};
  if (ray.surface == kNoReference) return lines;
  const TriangleName name = nameTriangle(frame.scene->numbered, ray.surface);
  lines.push_back(
      {meshName(*frame.scene, name.mesh) + ", triangle " + grouped(name.triangle), windowFonts().sansSmall, IM_COL32(143, 154, 166, 255)});
  return lines;
}

vec2 vectorOf(ImVec2 place) { return {place.x, place.y}; }

// The ray on the screen, evenly in world units.
std::vector<vec2> rayPoints(const OverlayPainter& painter, const Ray& ray, float end) {
  std::vector<vec2> points;
  for (int i = 0; i <= kRayPoints; ++i)
    if (const auto at = painter.place(rayPoint(ray, end * float(i) / float(kRayPoints)))) points.push_back(vectorOf(*at));
  return points;
}

// What callouts leave free: the axes, the foot with legend and read-out, and the lens.
std::vector<Area> occupiedAreas(const WindowModel& model, const PaneRect& pane) {
  std::vector<Area> areas{{{pane.max.x - unit(kAxes), pane.min.y}, {pane.max.x, pane.min.y + unit(kAxes)}},
                          {{pane.min.x, pane.max.y - unit(kFoot)}, {pane.max.x, pane.max.y}}};
  if (pane.legend.x > 0.0f)
    areas.push_back({{pane.max.x - pane.legend.x - unit(10), pane.max.y - pane.legend.y - unit(10)}, {pane.max.x, pane.max.y}});
  if (const auto lens = lensPlace(model, pane)) areas.push_back({vectorOf(lens->min), vectorOf(lens->max)});
  return areas;
}

}  // namespace

void drawSelectionCallout(const WindowModel& model, const OverlayPainter& painter, const vec3& at, const std::string& name,
                          const std::string& note, bool marked) {
  const PaneRect& pane = painter.pane;
  const std::optional<ImVec2> place = painter.place(at);
  if (pane.max.x - pane.min.x < unit(kLeastCallout) || !place || !painter.inPane(*place)) return;
  std::vector<CalloutLine> lines{{name, windowFonts().sansBold, IM_COL32(217, 223, 229, 255)}};
  if (!note.empty()) lines.push_back({note, windowFonts().mono, marked ? pictureColour(kColourSaturated) : IM_COL32(143, 154, 166, 255)});
  const vec2 low = placeCallout({vectorOf(pane.min), vectorOf(pane.max)}, vectorOf(*place), vectorOf(calloutSize(lines)), {},
                                occupiedAreas(model, pane), unit(1));
  drawCallout(painter, *place, ImVec2(low.x, low.y), lines);
}

void drawCallouts(const WindowModel& model, const OverlayPainter& painter, const ShownStep& shown) {
  const FrameSnapshot& frame = *model.frame;
  const RecordedRay& ray = *shown.ray;
  const StepFacts& facts = shown.facts;
  const PaneRect& pane = painter.pane;
  const Area room{vectorOf(pane.min), vectorOf(pane.max)};
  const uint32_t last = static_cast<uint32_t>(ray.record.steps.size()) - 1;
  const std::vector<vec2> points = rayPoints(painter, ray.ray, shownEnd(frame, ray, last));
  std::vector<Area> areas = occupiedAreas(model, pane);
  const auto callout = [&](ImVec2 at, const std::vector<CalloutLine>& lines) {
    const vec2 size = vectorOf(calloutSize(lines)), low = placeCallout(room, vectorOf(at), size, points, areas, unit(1));
    drawCallout(painter, at, ImVec2(low.x, low.y), lines);
    areas.push_back({low, low + size});
  };
  const bool atEnd = facts.index == last && (ray.record.hit.kind == kHitVoxel || ray.record.hit.kind == kHitTriangle);
  const std::optional<ImVec2> step = painter.place(rayPoint(ray.ray, atEnd ? ray.record.hit.t : facts.startT)),
                              origin = painter.place(ray.ray.origin);
  if (step && painter.inPane(*step)) callout(*step, stepLines(frame, ray, facts));
  if (origin && painter.inPane(*origin) && frame.request.settings && facts.index > 0) callout(*origin, originLines(frame, ray));
}

}  // namespace gridscope
