// Text in pictures: Inter for words, JetBrains Mono for numbers, both embedded in the program.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/image_file.h"

namespace gridscope {

enum class Font { sans, mono };

// The bytes of an embedded font file.
enum class FontFile { sans, bold, mono };
std::span<const unsigned char> fontFile(FontFile file);

struct TextStyle {
  Font font = Font::sans;
  float size = 13.0f;   // pixels an em
  uint32_t colour = 0;  // 0xRRGGBB
};

// Width in pixels of a text in UTF-8.
float textWidth(std::string_view text, const TextStyle& style);

// Draws a text from `x` on its baseline; what reaches beyond the picture is cut.
void drawText(Picture& picture, std::string_view text, float x, int baseline, const TextStyle& style);

// The text, shortened with an ellipsis when it is wider than `width`; empty when not even that fits.
std::string shortenText(std::string_view text, float width, const TextStyle& style);

}  // namespace gridscope
