// See table_parts.h.
#include "app/ui/panels/table_parts.h"

#include <algorithm>
#include <cmath>

#include "app/ui/widgets/widgets.h"

namespace gridscope {

TableStyle::TableStyle() {
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(unit(6), unit(2)));
  ImGui::PushStyleColor(ImGuiCol_TableHeaderBg, uiColour(UiColour::panel));
  ImGui::PushStyleColor(ImGuiCol_TableRowBg, uiColour(UiColour::panel));
  ImVec4 other = uiColour(UiColour::head);
  other.w = 0.45f;
  ImGui::PushStyleColor(ImGuiCol_TableRowBgAlt, other);
  ImGui::PushStyleColor(ImGuiCol_Header, uiColour(UiColour::selectedRow));
  ImVec4 hovered = uiColour(UiColour::selectedRow);
  hovered.w = 0.6f;
  ImGui::PushStyleColor(ImGuiCol_HeaderHovered, hovered);
  ImGui::PushStyleColor(ImGuiCol_HeaderActive, uiColour(UiColour::selectedRow));
}

TableStyle::~TableStyle() {
  ImGui::PopStyleColor(6);
  ImGui::PopStyleVar();
}

float tableRowHeight() { return unit(20); }

void beginStrip() {
  ImGui::Dummy(ImVec2(unit(2), unit(22)));
  ImGui::SameLine(0.0f, unit(4));
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + unit(3));
}

void toTheRight(float width) {
  ImGui::SameLine();
  const float edge = ImGui::GetWindowContentRegionMax().x - width - unit(4);
  if (edge > ImGui::GetCursorPosX()) ImGui::SetCursorPosX(edge);
}

float smallButtonWidth(const char* label) {
  ImGui::PushFont(windowFonts().sansSmall);
  const float width = ImGui::CalcTextSize(label).x + unit(12);
  ImGui::PopFont();
  return width;
}

static bool paddedButton(const char* label, const char* id, float paddingY, bool enabled) {
  ImGui::PushID(id);
  ImGui::PushFont(windowFonts().sansSmall);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(unit(6), paddingY));
  ImGui::BeginDisabled(!enabled);
  const bool clicked = ImGui::Button(label);
  ImGui::EndDisabled();
  ImGui::PopStyleVar();
  ImGui::PopFont();
  ImGui::PopID();
  return clicked && enabled;
}

bool smallButton(const char* label, const char* id, const char* tooltip, bool enabled, const char* whyNot) {
  const bool clicked = paddedButton(label, id, unit(1), enabled);
  whyTooltip(enabled ? tooltip : whyNot);
  return clicked;
}

bool rowButton(const char* label, const char* id, const char* tooltip, bool enabled, const char* whyNot) {
  const bool clicked = paddedButton(label, id, 0.0f, enabled);
  whyTooltip(enabled ? tooltip : whyNot);
  return clicked;
}

bool exportButton(const char* tooltip, bool enabled, const char* whyNot) {
  toTheRight(smallButtonWidth("Export CSV"));
  return smallButton("Export CSV", "csv", (std::string(tooltip) + ", in the folder where the program was started").c_str(), enabled,
                     whyNot);
}

void tableTitle(const char* title, bool toTheRight) {
  ImGui::PushFont(windowFonts().sansSmall);
  ImGui::PushStyleColor(ImGuiCol_Text, uiColour(UiColour::dim));
  if (!toTheRight) {
    ImGui::TableHeader(title);
  } else {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const bool sorted = (ImGui::TableGetColumnFlags() & ImGuiTableColumnFlags_IsSorted) != 0;
    ImGui::PushID(title);
    ImGui::TableHeader("");
    ImGui::PopID();
    // The arrow of a sorted column stands at the right edge, 0.65 of the font wide.
    const float arrow = sorted ? ImGui::GetFontSize() * 0.65f + unit(4) : 0.0f;
    const float x = start.x + std::max(0.0f, width - ImGui::CalcTextSize(title).x - arrow);
    ImGui::GetWindowDrawList()->AddText(ImVec2(x, start.y), ImGui::GetColorU32(ImGuiCol_Text), title);
  }
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

bool rowSelectable(bool selected) {
  const ImVec2 place = ImGui::GetCursorPos();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
  const bool clicked = ImGui::Selectable("##row", selected, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap,
                                         ImVec2(0.0f, tableRowHeight() - 2.0f * unit(2)));
  ImGui::PopStyleVar();
  ImGui::SetCursorPos(place);
  return clicked;
}

void smallText(std::string_view text, const ImVec4& colour) {
  ImGui::PushFont(windowFonts().sansSmall);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void leftNumber(std::string_view text, const ImVec4& colour) {
  ImGui::PushFont(windowFonts().mono);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void rightNumber(std::string_view text, const ImVec4& colour) {
  ImGui::PushFont(windowFonts().mono);
  const float width = ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
  ImGui::PopFont();
  const float free = ImGui::GetContentRegionAvail().x - width;
  if (free > 0.0f) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + free);
  leftNumber(text, colour);
}

}  // namespace gridscope
