// The small things that panels are made of, so that they look alike: colours by meaning in the present theme, links, rows of facts,
// buttons that print their key, disabled controls that say why. Sizes are pixels at UI scale 1.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "app/model/window_model.h"

namespace gridscope {

// Fonts that the window loads; set before the first frame.
struct WindowFonts {
  ImFont* sans = nullptr;       // 13 px
  ImFont* sansSmall = nullptr;  // 12 px: tables and the status line
  ImFont* sansBold = nullptr;   // titles
  ImFont* sansLarge = nullptr;  // 15 px bold: the selection's name
  ImFont* mono = nullptr;       // 12 px: every number
};
WindowFonts& windowFonts();

// The window's colours in the present theme (theme.cpp).
enum class UiColour { window, panel, head, control, line, text, dim, disabled, accent, selectedRow, link };
ImVec4 uiColour(UiColour colour);
// A colour with a fixed meaning, 0xRRGGBB of the dark theme (kColour... of palette.h), as the present theme shows it.
ImVec4 meaningColour(uint32_t darkColour);
ImU32 packed(const ImVec4& colour);

float unit(float pixels);  // pixels at UI scale 1 as pixels of this window
void textDim(std::string_view text);
void textMono(std::string_view text);                                                // a number
void factRow(const char* label, std::string_view value, const char* unitName = "");  // "label      value unit", value in mono
bool factLink(const char* label, std::string_view value);                            // the same, the value a link: true when clicked
bool link(std::string_view text, const char* id);                                    // a number that names a thing; true when clicked
bool keyButton(const char* label, const char* key, bool enabled = true, const char* whyNot = "");  // "Next hole  N"
float drawKeyCap(ImVec2 low, const char* key,
                 bool enabled = true);                   // a key as it is printed, with its upper left corner there; returns its width
void whyTooltip(const char* text);                       // of the item before, hovered, also when disabled
void swatch(uint32_t darkColour, bool hatched = false);  // a small square before a word
bool sectionHeader(const char* title, std::string_view right = "",
                   bool openAtFirst = true);  // a collapsing section with a value at the right
// The same with a small "CSV" at its right end; `csv` becomes true when that was clicked. `rows`: of the table below it, 0 leaves it out.
bool tableSection(const char* title, std::string_view right, size_t rows, bool& csv);
void emptyState(const char* sentence);  // one dim sentence with the action

// 45 degree lines over a rectangle, clipped to it: what is saturated or refused.
void hatch(ImDrawList* list, const ImVec2& low, const ImVec2& high, ImU32 colour);

}  // namespace gridscope
