// Recording and running work: one command buffer, submitted and waited for; passes with a label and a timer of the same name; copies
// between host and device.
#pragma once

#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/gpu/resources.h"
#include "core/gpu/times.h"

namespace gridscope {

class GpuCommands {
 public:
  explicit GpuCommands(const GpuDevice& gpu);
  GpuCommands(const GpuCommands&) = delete;
  GpuCommands& operator=(const GpuCommands&) = delete;

  VkCommandBuffer handle() const { return commands_.get(); }

  // Makes everything before visible to everything after.
  void barrier();
  // Moves an image between layouts, and is a barrier.
  void layout(const GpuImage& image, VkImageLayout from, VkImageLayout to);
  // Runs `body` inside a label and between two timestamps. A barrier follows.
  void pass(const std::string& name, const std::function<void()>& body);

  // Submits, waits, and returns the times of the passes. Call once.
  PassTimes run();

 private:
  struct PoolOfDevice {
    VkDevice device = VK_NULL_HANDLE;
    VkCommandPool pool = VK_NULL_HANDLE;
  };
  static VKAPI_ATTR void VKAPI_CALL freeCommands(PoolOfDevice parent, VkCommandBuffer commands, const VkAllocationCallbacks*);

  const GpuDevice& gpu_;
  Owned<VkCommandBuffer, PoolOfDevice> commands_;
  Owned<VkQueryPool> queries_;
  std::vector<std::string> passes_;  // names, in order; pass k owns queries 2k and 2k + 1
};

// A label of this name around what is recorded while it lives.
class GpuLabel {
 public:
  GpuLabel(const GpuDevice& gpu, VkCommandBuffer commands, const std::string& text) : gpu_(gpu), commands_(commands) {
    gpu.beginLabel(commands, text);
  }
  ~GpuLabel() { gpu_.endLabel(commands_); }
  GpuLabel(const GpuLabel&) = delete;
  GpuLabel& operator=(const GpuLabel&) = delete;

 private:
  const GpuDevice& gpu_;
  VkCommandBuffer commands_;
};

// Copies `bytes` into a device buffer, in parts of at most 64 MiB.
void uploadBytes(const GpuDevice& gpu, const GpuBuffer& target, std::span<const std::byte> bytes, uint64_t offset = 0);
// Copies from a device buffer, in parts.
void downloadBytes(const GpuDevice& gpu, const GpuBuffer& source, std::span<std::byte> bytes, uint64_t offset = 0);

template <typename T>
void upload(const GpuDevice& gpu, const GpuBuffer& target, std::span<const T> values) {
  uploadBytes(gpu, target, std::as_bytes(values));
}
template <typename T>
std::vector<T> download(const GpuDevice& gpu, const GpuBuffer& source, size_t count) {
  std::vector<T> values(count);
  downloadBytes(gpu, source, std::as_writable_bytes(std::span(values)));
  return values;
}

// Copies between the texels of an image in the GENERAL layout (x fastest, then y, then z or layer) and the host, layer by layer.
void uploadImage(const GpuDevice& gpu, const GpuImage& target, std::span<const std::byte> bytes);
void downloadImage(const GpuDevice& gpu, const GpuImage& source, std::span<std::byte> bytes);

}  // namespace gridscope
