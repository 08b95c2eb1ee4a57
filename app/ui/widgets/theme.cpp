// See theme.h, and widgets.h for colours.
#include "app/ui/widgets/theme.h"

#include <array>
#include <cmath>

#include "views/fonts.h"

namespace gridscope {

namespace {

struct ThemeColour {
  uint32_t dark;
  uint32_t light;
};

// In the order of UiColour.
constexpr ThemeColour kUiColours[] = {
    {0x14171B, 0xD3D8DE},  // window
    {0x1A1E23, 0xF3F5F7},  // panel
    {0x22272E, 0xE3E7EC},  // head
    {0x2A3038, 0xFFFFFF},  // control
    {0x2E353D, 0xD0D6DD},  // line
    {0xD9DFE5, 0x1C232A},  // text
    {0x8F9AA6, 0x55616D},  // dim
    {0x5A646F, 0x98A2AC},  // disabled
    {0x3D8BFD, 0x1768D6},  // accent
    {0x24405F, 0xCFE1FA},  // selectedRow
    {0x7DB3FF, 0x1768D6},  // link
};

// Colours with a fixed meaning, as the light theme shows them.
constexpr ThemeColour kMeanings[] = {
    {kColourTriangleHit, 0x12855F}, {kColourVoxelHit, 0xB57A00},   {kColourMiss, 0x4A6F9B},       {kColourSaturated, 0xC43A8B},
    {kColourTested, 0x2A7FBA},      {kColourRevisit, 0x6F5DBF},    {kColourEmpty, 0x77828D},      {kColourSelected, 0x000000},
    {kColourHole, 0xCF4210},        {kColourVoxelRight, 0x8C6D14}, {kColourVoxelWrong, 0xD9A800}, {kColourTooFar, 0x1E6FB8},
    {kColourTooNear, 0x4FA9D0},     {kColourGate, kColourGate},
};

Theme presentTheme = Theme::dark;
float presentScale = 1.0f;

ImVec4 unpacked(uint32_t colour) {
  return {float(colour >> 16 & 255) / 255.0f, float(colour >> 8 & 255) / 255.0f, float(colour & 255) / 255.0f, 1.0f};
}

ImVec4 mixed(const ImVec4& a, const ImVec4& b, float share) {
  return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share, a.z + (b.z - a.z) * share, a.w + (b.w - a.w) * share};
}

ImFont* addFont(FontFile file, float pixels) {
  // Latin, punctuation, arrows, mathematical signs, geometric shapes.
  static const ImWchar ranges[] = {0x20, 0x17F, 0x2010, 0x2044, 0x2190, 0x2195, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 2;
  config.OversampleV = 1;
  const std::span<const unsigned char> bytes = fontFile(file);
  return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(const_cast<unsigned char*>(bytes.data()), int(bytes.size()), pixels, &config, ranges);
}

}  // namespace

WindowFonts& windowFonts() {
  static WindowFonts fonts;
  return fonts;
}

// Inter's em of 13 px is 16 px of ImGui's size, which counts from ascender to descender; JetBrains Mono's of 12 likewise.
void loadWindowFonts(float uiScale) {
  ImGui::GetIO().Fonts->Clear();
  WindowFonts& fonts = windowFonts();
  fonts.sans = addFont(FontFile::sans, std::round(16.0f * uiScale));
  fonts.sansSmall = addFont(FontFile::sans, std::round(15.0f * uiScale));
  fonts.sansBold = addFont(FontFile::bold, std::round(16.0f * uiScale));
  fonts.sansLarge = addFont(FontFile::bold, std::round(18.0f * uiScale));
  fonts.mono = addFont(FontFile::mono, std::round(15.0f * uiScale));
}

ImVec4 uiColour(UiColour colour) {
  const ThemeColour& both = kUiColours[size_t(colour)];
  return unpacked(presentTheme == Theme::dark ? both.dark : both.light);
}

ImVec4 meaningColour(uint32_t darkColour) {
  if (presentTheme == Theme::light)
    for (const ThemeColour& meaning : kMeanings)
      if (meaning.dark == darkColour) return unpacked(meaning.light);
  return unpacked(darkColour);
}

ImU32 packed(const ImVec4& colour) {
  return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, colour.w * ImGui::GetStyle().Alpha});
}

float unit(float pixels) { return std::round(pixels * presentScale); }

void applyTheme(Theme theme, float uiScale) {
  presentTheme = theme;
  presentScale = uiScale;
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  style.WindowPadding = {unit(10), unit(8)};
  style.FramePadding = {unit(6), unit(2)};
  style.ItemSpacing = {unit(8), unit(4)};
  style.ItemInnerSpacing = {unit(6), unit(4)};
  style.CellPadding = {unit(6), unit(2)};
  style.WindowRounding = 0.0f;
  style.ChildRounding = 0.0f;
  style.FrameRounding = style.PopupRounding = style.GrabRounding = style.TabRounding = style.ScrollbarRounding = unit(3);
  style.WindowBorderSize = 0.0f;
  style.ChildBorderSize = 0.0f;
  style.PopupBorderSize = 1.0f;
  style.FrameBorderSize = theme == Theme::light ? 1.0f : 0.0f;
  style.ScrollbarSize = unit(10);
  style.GrabMinSize = unit(8);
  style.IndentSpacing = unit(14);
  style.WindowMinSize = {1.0f, 1.0f};

  const ImVec4 panel = uiColour(UiColour::panel), head = uiColour(UiColour::head), control = uiColour(UiColour::control);
  const ImVec4 line = uiColour(UiColour::line), text = uiColour(UiColour::text), accent = uiColour(UiColour::accent);
  const ImVec4 selected = uiColour(UiColour::selectedRow), clear{0, 0, 0, 0};
  ImVec4* colours = style.Colors;
  colours[ImGuiCol_Text] = text;
  colours[ImGuiCol_TextDisabled] = uiColour(UiColour::disabled);
  colours[ImGuiCol_WindowBg] = panel;
  colours[ImGuiCol_ChildBg] = clear;
  colours[ImGuiCol_PopupBg] = theme == Theme::dark ? head : panel;
  colours[ImGuiCol_Border] = line;
  colours[ImGuiCol_BorderShadow] = clear;
  colours[ImGuiCol_FrameBg] = control;
  colours[ImGuiCol_FrameBgHovered] = mixed(control, text, 0.08f);
  colours[ImGuiCol_FrameBgActive] = mixed(control, accent, 0.3f);
  colours[ImGuiCol_TitleBg] = colours[ImGuiCol_TitleBgActive] = colours[ImGuiCol_TitleBgCollapsed] = head;
  colours[ImGuiCol_MenuBarBg] = head;
  colours[ImGuiCol_ScrollbarBg] = clear;
  colours[ImGuiCol_ScrollbarGrab] = mixed(control, text, 0.15f);
  colours[ImGuiCol_ScrollbarGrabHovered] = mixed(control, text, 0.25f);
  colours[ImGuiCol_ScrollbarGrabActive] = mixed(control, text, 0.35f);
  colours[ImGuiCol_CheckMark] = accent;
  colours[ImGuiCol_SliderGrab] = accent;
  colours[ImGuiCol_SliderGrabActive] = mixed(accent, text, 0.2f);
  colours[ImGuiCol_Button] = control;
  colours[ImGuiCol_ButtonHovered] = mixed(control, text, 0.1f);
  colours[ImGuiCol_ButtonActive] = mixed(control, accent, 0.4f);
  colours[ImGuiCol_Header] = selected;
  colours[ImGuiCol_HeaderHovered] = mixed(selected, control, 0.4f);
  colours[ImGuiCol_HeaderActive] = selected;
  colours[ImGuiCol_Separator] = line;
  colours[ImGuiCol_SeparatorHovered] = colours[ImGuiCol_SeparatorActive] = accent;
  colours[ImGuiCol_ResizeGrip] = clear;
  colours[ImGuiCol_Tab] = head;
  colours[ImGuiCol_TabHovered] = mixed(head, text, 0.08f);
  colours[ImGuiCol_TabActive] = panel;
  colours[ImGuiCol_TabUnfocused] = head;
  colours[ImGuiCol_TabUnfocusedActive] = panel;
  colours[ImGuiCol_PlotLines] = accent;
  colours[ImGuiCol_PlotHistogram] = accent;
  colours[ImGuiCol_TableHeaderBg] = panel;
  colours[ImGuiCol_TableBorderStrong] = line;
  colours[ImGuiCol_TableBorderLight] = mixed(panel, line, 0.6f);
  colours[ImGuiCol_TableRowBg] = clear;
  colours[ImGuiCol_TableRowBgAlt] = mixed(clear, ImVec4(text.x, text.y, text.z, 0.025f), 1.0f);
  colours[ImGuiCol_TextSelectedBg] = selected;
  colours[ImGuiCol_DragDropTarget] = accent;
  colours[ImGuiCol_NavHighlight] = accent;
  colours[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.5f};
}

}  // namespace gridscope
