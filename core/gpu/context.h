// The Vulkan device: choosing one, what it can and can't do for us, and the queue that everything runs on.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <volk.h>

#include "core/base/error.h"
#include "core/grid/derive.h"

namespace gridscope {

// What a device can do for us.
struct DeviceReport {
  std::string name;
  std::string driver;               // name and version
  uint32_t apiVersion = 0;          // VK_MAKE_API_VERSION
  bool softwareDevice = false;      // runs on the CPU's cores (lavapipe)
  bool geometryStage = false;       // geometry shaders with stores: the raster builder
  bool imageAtomics = false;        // 3D r32ui storage image with atomics: required
  bool float64 = false;             // required for the same bits as everywhere
  bool scalarLayout = false;        // required
  bool descriptorIndexing = false;  // variable-count descriptor sets
  bool roundingControl = false;     // round to nearest even and signed zeros can be asked for
  bool timestamps = false;
  uint32_t maxImageSide = 0;   // texels of a 3D image
  uint64_t maxImageBytes = 0;  // of one r32ui 3D image
  uint64_t maxAllocationBytes = 0;
  uint64_t maxStorageBufferBytes = 0;
  uint64_t deviceMemoryBytes = 0;  // largest device-local heap
  uint32_t maxImageArrayLayers = 0;
  uint32_t maxImage2DSide = 0;
  std::string refusal;  // why it can't be used; empty: it can
};

struct GpuOptions {
  std::string device;       // name (part of it, any case) or index; empty: the first that can be used, GPUs before software
  bool validation = false;  // core and synchronization validation; messages are counted and printed
};

// All Vulkan devices of this machine, in the loader's order. Empty when there is no Vulkan loader or no driver.
std::vector<DeviceReport> listDevices();

class GpuContext {
 public:
  // Throws Error: kExitBadInput for an unknown name, kExitDevice when no device can be used.
  explicit GpuContext(const GpuOptions& options);
  ~GpuContext();
  GpuContext(const GpuContext&) = delete;
  GpuContext& operator=(const GpuContext&) = delete;

  const DeviceReport& report() const { return report_; }
  GridLimits gridLimits() const;
  VkDevice device() const { return device_; }
  VkQueue queue() const { return queue_; }
  uint32_t queueFamily() const { return queueFamily_; }
  VkCommandPool commandPool() const { return commandPool_; }
  VkPhysicalDevice physicalDevice() const { return physicalDevice_; }
  VkInstance instance() const { return instance_; }
  float timestampPeriodNs() const { return timestampPeriodNs_; }
  bool validated() const { return messenger_ != VK_NULL_HANDLE; }
  uint32_t validationMessages() const { return validationMessages_; }

  // Index of a memory type with these properties; throws when the device has none.
  uint32_t memoryType(uint32_t typeBits, VkMemoryPropertyFlags properties) const;
  // Names an object for debuggers and validation messages.
  void name(VkObjectType type, uint64_t handle, const std::string& text) const;

 private:
  void createInstance(bool validation);
  void createDevice();

  DeviceReport report_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  uint32_t queueFamily_ = 0;
  VkCommandPool commandPool_ = VK_NULL_HANDLE;
  float timestampPeriodNs_ = 0.0f;
  uint32_t validationMessages_ = 0;
};

// Text of a result, "VK_ERROR_DEVICE_LOST" say.
const char* resultName(VkResult result);

// Throws Error (kExitDevice) that names the call and its result.
void checkVulkan(VkResult result, const char* call);

}  // namespace gridscope

#define VK_CHECK(call) ::gridscope::checkVulkan((call), #call)
