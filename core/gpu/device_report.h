// What a physical device can do for us, and the features that are asked of it.
#pragma once

#include "core/gpu/context.h"
#include "core/gpu/vulkan.h"

namespace gridscope {

// Vulkan structures that are asked for in one chain, which begins at `core`.
struct DeviceFeatures {
  VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  DeviceFeatures() { core.pNext = &v12, v12.pNext = &v13; }
  DeviceFeatures(const DeviceFeatures&) = delete;
};

// One queue that does graphics and compute; -1: there is none.
int graphicsQueueFamily(VkPhysicalDevice device, uint32_t* timestampBits = nullptr);

DeviceReport reportDevice(VkPhysicalDevice device);

// The place of the device that is wanted (GpuOptions::device). Throws Error as GpuContext does.
size_t chooseDevice(const std::vector<DeviceReport>& reports, const std::string& wanted);

}  // namespace gridscope
