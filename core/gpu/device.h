// A Vulkan device with its one queue, and how objects are made on it: named at creation, owned from then on.
#pragma once

#include <string>

#include "core/gpu/device_report.h"
#include "core/gpu/instance.h"

namespace gridscope {

class GpuDevice {
 public:
  struct Request {
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    uint32_t queueFamily = 0;
    const void* features = nullptr;  // VkDeviceCreateInfo::pNext
    std::span<const char* const> extensions = {};
  };

  // `instance` must outlive the device. Throws Error (kExitDevice) when the driver refuses.
  GpuDevice(const GpuInstance& instance, const Request& request);
  ~GpuDevice();
  GpuDevice(const GpuDevice&) = delete;
  GpuDevice& operator=(const GpuDevice&) = delete;

  VkDevice handle() const { return device_.get(); }
  VkQueue queue() const { return queue_; }
  uint32_t queueFamily() const { return queueFamily_; }
  VkPhysicalDevice physicalDevice() const { return physicalDevice_; }
  VkCommandPool commandPool() const { return commandPool_.get(); }
  const GpuInstance& instance() const { return instance_; }
  const DeviceReport& report() const { return report_; }
  float timestampPeriodNs() const { return timestampPeriodNs_; }  // 0: the queue has no timestamps

  // The object that `info` describes. Throws Error when the device has no room for it.
  template <typename Info>
  Owned<typename VulkanKind<Info>::Handle> make(const Info& info, const std::string& objectName) const {
    using Kind = VulkanKind<Info>;
    typename Kind::Handle made = VK_NULL_HANDLE;
    checkVulkan((*Kind::create)(handle(), &info, nullptr, &made), Kind::call);
    Owned<typename Kind::Handle> owned(handle(), made, *Kind::destroy);
    name(Kind::type, made, objectName);
    return owned;
  }

  // Memory for an object. Throws Error that names it when the device has none left.
  Owned<VkDeviceMemory> allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties, const std::string& objectName) const;

  // Names an object for debuggers and validation messages.
  template <typename Handle>
  void name(VkObjectType type, Handle object, const std::string& text) const {
    nameObject(type, uint64_t(object), text);
  }

  // A label around what is recorded between the two, for debuggers.
  void beginLabel(VkCommandBuffer commands, const std::string& text) const;
  void endLabel(VkCommandBuffer commands) const;

 private:
  void nameObject(VkObjectType type, uint64_t object, const std::string& text) const;
  // Index of a memory type with these properties; throws when the device has none.
  uint32_t memoryType(uint32_t typeBits, VkMemoryPropertyFlags properties) const;

  const GpuInstance& instance_;
  VkPhysicalDevice physicalDevice_;
  uint32_t queueFamily_;
  DeviceReport report_;
  float timestampPeriodNs_ = 0.0f;
  Owned<VkDevice, NoParent> device_;
  VkQueue queue_ = VK_NULL_HANDLE;
  Owned<VkCommandPool> commandPool_;
};

}  // namespace gridscope
