// PNG and JPEG bytes to an Image, see image_decode.h.
#include "core/base/image_decode.h"

#include <algorithm>
#include <array>
#include <memory>

#include <stb/stb_image.h>

#include "core/base/error.h"

namespace gridscope {

namespace {

// Deflate packs at most 1,032 bytes into one, so a PNG of one bit a pixel at most 8,256 pixels; JPEG stays far below. A header that
// claims more is damaged or a bomb.
constexpr uint64_t kPixelsPerByteLimit = 8256;

// stb_image knows more formats, less well tested ones; glTF allows these two.
bool isPng(std::span<const unsigned char> bytes) {
  constexpr std::array<unsigned char, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  return bytes.size() > kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), bytes.begin());
}
bool isJpeg(std::span<const unsigned char> bytes) { return bytes.size() > 3 && bytes[0] == 0xFF && bytes[1] == 0xD8 && bytes[2] == 0xFF; }
bool isKtx2(std::span<const unsigned char> bytes) {
  return bytes.size() > 12 && bytes[0] == 0xAB && bytes[1] == 'K' && bytes[2] == 'T' && bytes[3] == 'X';
}

std::string decoderReason() {
  const char* reason = stbi_failure_reason();
  return reason ? reason : "no reason given";
}

}  // namespace

ImageSize imageSize(std::span<const unsigned char> encoded) {
  if (isKtx2(encoded)) throw Error("KTX2 is not supported");
  if (!isPng(encoded) && !isJpeg(encoded)) throw Error("neither PNG nor JPEG");
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(encoded.data(), static_cast<int>(encoded.size()), &width, &height, &channels))
    throw Error("damaged header, " + decoderReason());
  const ImageSize size{static_cast<uint32_t>(std::max(width, 0)), static_cast<uint32_t>(std::max(height, 0))};
  const std::string claim = std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels";
  if (size.pixels() == 0) throw Error("no pixels");
  if (size.width > kImageSideLimit || size.height > kImageSideLimit || size.pixels() > kImagePixelLimit)
    throw Error(claim + " are too many; at most 16384 a side and 64 Mi in all");
  if (size.pixels() > kPixelsPerByteLimit * encoded.size()) throw Error(claim + " can't be in so few bytes");
  return size;
}

Image decodeImage(std::span<const unsigned char> encoded, const std::string& name) {
  imageSize(encoded);
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(encoded.data(), static_cast<int>(encoded.size()), &width, &height, &channels, 4), stbi_image_free);
  if (!pixels) throw Error("damaged, " + decoderReason());
  Image image{.name = name, .width = static_cast<uint32_t>(width), .height = static_cast<uint32_t>(height), .rgba = {}};
  image.rgba.assign(pixels.get(), pixels.get() + size_t{4} * image.width * image.height);
  return image;
}

Image checkerImage(const std::string& name) {
  constexpr uint32_t kSide = 64, kSquare = 8;
  Image image{.name = name, .width = kSide, .height = kSide, .rgba = std::vector<uint8_t>(size_t{4} * kSide * kSide)};
  for (uint32_t y = 0; y < kSide; ++y) {
    for (uint32_t x = 0; x < kSide; ++x) {
      const uint8_t light = (x / kSquare + y / kSquare) % 2 == 0 ? 255 : 0;
      uint8_t* pixel = &image.rgba[size_t{4} * (y * kSide + x)];
      pixel[0] = pixel[2] = light, pixel[1] = 0, pixel[3] = 255;
    }
  }
  return image;
}

}  // namespace gridscope
