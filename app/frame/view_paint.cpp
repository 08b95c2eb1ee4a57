// See view_paint.h.
#include "app/frame/view_paint.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"

namespace gridscope {

static constexpr int kTableSize = 1024;  // steps of a colour map: finer than 8 bits show

static uint32_t darkened(uint32_t bytes, uint32_t shadow) {
  if (shadow == 0) return bytes;
  const uint32_t light = 255 - shadow;
  uint32_t result = 0;
  for (int shift = 0; shift < 24; shift += 8) result |= ((bytes >> shift & 255u) * light + 127u) / 255u << shift;
  return result;
}

std::vector<uint8_t> paintView(const Pipeline::ViewImage& image, ValueRange range, uint32_t map) {
  std::vector<uint32_t> table(kTableSize), marked(2 * kTableSize);
  for (int i = 0; i < kTableSize; ++i) {
    const float x = float(i) / float(kTableSize - 1);
    table[size_t(i)] = packBytes(colourMap(map, x));
    marked[size_t(2 * i)] = packBytes(markedColour(x, uvec2(0, 0)));
    marked[size_t(2 * i + 1)] = packBytes(markedColour(x, uvec2(4, 0)));
  }
  const float scale = 1.0f / std::max(range[1] - range[0], 1e-30f);
  const uint32_t background = packBytes(unpackColour(kColourWindow));
  std::vector<uint8_t> rgba(image.elements.size() * 4);
  auto* out = reinterpret_cast<uint32_t*>(rgba.data());
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = 0; x < image.width; ++x, ++out) {
      const ViewElement& element = image.elements[size_t{y} * image.width + x];
      uint32_t bytes = background;
      if (element.kind == kElementColour) {
        bytes = element.payload;
      } else if (element.kind == kElementValue || element.kind == kElementMarked) {
        const float place = (uintBitsToFloat(element.payload) - range[0]) * scale;
        const auto at = size_t(place > 0.0f ? std::min(place, 1.0f) * float(kTableSize - 1) + 0.5f : 0.0f);
        bytes = element.kind == kElementValue ? table[at] : marked[2 * at + (hatchLine(uvec2(x, y)) ? 1 : 0)];
      }
      *out = darkened(bytes & 0xFFFFFFu, element.shadow) | 0xFF000000u;
    }
  return rgba;
}

std::string elementText(const ViewElement& element, std::string_view unit) {
  if (element.kind == kElementNothing) return "nothing";
  if (element.kind == kElementColour)
    return printed("#%02X%02X%02X", element.payload & 255u, element.payload >> 8 & 255u, element.payload >> 16 & 255u);
  const float value = uintBitsToFloat(element.payload);
  if (!std::isfinite(value)) return "not finite";
  const bool whole = value == std::floor(value) && std::abs(value) < 1e9f;
  std::string text = whole ? (value < 0 ? "-" : "") + grouped(uint64_t(std::abs(value))) : printed("%.4g", double(value));
  if (!unit.empty()) text += " " + std::string(unit);
  if (element.kind == kElementMarked) text += ", saturated";
  return text;
}

}  // namespace gridscope
