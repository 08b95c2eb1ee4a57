// PNG files, encoded by stb_image_write.
#include "core/base/image_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <stb/stb_image_write.h>

#include "core/base/error.h"

namespace gridscope {

static void appendBytes(void* bytes, void* data, int size) {
  const auto* first = static_cast<const std::byte*>(data);
  auto& target = *static_cast<std::vector<std::byte>*>(bytes);
  target.insert(target.end(), first, first + size);
}

// Writes all bytes to disk; false with errno set when it could not.
static bool writeBytes(const std::string& path, const std::vector<std::byte>& bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return false;
  bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0 && fsync(fileno(file)) == 0;
  int reason = errno;
  if (std::fclose(file) != 0 && written) return false;
  errno = reason;
  return written;
}

Picture makePicture(uint32_t width, uint32_t height, uint32_t colour) {
  Picture picture{.width = width, .height = height, .rgba = std::vector<uint8_t>(size_t{4} * width * height, 255)};
  for (size_t i = 0; i < picture.rgba.size(); i += 4)
    for (uint32_t channel = 0; channel < 3; ++channel) picture.rgba[i + channel] = static_cast<uint8_t>(colour >> (16 - 8 * channel));
  return picture;
}

std::vector<std::byte> pngBytes(const Picture& picture) {
  CHECK_EQ(picture.rgba.size(), size_t{4} * picture.width * picture.height);
  std::vector<std::byte> bytes;
  const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
  if (picture.rgba.empty() || !stbi_write_png_to_func(appendBytes, &bytes, width, height, 4, picture.rgba.data(), 4 * width))
    throw Error("a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels could not be encoded");
  return bytes;
}

void writePng(const std::string& path, const Picture& picture) {
  CHECK_EQ(picture.rgba.size(), size_t{4} * picture.width * picture.height);
  if (picture.rgba.empty()) throw Error(path + ": a picture without pixels can't be written");

  std::vector<std::byte> bytes;
  try {
    bytes = pngBytes(picture);
  } catch (const Error& error) {
    throw error.within(path);
  }
  std::string temporary = path + ".part-" + std::to_string(getpid());
  if (writeBytes(temporary, bytes) && std::rename(temporary.c_str(), path.c_str()) == 0) return;
  std::string reason = std::strerror(errno);
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw Error(path + ": can't be written: " + reason);
}

}  // namespace gridscope
