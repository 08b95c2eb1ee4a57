// See commands.h.
#include "core/gpu/commands.h"

#include <algorithm>

namespace gridscope {
namespace {

constexpr uint32_t kMostPasses = 256;
constexpr uint64_t kCopyBytes = 64ull << 20;  // of one part of a copy: keeps host memory bounded

uint32_t texelBytes(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_R8G8B8A8_SRGB:
    case VK_FORMAT_R8G8B8A8_UNORM: return 4;
    default: break;
  }
  CHECK_EQ(int(format), int(VK_FORMAT_R32_UINT));
  return 0;
}

// Calls copy(region, byteOffset, byteCount) for runs of whole planes (z slices or layers) that fit in one part.
template <typename Copy>
void forImageParts(const ImageShape& shape, const Copy& copy) {
  uint64_t rowBytes = uint64_t(shape.extent.width) * texelBytes(shape.format);
  uint32_t rowsPerPart = uint32_t(std::clamp<uint64_t>(kCopyBytes / rowBytes, 1, shape.extent.height));
  uint32_t planes = std::max(shape.extent.depth, shape.layers);
  bool volume = shape.type == VK_IMAGE_TYPE_3D;
  for (uint32_t plane = 0; plane < planes; ++plane) {
    for (uint32_t row = 0; row < shape.extent.height; row += rowsPerPart) {
      uint32_t rows = std::min(rowsPerPart, shape.extent.height - row);
      VkBufferImageCopy region{};
      region.imageSubresource = {shape.aspect, 0, volume ? 0 : plane, 1};
      region.imageOffset = {0, int32_t(row), volume ? int32_t(plane) : 0};
      region.imageExtent = {shape.extent.width, rows, 1};
      copy(region, (uint64_t(plane) * shape.extent.height + row) * rowBytes, rows * rowBytes);
    }
  }
}

// Regions gathered until a part is full, then flushed.
struct ImagePart {
  std::vector<VkBufferImageCopy> regions;
  uint64_t begin = 0;  // first byte on the host
  uint64_t bytes = 0;
};

std::vector<ImagePart> imageParts(const ImageShape& shape) {
  std::vector<ImagePart> parts;
  forImageParts(shape, [&](VkBufferImageCopy region, uint64_t offset, uint64_t bytes) {
    if (parts.empty() || parts.back().bytes + bytes > kCopyBytes) parts.push_back({{}, offset, 0});
    region.bufferOffset = parts.back().bytes;
    parts.back().regions.push_back(region);
    parts.back().bytes += bytes;
  });
  return parts;
}

uint64_t largestPart(const std::vector<ImagePart>& parts) {
  uint64_t most = 4;
  for (const ImagePart& part : parts) most = std::max(most, part.bytes);
  return most;
}

}  // namespace

VKAPI_ATTR void VKAPI_CALL GpuCommands::freeCommands(PoolOfDevice parent, VkCommandBuffer commands, const VkAllocationCallbacks*) {
  vkFreeCommandBuffers(parent.device, parent.pool, 1, &commands);
}

GpuCommands::GpuCommands(const GpuDevice& gpu) : gpu_(gpu) {
  VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  info.commandPool = gpu.commandPool();
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  VK_CHECK(vkAllocateCommandBuffers(gpu.handle(), &info, &commands));
  commands_ = {{gpu.handle(), gpu.commandPool()}, commands, freeCommands};
  if (gpu.timestampPeriodNs() > 0.0f) {
    VkQueryPoolCreateInfo pool{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    pool.queryType = VK_QUERY_TYPE_TIMESTAMP;
    pool.queryCount = 2 * kMostPasses;
    queries_ = gpu.make(pool, "timestamps");
  }
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  VK_CHECK(vkBeginCommandBuffer(commands, &begin));
  if (queries_) vkCmdResetQueryPool(commands, queries_.get(), 0, 2 * kMostPasses);
}

void GpuCommands::barrier() {
  VkMemoryBarrier2 memory{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  memory.srcStageMask = memory.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  memory.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  memory.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.memoryBarrierCount = 1;
  info.pMemoryBarriers = &memory;
  vkCmdPipelineBarrier2(handle(), &info);
}

void GpuCommands::layout(const GpuImage& image, VkImageLayout from, VkImageLayout to) {
  VkImageMemoryBarrier2 memory{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  memory.srcStageMask = memory.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  memory.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  memory.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  memory.oldLayout = from;
  memory.newLayout = to;
  memory.srcQueueFamilyIndex = memory.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  memory.image = image.handle();
  memory.subresourceRange = {image.shape().aspect, 0, image.shape().levels, 0, image.shape().layers};
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.imageMemoryBarrierCount = 1;
  info.pImageMemoryBarriers = &memory;
  vkCmdPipelineBarrier2(handle(), &info);
}

// A barrier right behind each timestamp keeps values from shifting by one dispatch on lavapipe.
void GpuCommands::pass(const std::string& name, const std::function<void()>& body) {
  GpuLabel label(gpu_, handle(), name);
  bool timed = queries_ && passes_.size() < kMostPasses;
  if (timed) {
    vkCmdWriteTimestamp2(handle(), VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_.get(), uint32_t(2 * passes_.size()));
    barrier();
  }
  body();
  barrier();
  if (timed) {
    vkCmdWriteTimestamp2(handle(), VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_.get(), uint32_t(2 * passes_.size() + 1));
    barrier();
    passes_.push_back(name);
  }
}

PassTimes GpuCommands::run() {
  VK_CHECK(vkEndCommandBuffer(handle()));
  VkFenceCreateInfo fenceInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  Owned<VkFence> done = gpu_.make(fenceInfo, "commands done");
  VkCommandBufferSubmitInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  commands.commandBuffer = handle();
  VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  submit.commandBufferInfoCount = 1;
  submit.pCommandBufferInfos = &commands;
  VK_CHECK(vkQueueSubmit2(gpu_.queue(), 1, &submit, done.get()));
  const VkResult waited = vkWaitForFences(gpu_.handle(), 1, done.address(), VK_TRUE, UINT64_MAX);
  if (waited != VK_SUCCESS) vkQueueWaitIdle(gpu_.queue());  // nothing that the commands use may go while they run
  checkVulkan(waited, "vkWaitForFences");

  PassTimes times;
  if (passes_.empty()) return times;
  std::vector<uint64_t> ticks(2 * passes_.size());
  VK_CHECK(vkGetQueryPoolResults(gpu_.handle(), queries_.get(), 0, uint32_t(ticks.size()), ticks.size() * sizeof(uint64_t), ticks.data(),
                                 sizeof(uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT));
  for (size_t i = 0; i < passes_.size(); ++i)
    times[passes_[i]] += double(ticks[2 * i + 1] - ticks[2 * i]) * gpu_.timestampPeriodNs() * 1e-6;
  return times;
}

void uploadBytes(const GpuDevice& gpu, const GpuBuffer& target, std::span<const std::byte> bytes, uint64_t offset) {
  CHECK_LE(offset + bytes.size(), target.byteCount());
  if (bytes.empty()) return;
  GpuBuffer staging(gpu, "upload", std::min<uint64_t>(bytes.size(), kCopyBytes), BufferMemory::upload);
  for (uint64_t done = 0; done < bytes.size(); done += kCopyBytes) {
    uint64_t part = std::min<uint64_t>(kCopyBytes, bytes.size() - done);
    std::memcpy(staging.mapped(), bytes.data() + done, part);
    GpuCommands commands(gpu);
    VkBufferCopy region{0, offset + done, part};
    vkCmdCopyBuffer(commands.handle(), staging.handle(), target.handle(), 1, &region);
    commands.barrier();
    commands.run();
  }
}

void downloadBytes(const GpuDevice& gpu, const GpuBuffer& source, std::span<std::byte> bytes, uint64_t offset) {
  CHECK_LE(offset + bytes.size(), source.byteCount());
  if (bytes.empty()) return;
  GpuBuffer staging(gpu, "download", std::min<uint64_t>(bytes.size(), kCopyBytes), BufferMemory::readback);
  for (uint64_t done = 0; done < bytes.size(); done += kCopyBytes) {
    uint64_t part = std::min<uint64_t>(kCopyBytes, bytes.size() - done);
    GpuCommands commands(gpu);
    commands.barrier();
    VkBufferCopy region{offset + done, 0, part};
    vkCmdCopyBuffer(commands.handle(), source.handle(), staging.handle(), 1, &region);
    commands.barrier();
    commands.run();
    std::memcpy(bytes.data() + done, staging.mapped(), part);
  }
}

void uploadImage(const GpuDevice& gpu, const GpuImage& target, std::span<const std::byte> bytes) {
  std::vector<ImagePart> parts = imageParts(target.shape());
  GpuBuffer staging(gpu, "upload", largestPart(parts), BufferMemory::upload);
  for (const ImagePart& part : parts) {
    CHECK_LE(part.begin + part.bytes, bytes.size());
    std::memcpy(staging.mapped(), bytes.data() + part.begin, part.bytes);
    GpuCommands commands(gpu);
    commands.barrier();
    vkCmdCopyBufferToImage(commands.handle(), staging.handle(), target.handle(), VK_IMAGE_LAYOUT_GENERAL, uint32_t(part.regions.size()),
                           part.regions.data());
    commands.barrier();
    commands.run();
  }
}

void downloadImage(const GpuDevice& gpu, const GpuImage& source, std::span<std::byte> bytes) {
  std::vector<ImagePart> parts = imageParts(source.shape());
  GpuBuffer staging(gpu, "download", largestPart(parts), BufferMemory::readback);
  for (const ImagePart& part : parts) {
    CHECK_LE(part.begin + part.bytes, bytes.size());
    GpuCommands commands(gpu);
    commands.barrier();
    vkCmdCopyImageToBuffer(commands.handle(), source.handle(), VK_IMAGE_LAYOUT_GENERAL, staging.handle(), uint32_t(part.regions.size()),
                           part.regions.data());
    commands.barrier();
    commands.run();
    std::memcpy(bytes.data() + part.begin, staging.mapped(), part.bytes);
  }
}

}  // namespace gridscope
