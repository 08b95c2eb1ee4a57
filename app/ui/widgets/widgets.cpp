// See widgets.h.
#include "app/ui/widgets/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace gridscope {

namespace {

// Where values stand in rows of facts, pixels from the left edge of the panel's content.
constexpr float kValueColumn = 124.0f;

float keyCapWidth(const char* key) {
  ImFont* font = windowFonts().mono;
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, key).x + unit(6);
}

void factLabel(const char* label) {
  textDim(label);
  ImGui::SameLine(unit(kValueColumn) + ImGui::GetStyle().WindowPadding.x);
}

// The word that exports the table below a section.
void drawCsvWord(ImVec2 low, ImVec2 size, bool& clicked) {
  ImGui::SameLine(0.0f, 0.0f);
  clicked = ImGui::InvisibleButton("csv", size);
  const bool hovered = ImGui::IsItemHovered();
  whyTooltip("Writes this table as a CSV file, in the folder where the program was started");
  ImFont* font = windowFonts().sansSmall;
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {low.x + unit(8), low.y + 0.5f * (size.y - font->FontSize)},
                                      packed(uiColour(hovered ? UiColour::text : UiColour::link)), "CSV");
}

// `csv`: null: no word at the right.
bool drawSection(const char* title, std::string_view right, bool openAtFirst, bool* csv) {
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  if (window->SkipItems) return false;
  const ImGuiID id = window->GetID(title);
  bool* open = window->StateStorage.GetBoolRef(id, openAtFirst);
  const float height = unit(26);
  const float left = window->WorkRect.Min.x - ImGui::GetStyle().WindowPadding.x,
              width = window->WorkRect.GetWidth() + 2.0f * ImGui::GetStyle().WindowPadding.x;
  const ImVec2 low{left, ImGui::GetCursorScreenPos().y}, high{left + width, low.y + height};
  ImDrawList& list = *window->DrawList;
  list.AddRectFilled(low, high, packed(uiColour(UiColour::head)));
  list.AddLine(low, {high.x, low.y}, packed(uiColour(UiColour::line)));
  ImGui::SetCursorScreenPos(low);
  ImGui::PushID(title);
  const float csvWidth = csv ? unit(40) : 0.0f;
  if (ImGui::InvisibleButton("section", {width - csvWidth, height})) *open = !*open;
  if (csv) drawCsvWord({high.x - csvWidth, low.y}, {csvWidth, height}, *csv);
  ImGui::PopID();
  const float middle = std::floor(0.5f * (low.y + high.y)), x = low.x + unit(13), arm = unit(3.5f);
  const ImU32 dim = packed(uiColour(UiColour::dim));
  if (*open)
    list.AddTriangleFilled({x - arm, middle - arm * 0.6f}, {x + arm, middle - arm * 0.6f}, {x, middle + arm * 0.8f}, dim);
  else
    list.AddTriangleFilled({x - arm * 0.6f, middle - arm}, {x + arm * 0.8f, middle}, {x - arm * 0.6f, middle + arm}, dim);
  ImFont* bold = windowFonts().sansBold;
  list.AddText(bold, bold->FontSize, {low.x + unit(25), middle - 0.5f * bold->FontSize}, packed(uiColour(UiColour::text)), title,
               ImGui::FindRenderedTextEnd(title));
  if (!right.empty()) {
    ImFont* mono = windowFonts().mono;
    const char *begin = right.data(), *end = begin + right.size();
    const float textWidth = mono->CalcTextSizeA(mono->FontSize, FLT_MAX, 0.0f, begin, end).x;
    list.AddText(mono, mono->FontSize, {high.x - textWidth - (csv ? csvWidth : unit(10)), middle - 0.5f * mono->FontSize}, dim, begin, end);
  }
  return *open;
}

}  // namespace

float drawKeyCap(ImVec2 low, const char* key, bool enabled) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* font = windowFonts().mono;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, key);
  const ImVec2 high{low.x + size.x + unit(6), low.y + size.y + unit(1)};
  list.AddRectFilled(low, high, packed(uiColour(UiColour::panel)), unit(2));
  list.AddText(font, font->FontSize, {low.x + unit(3), low.y}, packed(uiColour(enabled ? UiColour::dim : UiColour::disabled)), key);
  return high.x - low.x;
}

void textDim(std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, uiColour(UiColour::dim));
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
}

void textMono(std::string_view text) {
  ImGui::PushFont(windowFonts().mono);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopFont();
}

void factRow(const char* label, std::string_view value, const char* unitName) {
  factLabel(label);
  textMono(value);
  if (*unitName) {
    ImGui::SameLine(0.0f, unit(4));
    textDim(unitName);
  }
}

bool factLink(const char* label, std::string_view value) {
  factLabel(label);
  return link(value, label);
}

bool link(std::string_view text, const char* id) {
  const std::string words(text);
  ImGui::PushID(id);
  ImGui::PushFont(windowFonts().mono);
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("link", {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
  const bool hovered = ImGui::IsItemHovered();
  const ImU32 colour = packed(uiColour(UiColour::link));
  ImGui::GetWindowDrawList()->AddText({place.x, place.y + ImGui::GetCurrentWindow()->DC.CurrLineTextBaseOffset}, colour, words.c_str());
  if (hovered) {
    ImGui::GetWindowDrawList()->AddLine({place.x, place.y + size.y}, {place.x + size.x, place.y + size.y}, colour);
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  ImGui::PopFont();
  ImGui::PopID();
  return clicked;
}

bool keyButton(const char* label, const char* key, bool enabled, const char* whyNot) {
  const char* shownEnd = ImGui::FindRenderedTextEnd(label);
  const ImVec2 words = ImGui::CalcTextSize(label, shownEnd);
  const float cap = *key ? keyCapWidth(key) + unit(8) : 0.0f;
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float height = unit(24);
  ImGui::PushID(label);
  if (!enabled) ImGui::BeginDisabled();
  const bool clicked = ImGui::Button("##key", {words.x + cap + unit(16), height});
  if (!enabled) ImGui::EndDisabled();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText({place.x + unit(8), place.y + 0.5f * (height - words.y)}, packed(uiColour(enabled ? UiColour::text : UiColour::disabled)),
               label, shownEnd);
  if (*key) drawKeyCap({place.x + words.x + unit(16), place.y + 0.5f * (height - windowFonts().mono->FontSize) - 1.0f}, key, enabled);
  ImGui::PopID();
  if (!enabled) whyTooltip(whyNot);
  return clicked && enabled;
}

void whyTooltip(const char* text) {
  if (!*text || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(unit(360));
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void swatch(uint32_t darkColour, bool hatched) {
  const float side = unit(10), lineHeight = ImGui::GetTextLineHeight();
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const ImVec2 low{place.x, place.y + std::floor(0.5f * (lineHeight - side)) + ImGui::GetCurrentWindow()->DC.CurrLineTextBaseOffset};
  const ImVec2 high{low.x + side, low.y + side};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, packed(meaningColour(darkColour)), unit(2));
  if (hatched) {
    list.PushClipRect(low, high, true);
    for (float x = -side; x < side; x += unit(4))
      list.AddLine({low.x + x, high.y}, {low.x + x + side, low.y}, packed(uiColour(UiColour::panel)), unit(1));
    list.PopClipRect();
  }
  ImGui::Dummy({side, lineHeight});
  ImGui::SameLine(0.0f, unit(5));
}

bool sectionHeader(const char* title, std::string_view right, bool openAtFirst) { return drawSection(title, right, openAtFirst, nullptr); }

bool tableSection(const char* title, std::string_view right, size_t rows, bool& csv) {
  return drawSection(title, right, true, rows > 0 ? &csv : nullptr);
}

void emptyState(const char* sentence) {
  ImGui::Dummy({1.0f, unit(6)});
  ImGui::PushStyleColor(ImGuiCol_Text, uiColour(UiColour::dim));
  ImGui::TextWrapped("%s", sentence);
  ImGui::PopStyleColor();
}

void hatch(ImDrawList* list, const ImVec2& low, const ImVec2& high, ImU32 colour) {
  if (high.x <= low.x || high.y <= low.y) return;
  list->PushClipRect(low, high, true);
  const float step = unit(5), height = high.y - low.y;
  // Lines start at multiples of the step on the screen, so that neighbouring rectangles share one pattern.
  const float first = step * std::floor((low.x + low.y) / step);
  for (float sum = first; sum < high.x + high.y + step; sum += step)
    list->AddLine(ImVec2(sum - low.y, low.y), ImVec2(sum - low.y - height, high.y), colour, unit(1.5f));
  list->PopClipRect();
}

}  // namespace gridscope
