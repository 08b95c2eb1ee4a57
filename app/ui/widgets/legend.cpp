// See legend.h.
#include "app/ui/widgets/legend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/frame/camera_moves.h"
#include "app/ui/widgets/widgets.h"
#include "views/legend.h"

namespace gridscope {

namespace {

constexpr ImU32 kBack = IM_COL32(20, 23, 27, 225), kText = IM_COL32(217, 223, 229, 255), kDim = IM_COL32(143, 154, 166, 255);

ImU32 colourOf(const vec3& colour) { return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, 1.0f}); }

ImVec2 textSize(ImFont* font, std::string_view text) {
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.data(), text.data() + text.size());
}

void putText(ImFont* font, ImVec2 place, ImU32 colour, std::string_view text) {
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, place, colour, text.data(), text.data() + text.size());
}

void drawBar(ImVec2 low, ImVec2 high, uint32_t map) {
  constexpr int kParts = 32;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < kParts; ++i) {
    const float a = float(i) / kParts, b = float(i + 1) / kParts, width = high.x - low.x;
    const ImU32 left = colourOf(colourMap(map, a)), right = colourOf(colourMap(map, b));
    list.AddRectFilledMultiColor({low.x + a * width, low.y}, {low.x + b * width, high.y}, left, right, right, left);
  }
}

void drawSwatch(ImVec2 low, float side, const Meaning& meaning) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = colourOf(unpackColour(meaning.colour));
  const ImVec2 high{low.x + side, low.y + side}, middle{low.x + 0.5f * side, low.y + 0.5f * side};
  switch (meaning.swatch) {
    case Swatch::square: list.AddRectFilled(low, high, colour, unit(2)); break;
    case Swatch::diamond: list.AddQuadFilled({middle.x, low.y}, {high.x, middle.y}, {middle.x, high.y}, {low.x, middle.y}, colour); break;
    case Swatch::ring: list.AddCircle(middle, 0.4f * side, colour, 0, unit(1.6f)); break;
    case Swatch::dot: list.AddCircleFilled(middle, 0.3f * side, colour); break;
    case Swatch::line: list.AddLine({low.x, middle.y}, {high.x, middle.y}, colour, unit(2)); break;
    case Swatch::hatch:
      list.AddRectFilled(low, high, colour, unit(2));
      list.PushClipRect(low, high, true);
      for (float x = -side; x < side; x += unit(4)) list.AddLine({low.x + x, high.y}, {low.x + x + side, low.y}, kBack, unit(1));
      list.PopClipRect();
      break;
  }
}

float meaningsWidth(const std::vector<Meaning>& meanings) {
  float width = 0.0f;
  for (const Meaning& meaning : meanings) width += unit(16) + textSize(windowFonts().sansSmall, meaning.words).x + unit(10);
  return width;
}

void drawMeanings(const std::vector<Meaning>& meanings, ImVec2 place, ImU32 colour) {
  ImFont* font = windowFonts().sansSmall;
  for (const Meaning& meaning : meanings) {
    drawSwatch({place.x, place.y + unit(3)}, unit(10), meaning);
    putText(font, {place.x + unit(15), place.y}, colour, meaning.words);
    place.x += unit(16) + textSize(font, meaning.words).x + unit(10);
  }
}

void drawTicks(ImVec2 low, float width, ValueRange range) {
  ImFont* font = windowFonts().mono;
  const std::vector<float> ticks = tickValues(range[0], range[1], 5);
  const float step = ticks.size() > 1 ? ticks[1] - ticks[0] : range[1] - range[0];
  for (size_t i = 0; i < ticks.size(); ++i) {
    const std::string text = tickText(ticks[i], step);
    const float share = (ticks[i] - range[0]) / std::max(range[1] - range[0], 1e-30f), textWidth = textSize(font, text).x;
    const float x = std::clamp(low.x + share * width - 0.5f * textWidth, low.x, low.x + width - textWidth);
    putText(font, {x, low.y}, kText, text);
  }
}

}  // namespace

ImVec2 legendBoxSize(const View& view) {
  const bool bar = view.range != ViewRange::none;
  const std::vector<Meaning> meanings = viewMeanings(view);
  const float title = textSize(windowFonts().sansSmall, view.title).x;
  return {std::max({bar ? unit(270) : 0.0f, title, meaningsWidth(meanings)}) + unit(20),
          unit(28) + (bar ? unit(32) : 0.0f) + (meanings.empty() ? 0.0f : unit(20))};
}

void drawLegendBox(const WindowModel& model, const View& view, ValueRange range, ImVec2 corner) {
  const bool bar = view.range != ViewRange::none;
  const std::vector<Meaning> meanings = viewMeanings(view);
  const ImVec2 size = legendBoxSize(view), low{corner.x - size.x, corner.y - size.y};
  const float width = size.x;
  ImGui::GetWindowDrawList()->AddRectFilled(low, corner, kBack, unit(3));
  float y = low.y + unit(8);
  const float x = low.x + unit(10);
  if (bar) {
    drawBar({x, y}, {x + width - unit(20), y + unit(10)}, model.colourMap);
    drawTicks({x, y + unit(13)}, width - unit(20), range);
    y += unit(32);
  }
  if (!meanings.empty()) {
    drawMeanings(meanings, {x, y}, kText);
    y += unit(20);
  }
  putText(windowFonts().sansSmall, {x, y}, kDim, view.title);
}

void drawLegendLine(const WindowModel& model, const View& view, ValueRange range, ImVec2 right, float left) {
  if (view.range == ViewRange::none) {
    // As many as there is room for, the first ones.
    std::vector<Meaning> meanings = viewMeanings(view);
    while (!meanings.empty() && right.x - meaningsWidth(meanings) <= left) meanings.pop_back();
    drawMeanings(meanings, {right.x - meaningsWidth(meanings), right.y}, packed(uiColour(UiColour::text)));
    return;
  }
  ImFont* font = windowFonts().mono;
  const float step = range[1] - range[0] > 8.0f ? 1.0f : 0.01f;
  const std::string low = tickText(range[0], step), high = tickText(range[1], step) + " " + std::string(view.unit);
  const float highWidth = textSize(font, high).x, bar = unit(110), lowWidth = textSize(font, low).x;
  const float x = right.x - highWidth - bar - lowWidth - unit(12);
  if (x <= left) return;
  const ImU32 dim = packed(uiColour(UiColour::dim));
  putText(font, {x, right.y}, dim, low);
  drawBar({x + lowWidth + unit(6), right.y + unit(3)}, {x + lowWidth + unit(6) + bar, right.y + unit(13)}, model.colourMap);
  putText(font, {right.x - highWidth, right.y}, dim, high);
}

void drawGizmo(WindowModel& model, ImVec2 centre, float radius) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(centre, radius, IM_COL32(20, 23, 27, 150));
  const CameraPose& pose = model.camera.pose;
  const vec3 forward = glm::normalize(pose.target - pose.eye), right = glm::normalize(glm::cross(forward, pose.up)),
             up = glm::cross(right, forward);
  struct Arm {
    int axis;
    bool positive;
    float depth;
    ImVec2 end;
  };
  std::array<Arm, 6> arms;
  for (int i = 0; i < 6; ++i) {
    vec3 direction(0.0f);
    direction[i / 2] = i % 2 == 0 ? 1.0f : -1.0f;
    const float length = radius - unit(8);
    arms[size_t(i)] = {i / 2,
                       i % 2 == 0,
                       glm::dot(direction, forward),
                       {centre.x + glm::dot(direction, right) * length, centre.y - glm::dot(direction, up) * length}};
  }
  std::ranges::sort(arms, [](const Arm& a, const Arm& b) { return a.depth > b.depth; });
  const ImU32 colours[] = {IM_COL32(224, 122, 95, 255), IM_COL32(129, 178, 80, 255), IM_COL32(96, 148, 224, 255)};
  for (const Arm& arm : arms) {
    const float half = unit(arm.positive ? 8 : 5);
    if (arm.positive) {
      list.AddLine(centre, arm.end, colours[arm.axis], unit(2));
      list.AddCircleFilled(arm.end, half, colours[arm.axis]);
      const char letter[] = {"XYZ"[arm.axis], 0};
      ImFont* font = windowFonts().sansBold;
      const ImVec2 size = font->CalcTextSizeA(font->FontSize * 0.85f, FLT_MAX, 0.0f, letter);
      list.AddText(font, font->FontSize * 0.85f, {arm.end.x - 0.5f * size.x, arm.end.y - 0.5f * size.y}, IM_COL32(20, 23, 27, 255), letter);
    } else {
      list.AddCircleFilled(arm.end, half, IM_COL32(20, 23, 27, 200));
      list.AddCircle(arm.end, half, colours[arm.axis], 0, unit(1.5f));
    }
    ImGui::SetCursorScreenPos({arm.end.x - half, arm.end.y - half});
    ImGui::PushID(2 * arm.axis + (arm.positive ? 1 : 0));
    if (ImGui::InvisibleButton("axis", {2.0f * half, 2.0f * half})) lookAlongOrBack(model.camera, arm.axis, arm.positive);
    ImGui::SetItemAllowOverlap();
    whyTooltip(
        (std::string("Looks from ") + (arm.positive ? "+" : "-") + "xyz"[arm.axis] + "; from the other side when it does already").c_str());
    ImGui::PopID();
  }
}

}  // namespace gridscope
