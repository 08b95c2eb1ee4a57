// PNG and JPEG bytes to an Image, with its size checked before a pixel is decoded.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/image.h"

namespace gridscope {

inline constexpr uint32_t kImageSideLimit = 16384;
inline constexpr uint64_t kImagePixelLimit = uint64_t{64} << 20;

struct ImageSize {
  uint32_t width = 0;
  uint32_t height = 0;
  uint64_t pixels() const { return uint64_t{width} * height; }
};

// From the header alone. Throws Error for anything but PNG and JPEG, and for an absurd size.
ImageSize imageSize(std::span<const unsigned char> encoded);

// Throws Error when the bytes are damaged.
Image decodeImage(std::span<const unsigned char> encoded, const std::string& name);

// What stands in for an image that can't be read: squares of magenta and black.
Image checkerImage(const std::string& name);

}  // namespace gridscope
