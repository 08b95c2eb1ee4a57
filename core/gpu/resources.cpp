// See resources.h.
#include "core/gpu/resources.h"

#include <algorithm>

namespace gridscope {
namespace {

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

GpuBuffer::GpuBuffer(const GpuDevice& gpu, const std::string& name, uint64_t byteCount, BufferMemory memory)
    : byteCount_(std::max<uint64_t>(byteCount, 4)) {
  uint64_t most = memory == BufferMemory::device ? gpu.report().maxStorageBufferBytes : gpu.report().maxAllocationBytes;
  if (byteCount_ > most)
    throw Error("the " + name + " would take " + std::to_string(byteCount_) + " bytes, but a buffer of " + gpu.report().name + " holds " +
                    std::to_string(most) + "; use a smaller scene or --size, or another device",
                kExitDevice);
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = byteCount_;
  info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  if (memory == BufferMemory::device) info.usage |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
  buffer_ = gpu.make(info, name);

  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(gpu.handle(), handle(), &needs);
  memory_ = gpu.allocate(needs, memoryProperties(memory), name);
  VK_CHECK(vkBindBufferMemory(gpu.handle(), handle(), memory_.get(), 0));
  if (memory == BufferMemory::device) return;
  void* mapped = nullptr;
  VK_CHECK(vkMapMemory(gpu.handle(), memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped));
  mapped_ = static_cast<std::byte*>(mapped);
}

GpuBuffer& GpuBuffer::operator=(GpuBuffer other) noexcept {
  std::swap(byteCount_, other.byteCount_);
  std::swap(memory_, other.memory_);
  std::swap(buffer_, other.buffer_);
  std::swap(mapped_, other.mapped_);
  return *this;
}

GpuImage::GpuImage(const GpuDevice& gpu, const std::string& name, const ImageShape& shape) : shape_(shape) {
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = shape.type;
  info.format = shape.format;
  info.extent = shape.extent;
  info.mipLevels = shape.levels;
  info.arrayLayers = shape.layers;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = shape.usage;
  image_ = gpu.make(info, name);

  VkMemoryRequirements needs;
  vkGetImageMemoryRequirements(gpu.handle(), handle(), &needs);
  memory_ = gpu.allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, name);
  VK_CHECK(vkBindImageMemory(gpu.handle(), handle(), memory_.get(), 0));

  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = handle();
  view.viewType = shape.viewType;
  view.format = shape.format;
  view.subresourceRange = {shape.aspect, 0, shape.levels, 0, shape.layers};
  view_ = gpu.make(view, name);
}

GpuImage& GpuImage::operator=(GpuImage other) noexcept {
  std::swap(shape_, other.shape_);
  std::swap(memory_, other.memory_);
  std::swap(image_, other.image_);
  std::swap(view_, other.view_);
  return *this;
}

}  // namespace gridscope
