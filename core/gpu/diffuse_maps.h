// Diffuse maps of any size as layers of one array image.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace gridscope {

// Each image resized to `size` x `size` texels in linear light, one behind the other, sRGB RGBA with alpha 255; one white layer where there are
// none.
std::vector<uint8_t> diffuseLayers(std::span<const Image> images, uint32_t size);

}  // namespace gridscope
