// Text through stb_truetype. GRIDSCOPE_FONT_... are the font files' paths.
#include "views/fonts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <stb/stb_truetype.h>

#include "core/base/embed.h"
#include "core/base/error.h"

EMBED(gridscope_font_sans, GRIDSCOPE_FONT_SANS);
EMBED(gridscope_font_mono, GRIDSCOPE_FONT_MONO);
EMBED(gridscope_font_bold, GRIDSCOPE_FONT_BOLD);

namespace gridscope {

std::span<const unsigned char> fontFile(FontFile file) {
  if (file == FontFile::sans) return {gridscope_font_sans, gridscope_font_sans_end};
  if (file == FontFile::bold) return {gridscope_font_bold, gridscope_font_bold_end};
  return {gridscope_font_mono, gridscope_font_mono_end};
}

static stbtt_fontinfo openFont(const unsigned char* bytes) {
  stbtt_fontinfo font;
  CHECK_EQ(stbtt_InitFont(&font, bytes, stbtt_GetFontOffsetForIndex(bytes, 0)), 1);
  return font;
}

static const stbtt_fontinfo& fontOf(Font font) {
  static const stbtt_fontinfo sans = openFont(gridscope_font_sans);
  static const stbtt_fontinfo mono = openFont(gridscope_font_mono);
  return font == Font::sans ? sans : mono;
}

// Takes the first code point off a text in UTF-8; a damaged byte counts as U+FFFD.
static int takeCodePoint(std::string_view& text) {
  unsigned char first = static_cast<unsigned char>(text.front());
  size_t length = first < 0x80 ? 1 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  int codePoint = length == 1 ? first : first & (0xFF >> (length + 1));
  bool damaged = (first >= 0x80 && first < 0xC2) || first > 0xF4 || length > text.size();
  for (size_t i = 1; i < length && !damaged; ++i) {
    damaged = (text[i] & 0xC0) != 0x80;
    codePoint = (codePoint << 6) | (text[i] & 0x3F);
  }
  text.remove_prefix(damaged ? 1 : length);
  return damaged ? 0xFFFD : codePoint;
}

// Calls place(glyph, x) for each glyph of a text, x from 0, and returns the text's width.
template <typename Place>
static float layOut(std::string_view text, const TextStyle& style, Place place) {
  const stbtt_fontinfo& font = fontOf(style.font);
  float scale = stbtt_ScaleForMappingEmToPixels(&font, style.size);
  float x = 0.0f;
  int previous = -1;
  while (!text.empty()) {
    int glyph = stbtt_FindGlyphIndex(&font, takeCodePoint(text));
    if (previous >= 0) x += scale * static_cast<float>(stbtt_GetGlyphKernAdvance(&font, previous, glyph));
    place(glyph, x);
    int advance = 0;
    stbtt_GetGlyphHMetrics(&font, glyph, &advance, nullptr);
    x += scale * static_cast<float>(advance);
    previous = glyph;
  }
  return x;
}

// Mixes a colour into a pixel. Light text on a dark ground looks thin when covered pixels are mixed as they are stored.
static void blend(Picture& picture, int x, int y, uint32_t colour, float coverage) {
  if (x < 0 || y < 0 || x >= static_cast<int>(picture.width) || y >= static_cast<int>(picture.height)) return;
  uint8_t* pixel = &picture.rgba[4 * (static_cast<size_t>(y) * picture.width + static_cast<size_t>(x))];
  float weight = std::pow(coverage, 0.8f);
  for (int channel = 0; channel < 3; ++channel) {
    float target = static_cast<float>((colour >> (16 - 8 * channel)) & 255u);
    float present = pixel[channel];
    pixel[channel] = static_cast<uint8_t>(std::lround(present + (target - present) * weight));
  }
}

float textWidth(std::string_view text, const TextStyle& style) {
  return layOut(text, style, [](int, float) {});
}

void drawText(Picture& picture, std::string_view text, float x, int baseline, const TextStyle& style) {
  const stbtt_fontinfo& font = fontOf(style.font);
  float scale = stbtt_ScaleForMappingEmToPixels(&font, style.size);
  std::vector<unsigned char> coverage;
  layOut(text, style, [&](int glyph, float offset) {
    // Glyphs start at quarters of a pixel.
    float start = std::floor(4.0f * (x + offset) + 0.5f) * 0.25f;
    int column = static_cast<int>(std::floor(start));
    float shift = start - static_cast<float>(column);
    int left, top, right, bottom;
    stbtt_GetGlyphBitmapBoxSubpixel(&font, glyph, scale, scale, shift, 0.0f, &left, &top, &right, &bottom);
    int width = right - left;
    int height = bottom - top;
    if (width <= 0 || height <= 0) return;
    coverage.assign(static_cast<size_t>(width) * static_cast<size_t>(height), 0);
    stbtt_MakeGlyphBitmapSubpixel(&font, coverage.data(), width, height, width, scale, scale, shift, 0.0f, glyph);
    for (int row = 0; row < height; ++row)
      for (int i = 0; i < width; ++i)
        if (unsigned char covered = coverage[static_cast<size_t>(row) * static_cast<size_t>(width) + static_cast<size_t>(i)])
          blend(picture, column + left + i, baseline + top + row, style.colour, static_cast<float>(covered) / 255.0f);
  });
}

std::string shortenText(std::string_view text, float width, const TextStyle& style) {
  if (textWidth(text, style) <= width) return std::string(text);
  while (!text.empty()) {
    // Take away the last code point, and the spaces before it.
    while (text.size() > 1 && (text.back() & 0xC0) == 0x80) text.remove_suffix(1);
    text.remove_suffix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    std::string shorter = std::string(text) + "\u2026";
    if (textWidth(shorter, style) <= width) return text.empty() ? "" : shorter;
  }
  return "";
}

}  // namespace gridscope
