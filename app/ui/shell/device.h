// The window's own Vulkan instance and device, which draw the interface and nothing else: the stages run on the worker's.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "app/ui/shell/vulkan.h"

struct GLFWwindow;

namespace gridscope {

class WindowDevice {
 public:
  // Throws Error (kExitDevice) when no device can show pictures in this window.
  WindowDevice(GLFWwindow* window, bool validation);
  ~WindowDevice();

  // Why no device can show pictures on this display; empty: one can. GLFW must be initialized.
  static std::string whyNone();
  WindowDevice(const WindowDevice&) = delete;
  WindowDevice& operator=(const WindowDevice&) = delete;

  const WindowVulkan& vulkan() const { return vulkan_; }
  VkInstance instance() const { return instance_; }
  VkSurfaceKHR surface() const { return surface_; }
  VkPhysicalDevice physicalDevice() const { return physicalDevice_; }
  VkDevice device() const { return device_; }
  VkQueue queue() const { return queue_; }
  uint32_t queueFamily() const { return queueFamily_; }
  uint32_t validationMessages() const { return validationMessages_; }

  // Index of a memory type with these properties; throws when the device has none.
  uint32_t memoryType(uint32_t typeBits, VkMemoryPropertyFlags properties) const;
  void waitIdle() const;

 private:
  WindowDevice() = default;
  void createInstance(bool validation);
  void chooseDevice();
  void createDevice();

  WindowVulkan vulkan_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  uint32_t queueFamily_ = 0;
  std::atomic<uint32_t> validationMessages_ = 0;
};

}  // namespace gridscope
