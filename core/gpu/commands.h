// Recording and running work: one command buffer, submitted and waited for; passes with a label and a timer of the same name; copies
// between host and device.
#pragma once

#include <cstring>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/gpu/resources.h"

namespace gridscope {

// GPU milliseconds by pass name; passes of one name add up.
using PassTimes = std::map<std::string, double>;

class GpuCommands {
 public:
  explicit GpuCommands(GpuContext& gpu);
  ~GpuCommands();
  GpuCommands(const GpuCommands&) = delete;
  GpuCommands& operator=(const GpuCommands&) = delete;

  VkCommandBuffer handle() const { return commands_; }

  // Makes everything before visible to everything after.
  void barrier();
  // Moves an image between layouts, and is a barrier.
  void layout(const GpuImage& image, VkImageLayout from, VkImageLayout to);
  // Runs `body` inside a label and between two timestamps. A barrier follows.
  void pass(const std::string& name, const std::function<void()>& body);

  // Submits, waits, and returns the times of the passes. Call once.
  PassTimes run();

 private:
  GpuContext& gpu_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkQueryPool queries_ = VK_NULL_HANDLE;
  std::vector<std::string> passes_;  // names, in order; pass k owns queries 2k and 2k + 1
};

// Copies `bytes` into a device buffer, in parts of at most 64 MiB.
void uploadBytes(GpuContext& gpu, const GpuBuffer& target, std::span<const std::byte> bytes, uint64_t offset = 0);
// Copies from a device buffer, in parts.
void downloadBytes(GpuContext& gpu, const GpuBuffer& source, std::span<std::byte> bytes, uint64_t offset = 0);

template <typename T>
void upload(GpuContext& gpu, const GpuBuffer& target, std::span<const T> values) {
  uploadBytes(gpu, target, std::as_bytes(values));
}
template <typename T>
std::vector<T> download(GpuContext& gpu, const GpuBuffer& source, size_t count) {
  std::vector<T> values(count);
  downloadBytes(gpu, source, std::as_writable_bytes(std::span(values)));
  return values;
}

// Copies between the texels of an image in the GENERAL layout (x fastest, then y, then z or layer) and the host, layer by layer.
void uploadImage(GpuContext& gpu, const GpuImage& target, std::span<const std::byte> bytes);
void downloadImage(GpuContext& gpu, const GpuImage& source, std::span<std::byte> bytes);

}  // namespace gridscope
