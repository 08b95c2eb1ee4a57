// See resources.h.
#include "core/gpu/resources.h"

#include <algorithm>

namespace gridscope {
namespace {

VkDeviceMemory allocate(const GpuContext& gpu, const std::string& name, const VkMemoryRequirements& needs,
                        VkMemoryPropertyFlags properties) {
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = needs.size;
  info.memoryTypeIndex = gpu.memoryType(needs.memoryTypeBits, properties);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkResult result = vkAllocateMemory(gpu.device(), &info, nullptr, &memory);
  if (result != VK_SUCCESS)
    throw Error(gpu.report().name + " has no " + std::to_string(needs.size >> 20) + " MiB left for the " + name + " (" +
                    resultName(result) + "); take fewer --cells, a smaller --capacity or a smaller --size",
                kExitDevice);
  return memory;
}

VkMemoryPropertyFlags memoryProperties(BufferMemory memory) {
  switch (memory) {
    case BufferMemory::device: return VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    case BufferMemory::upload: return VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    case BufferMemory::readback:
      return VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
  }
  return 0;
}

}  // namespace

GpuBuffer::GpuBuffer(const GpuContext& gpu, const std::string& name, uint64_t byteCount, BufferMemory memory)
    : device_(gpu.device()), byteCount_(std::max<uint64_t>(byteCount, 4)) {
  uint64_t most = memory == BufferMemory::device ? gpu.report().maxStorageBufferBytes : gpu.report().maxAllocationBytes;
  if (byteCount_ > most)
    throw Error("the " + name + " would take " + std::to_string(byteCount_) + " bytes, but a buffer of " + gpu.report().name + " holds " +
                    std::to_string(most) + "; use a smaller scene or --size, or another device",
                kExitDevice);
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = byteCount_;
  info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  if (memory == BufferMemory::device) info.usage |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
  VK_CHECK(vkCreateBuffer(device_, &info, nullptr, &buffer_));
  gpu.name(VK_OBJECT_TYPE_BUFFER, uint64_t(buffer_), name);

  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device_, buffer_, &needs);
  memory_ = allocate(gpu, name, needs, memoryProperties(memory));
  VK_CHECK(vkBindBufferMemory(device_, buffer_, memory_, 0));
  if (memory == BufferMemory::device) return;
  void* mapped = nullptr;
  VK_CHECK(vkMapMemory(device_, memory_, 0, VK_WHOLE_SIZE, 0, &mapped));
  mapped_ = static_cast<std::byte*>(mapped);
}

GpuBuffer::~GpuBuffer() {
  if (!device_) return;
  vkDestroyBuffer(device_, buffer_, nullptr);
  vkFreeMemory(device_, memory_, nullptr);
}

void GpuBuffer::swap(GpuBuffer& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(buffer_, other.buffer_);
  std::swap(memory_, other.memory_);
  std::swap(byteCount_, other.byteCount_);
  std::swap(mapped_, other.mapped_);
}

GpuImage::GpuImage(const GpuContext& gpu, const std::string& name, const ImageShape& shape) : device_(gpu.device()), shape_(shape) {
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = shape.type;
  info.format = shape.format;
  info.extent = shape.extent;
  info.mipLevels = shape.levels;
  info.arrayLayers = shape.layers;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = shape.usage;
  VK_CHECK(vkCreateImage(device_, &info, nullptr, &image_));
  gpu.name(VK_OBJECT_TYPE_IMAGE, uint64_t(image_), name);

  VkMemoryRequirements needs;
  vkGetImageMemoryRequirements(device_, image_, &needs);
  memory_ = allocate(gpu, name, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  VK_CHECK(vkBindImageMemory(device_, image_, memory_, 0));

  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = image_;
  view.viewType = shape.viewType;
  view.format = shape.format;
  view.subresourceRange = {shape.aspect, 0, shape.levels, 0, shape.layers};
  VK_CHECK(vkCreateImageView(device_, &view, nullptr, &view_));
  gpu.name(VK_OBJECT_TYPE_IMAGE_VIEW, uint64_t(view_), name);
}

GpuImage::~GpuImage() {
  if (!device_) return;
  vkDestroyImageView(device_, view_, nullptr);
  vkDestroyImage(device_, image_, nullptr);
  vkFreeMemory(device_, memory_, nullptr);
}

void GpuImage::swap(GpuImage& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(image_, other.image_);
  std::swap(view_, other.view_);
  std::swap(memory_, other.memory_);
  std::swap(shape_, other.shape_);
}

}  // namespace gridscope
