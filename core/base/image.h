// An image in memory, as a scene's diffuse map.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gridscope {

// Colour image: sRGB colour with straight alpha, 4 bytes a pixel, first row at v = 0.
struct Image {
  std::string name;
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<uint8_t> rgba;
};

}  // namespace gridscope
