// Buffers and images: move-only owners, named at creation, destroyed with their last holder. The queue is idle whenever one dies: every
// submission is waited for (commands.h).
#pragma once

#include <cstddef>
#include <string>

#include "core/gpu/device.h"

namespace gridscope {

enum class BufferMemory {
  device,    // the device's own
  upload,    // mapped, written by the host
  readback,  // mapped, read by the host
};

class GpuBuffer {
 public:
  GpuBuffer() = default;
  // At least 4 bytes are allocated, so that an empty array can still be bound. Throws when the device can't hold `byteCount`.
  GpuBuffer(const GpuDevice& gpu, const std::string& name, uint64_t byteCount, BufferMemory memory = BufferMemory::device);
  GpuBuffer(GpuBuffer&& other) noexcept = default;
  GpuBuffer& operator=(GpuBuffer other) noexcept;  // by value: what was here goes as a whole, in its own order

  VkBuffer handle() const { return buffer_.get(); }
  uint64_t byteCount() const { return byteCount_; }
  std::byte* mapped() const { return mapped_; }
  explicit operator bool() const { return bool(buffer_); }

 private:
  uint64_t byteCount_ = 0;
  Owned<VkDeviceMemory> memory_;
  Owned<VkBuffer> buffer_;  // goes before its memory
  std::byte* mapped_ = nullptr;
};

struct ImageShape {
  VkImageType type = VK_IMAGE_TYPE_2D;
  VkImageViewType viewType = VK_IMAGE_VIEW_TYPE_2D;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent3D extent{1, 1, 1};
  uint32_t layers = 1;
  uint32_t levels = 1;
  VkImageUsageFlags usage = 0;
  VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};

class GpuImage {
 public:
  GpuImage() = default;
  GpuImage(const GpuDevice& gpu, const std::string& name, const ImageShape& shape);
  GpuImage(GpuImage&& other) noexcept = default;
  GpuImage& operator=(GpuImage other) noexcept;

  VkImage handle() const { return image_.get(); }
  VkImageView view() const { return view_.get(); }
  const ImageShape& shape() const { return shape_; }
  explicit operator bool() const { return bool(image_); }

 private:
  ImageShape shape_;
  Owned<VkDeviceMemory> memory_;
  Owned<VkImage> image_;
  Owned<VkImageView> view_;  // goes first
};

}  // namespace gridscope
