// See diffuse_maps.h.
#include "core/gpu/diffuse_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"

namespace gridscope {
namespace {

const std::array<float, 256>& linearOfSrgb() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values;
    for (int i = 0; i < 256; ++i) {
      float s = float(i) / 255.0f;
      values[i] = s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
    }
    return values;
  }();
  return table;
}

uint8_t srgbOfLinear(float linear) {
  float s = linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
  return uint8_t(std::clamp(s * 255.0f + 0.5f, 0.0f, 255.0f));
}

// One texel of the resized image: the mean over the box of texels that it covers, or the bilinear blend when enlarged.
struct Axis {
  uint32_t first, last;  // texels covered, both included
  float blend;           // of `last` against `first`, when the image is enlarged; negative: mean
};

Axis coveredTexels(uint32_t texel, uint32_t size, uint32_t sourceSize) {
  float scale = float(sourceSize) / float(size);
  if (scale > 1.0f) {
    uint32_t first = uint32_t(float(texel) * scale), last = uint32_t(std::ceil(float(texel + 1) * scale)) - 1;
    return {std::min(first, sourceSize - 1), std::min(std::max(first, last), sourceSize - 1), -1.0f};
  }
  float centre = (float(texel) + 0.5f) * scale - 0.5f;
  float low = std::floor(centre);
  auto wrapped = [&](float at) { return uint32_t((int64_t(at) + sourceSize) % sourceSize); };
  return {wrapped(low), wrapped(low + 1.0f), centre - low};
}

// Resizes to a square layer in linear colour, colour weighted by nothing (alpha keying has maps of its own).
void resizeLayer(const Image& image, uint32_t size, std::span<uint8_t> layer) {
  for (uint32_t y = 0; y < size; ++y) {
    Axis rows = coveredTexels(y, size, image.height);
    for (uint32_t x = 0; x < size; ++x) {
      Axis columns = coveredTexels(x, size, image.width);
      float sum[3] = {}, weights = 0.0f;
      auto take = [&](uint32_t row, uint32_t column, float weight) {
        const uint8_t* texel = &image.rgba[4 * (size_t(row) * image.width + column)];
        for (int c = 0; c < 3; ++c) sum[c] += weight * linearOfSrgb()[texel[c]];
        weights += weight;
      };
      auto takeRow = [&](uint32_t row, float weight) {
        if (columns.blend >= 0.0f) {
          take(row, columns.first, weight * (1.0f - columns.blend));
          take(row, columns.last, weight * columns.blend);
        } else {
          for (uint32_t column = columns.first; column <= columns.last; ++column) take(row, column, weight);
        }
      };
      if (rows.blend >= 0.0f) {
        takeRow(rows.first, 1.0f - rows.blend);
        takeRow(rows.last, rows.blend);
      } else {
        for (uint32_t row = rows.first; row <= rows.last; ++row) takeRow(row, 1.0f);
      }
      uint8_t* out = &layer[4 * (size_t(y) * size + x)];
      for (int c = 0; c < 3; ++c) out[c] = srgbOfLinear(sum[c] / std::max(weights, 1e-6f));
      out[3] = 255;
    }
  }
}

void copyLayer(const Image& image, uint32_t size, std::span<uint8_t> layer) {
  if (image.width == size && image.height == size)
    std::copy(image.rgba.begin(), image.rgba.end(), layer.begin());
  else
    resizeLayer(image, size, layer);
}

}  // namespace

std::vector<uint8_t> diffuseLayers(std::span<const Image> images, uint32_t size) {
  const size_t layerBytes = size_t(4) * size * size;
  std::vector<uint8_t> texels(layerBytes * std::max<size_t>(1, images.size()), 255);
  forRanges(images.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) copyLayer(images[i], size, std::span(texels).subspan(i * layerBytes, layerBytes));
  });
  return texels;
}

}  // namespace gridscope
