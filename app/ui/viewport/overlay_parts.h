// What overlays are drawn with: world lines over a pane's picture, cut at the clip box, dashed or left out where surfaces hide them.
#pragma once

#include <imgui.h>

#include <span>

#include "app/frame/projection.h"
#include "app/ui/widgets/pane_rect.h"

namespace gridscope {

enum class HiddenParts { leftOut, dashed, drawn };

struct LineStyle {
  ImU32 colour = 0;
  float width = 1.0f;  // pixels at UI scale 1
  HiddenParts hidden = HiddenParts::leftOut;
  float halo = 0.0f;  // dark, on both sides, pixels at UI scale 1; 0: none
  bool dashed = false;
};

struct OverlayPainter {
  ImDrawList* list = nullptr;
  const PaneRect& pane;
  std::span<const GatherPixel> gather;  // of the frame; empty: nothing is hidden
  const Bounds* clip = nullptr;         // null: nothing is cut
  float bias = 0.0f;                    // how far behind a surface still counts as visible, world units

  void line(const WorldLine& line, const LineStyle& style) const;
  void box(const Bounds& bounds, const LineStyle& style) const;
  void triangle(const Triangle& triangle, const LineStyle& style) const;
  std::optional<ImVec2> place(const vec3& world) const;  // on the screen; nothing where it is cut or behind the eye
  bool inPane(ImVec2 place) const;
};

// In pictures colours are the dark theme's, whatever the window's: 0xRRGGBB.
ImU32 pictureColour(uint32_t colour, float alpha = 1.0f);
ImU32 withAlpha(ImU32 colour, float alpha);
void dashedLine(ImDrawList* list, ImVec2 a, ImVec2 b, ImU32 colour, float width);

}  // namespace gridscope
