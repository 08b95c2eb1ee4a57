// The frame of a plot: title, axes with ticks, and the way from values to pixels.
#pragma once

#include <imgui.h>

#include <string>

#include "app/frame/plot_scale.h"

namespace gridscope {

struct PlotLook {
  std::string title;   // at the top left; empty: the place is left to the caller
  std::string note;    // at the top right: units
  std::string xTitle;  // below the ticks; empty: none
  PlotScale x, y;
  std::string yUnit;         // behind each y label: " %"
  float legendWidth = 0.0f;  // left free at the right, at UI scale 1
  float footHeight = 0.0f;   // left free below the axis, at UI scale 1
  bool gridX = false;        // lines at the x ticks too
  bool ticksX = true;
};

class PlotFrame {
 public:
  // Draws title and axes into the rectangle from `low` to `high`, screen pixels. Nothing but the title where it is too small.
  PlotFrame(const PlotLook& look, const ImVec2& low, const ImVec2& high);

  bool drawn() const { return high_.x - low_.x > 20.0f && high_.y - low_.y > 20.0f; }
  float x(double value) const;
  float y(double value) const;
  const ImVec2& low() const { return low_; }  // of the plot's inside
  const ImVec2& high() const { return high_; }
  bool hovered() const;   // the mouse is inside, and over this window
  double mouseX() const;  // value under it

 private:
  void drawYTicks(const PlotLook& look) const;
  void drawXTicks(const PlotLook& look) const;

  PlotScale scaleX_, scaleY_;
  ImVec2 low_, high_;
};

// Text at a screen place, of the small font or the one for numbers; its width.
float plotText(const ImVec2& place, const std::string& text, const ImVec4& colour, bool number);
float plotTextWidth(const std::string& text, bool number);

// A vertical dashed line.
void dashedLine(float x, float top, float bottom, ImU32 colour);

}  // namespace gridscope
