// See overlay_parts.h.
#include "app/ui/viewport/overlay_parts.h"

#include <algorithm>
#include <cmath>

#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

constexpr float kDash = 4.0f, kGap = 3.5f;  // pixels at UI scale 1
constexpr int kMostDashes = 400;
constexpr float kHiddenAlpha = 0.75f, kHiddenShare = 0.65f;  // of a line's opacity and width where surfaces hide it

void strokePiece(ImDrawList* list, ImVec2 a, ImVec2 b, const LineStyle& style, bool hidden) {
  const bool dashed = style.dashed || (hidden && style.hidden == HiddenParts::dashed);
  const ImU32 colour = hidden && style.hidden == HiddenParts::dashed ? withAlpha(style.colour, kHiddenAlpha) : style.colour;
  const float width = unit(hidden ? std::min(style.width, std::max(1.4f, kHiddenShare * style.width)) : style.width);
  if (dashed) return dashedLine(list, a, b, colour, width);
  list->AddLine(a, b, colour, width);
}

}  // namespace

ImU32 pictureColour(uint32_t colour, float alpha) {
  return IM_COL32((colour >> 16) & 255u, (colour >> 8) & 255u, colour & 255u, int(255.0f * alpha));
}

ImU32 withAlpha(ImU32 colour, float alpha) {
  const auto old = float(colour >> IM_COL32_A_SHIFT & 255u);
  return (colour & ~IM_COL32_A_MASK) | (ImU32(old * std::clamp(alpha, 0.0f, 1.0f)) << IM_COL32_A_SHIFT);
}

void dashedLine(ImDrawList* list, ImVec2 a, ImVec2 b, ImU32 colour, float width) {
  const float length = std::hypot(b.x - a.x, b.y - a.y);
  if (length < 1e-3f) return;
  const float period = std::max(unit(kDash + kGap), length / float(kMostDashes));
  const float dash = period * kDash / (kDash + kGap);
  const ImVec2 way((b.x - a.x) / length, (b.y - a.y) / length);
  for (float at = 0.0f; at < length; at += period) {
    const float end = std::min(at + dash, length);
    list->AddLine(ImVec2(a.x + way.x * at, a.y + way.y * at), ImVec2(a.x + way.x * end, a.y + way.y * end), colour, width);
  }
}

void OverlayPainter::line(const WorldLine& wanted, const LineStyle& style) const {
  const std::optional<WorldLine> kept = clip ? clipToBounds(*clip, wanted) : std::optional<WorldLine>(wanted);
  if (!kept) return;
  const std::vector<ProjectedLine> pieces =
      projectLine(pane.camera, style.hidden == HiddenParts::drawn ? std::span<const GatherPixel>() : gather, *kept, bias);
  if (style.halo > 0.0f)
    for (const ProjectedLine& piece : pieces)
      if (!piece.hidden)
        list->AddLine(pane.toScreen(piece.a.pixel), pane.toScreen(piece.b.pixel), IM_COL32(0, 0, 0, 150),
                      unit(style.width + 2.0f * style.halo));
  for (const ProjectedLine& piece : pieces)
    if (!piece.hidden || style.hidden != HiddenParts::leftOut)
      strokePiece(list, pane.toScreen(piece.a.pixel), pane.toScreen(piece.b.pixel), style, piece.hidden);
}

void OverlayPainter::box(const Bounds& bounds, const LineStyle& style) const {
  for (const WorldLine& edge : boxEdges(bounds)) line(edge, style);
}

void OverlayPainter::triangle(const Triangle& triangle, const LineStyle& style) const {
  line({triangle.a, triangle.b}, style);
  line({triangle.b, triangle.c}, style);
  line({triangle.c, triangle.a}, style);
}

std::optional<ImVec2> OverlayPainter::place(const vec3& world) const {
  if (clip && (glm::any(glm::lessThan(world, clip->low)) || glm::any(glm::greaterThan(world, clip->high)))) return std::nullopt;
  const std::optional<ProjectedPoint> point = projectPoint(pane.camera, world);
  if (!point) return std::nullopt;
  return pane.toScreen(point->pixel);
}

bool OverlayPainter::inPane(ImVec2 at) const {
  return at.x >= pane.min.x && at.y >= pane.min.y && at.x <= pane.max.x && at.y <= pane.max.y;
}

}  // namespace gridscope
