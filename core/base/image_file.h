// Pictures and the PNG files they are written to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gridscope {

struct Picture {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<uint8_t> rgba;  // sRGB with straight alpha, 4 bytes a pixel, first row at the top
};

// A picture of one colour, 0xRRGGBB, opaque.
Picture makePicture(uint32_t width, uint32_t height, uint32_t colour);

// A PNG file in memory. Throws Error.
std::vector<std::byte> pngBytes(const Picture& picture);

// Writes to a temporary file beside `path`, then renames it: what fails or is interrupted leaves the old file. Throws Error.
void writePng(const std::string& path, const Picture& picture);

}  // namespace gridscope
