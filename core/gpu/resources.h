// Buffers and images: move-only owners, named at creation, destroyed with their last holder. The queue is idle whenever one dies: every
// submission is waited for (commands.h).
#pragma once

#include <span>
#include <string>

#include "core/gpu/context.h"

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
  GpuBuffer(const GpuContext& gpu, const std::string& name, uint64_t byteCount, BufferMemory memory = BufferMemory::device);
  GpuBuffer(GpuBuffer&& other) noexcept { swap(other); }
  GpuBuffer& operator=(GpuBuffer&& other) noexcept { return swap(other), *this; }
  ~GpuBuffer();

  VkBuffer handle() const { return buffer_; }
  uint64_t byteCount() const { return byteCount_; }
  std::byte* mapped() const { return mapped_; }
  explicit operator bool() const { return buffer_ != VK_NULL_HANDLE; }

 private:
  void swap(GpuBuffer& other) noexcept;

  VkDevice device_ = VK_NULL_HANDLE;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  uint64_t byteCount_ = 0;
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
  GpuImage(const GpuContext& gpu, const std::string& name, const ImageShape& shape);
  GpuImage(GpuImage&& other) noexcept { swap(other); }
  GpuImage& operator=(GpuImage&& other) noexcept { return swap(other), *this; }
  ~GpuImage();

  VkImage handle() const { return image_; }
  VkImageView view() const { return view_; }
  const ImageShape& shape() const { return shape_; }
  explicit operator bool() const { return image_ != VK_NULL_HANDLE; }

 private:
  void swap(GpuImage& other) noexcept;

  VkDevice device_ = VK_NULL_HANDLE;
  VkImage image_ = VK_NULL_HANDLE;
  VkImageView view_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  ImageShape shape_;
};

}  // namespace gridscope
