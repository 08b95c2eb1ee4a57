// A Vulkan instance: layers, and the messages of validation.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/gpu/vulkan.h"

namespace gridscope {

class GpuInstance {
 public:
  struct Request {
    bool validation = false;                       // core and synchronization validation; messages are counted and printed
    std::span<const char* const> extensions = {};  // needed beside those for debuggers
    const char* messagePrefix = "validation";      // of a printed message
  };

  // Throws Error (kExitDevice) where there is no loader, no driver, or no validation layer though it is asked for.
  explicit GpuInstance(const Request& request);
  GpuInstance(const GpuInstance&) = delete;
  GpuInstance& operator=(const GpuInstance&) = delete;

  VkInstance handle() const { return instance_.get(); }
  bool validated() const { return bool(messenger_); }
  bool debugUtils() const { return debugUtils_; }  // names and labels can be told to debuggers
  uint32_t validationMessages() const { return messages_.count; }
  std::vector<VkPhysicalDevice> physicalDevices() const;  // in the loader's order

 private:
  struct Messages {
    std::atomic<uint32_t> count = 0;
    const char* prefix = "";
  };
  static VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT types,
                                                  const VkDebugUtilsMessengerCallbackDataEXT* data, void* user);

  Messages messages_;  // outlives what tells of them
  bool debugUtils_ = false;
  Owned<VkInstance, NoParent> instance_;
  Owned<VkDebugUtilsMessengerEXT, VkInstance> messenger_;
};

}  // namespace gridscope
