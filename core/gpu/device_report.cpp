// See device_report.h.
#include "core/gpu/device_report.h"

#include <algorithm>
#include <cctype>

namespace gridscope {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

// The first thing that is missing, for a person.
std::string findRefusal(const DeviceReport& report, const DeviceFeatures& features, int queueFamily) {
  if (report.apiVersion < kVulkanVersion) return "it offers Vulkan below 1.3; update its driver";
  if (queueFamily < 0) return "it has no queue for graphics and compute";
  if (!report.imageAtomics) return "it has no atomics on 3D r32ui storage images";
  if (!report.float64) return "it has no 64-bit floats, without which results are not the same bits as elsewhere";
  if (!report.scalarLayout) return "it has no scalar block layout";
  if (!features.v13.dynamicRendering || !features.v13.synchronization2) return "it has no dynamic rendering or synchronization2";
  return whyPassesDoNotFit(report.passLimits, report.geometryStage);
}

}  // namespace

int graphicsQueueFamily(VkPhysicalDevice device, uint32_t* timestampBits) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  for (uint32_t i = 0; i < count; ++i) {
    VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    if ((families[i].queueFlags & both) != both) continue;
    if (timestampBits) *timestampBits = families[i].timestampValidBits;
    return int(i);
  }
  return -1;
}

DeviceReport reportDevice(VkPhysicalDevice device) {
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceFloatControlsProperties floats{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FLOAT_CONTROLS_PROPERTIES, &driver};
  VkPhysicalDeviceMaintenance3Properties maintenance{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES, &floats};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &maintenance};
  vkGetPhysicalDeviceProperties2(device, &properties);
  const VkPhysicalDeviceLimits& limits = properties.properties.limits;

  DeviceReport report;
  report.name = properties.properties.deviceName;
  report.driver = std::string(driver.driverName) + " " + driver.driverInfo;
  report.apiVersion = properties.properties.apiVersion;
  const uint32_t version = report.apiVersion;
  report.apiVersionText = std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) + "." +
                          std::to_string(VK_API_VERSION_PATCH(version));
  report.softwareDevice = properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  report.maxImageSide = limits.maxImageDimension3D;
  report.maxImage2DSide = limits.maxImageDimension2D;
  report.maxImageArrayLayers = limits.maxImageArrayLayers;
  report.maxStorageBufferBytes = limits.maxStorageBufferRange;
  report.passLimits = {.maxPerStageDescriptorStorageBuffers = limits.maxPerStageDescriptorStorageBuffers,
                       .maxPerStageDescriptorStorageImages = limits.maxPerStageDescriptorStorageImages,
                       .maxPerStageDescriptorSampledImages = limits.maxPerStageDescriptorSampledImages,
                       .maxPerStageDescriptorSamplers = limits.maxPerStageDescriptorSamplers,
                       .maxPerStageResources = limits.maxPerStageResources,
                       .maxPushConstantsSize = limits.maxPushConstantsSize,
                       .maxComputeWorkGroupInvocations = limits.maxComputeWorkGroupInvocations};
  report.maxAllocationBytes = maintenance.maxMemoryAllocationSize;
  report.roundingControl = floats.shaderRoundingModeRTEFloat32 && floats.shaderSignedZeroInfNanPreserveFloat32;

  DeviceFeatures features;
  if (report.apiVersion >= kVulkanVersion) vkGetPhysicalDeviceFeatures2(device, &features.core);
  const VkPhysicalDeviceFeatures& core = features.core.features;
  report.geometryStage = core.geometryShader && core.vertexPipelineStoresAndAtomics;
  report.float64 = core.shaderFloat64;
  report.scalarLayout = features.v12.scalarBlockLayout;
  report.descriptorIndexing = features.v12.runtimeDescriptorArray && features.v12.descriptorBindingVariableDescriptorCount &&
                              features.v12.descriptorBindingPartiallyBound;

  VkFormatProperties format;
  vkGetPhysicalDeviceFormatProperties(device, VK_FORMAT_R32_UINT, &format);
  VkImageFormatProperties image{};
  VkResult result = vkGetPhysicalDeviceImageFormatProperties(
      device, VK_FORMAT_R32_UINT, VK_IMAGE_TYPE_3D, VK_IMAGE_TILING_OPTIMAL,
      VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, 0, &image);
  report.imageAtomics = result == VK_SUCCESS && (format.optimalTilingFeatures & VK_FORMAT_FEATURE_STORAGE_IMAGE_ATOMIC_BIT);
  if (result == VK_SUCCESS) {
    report.maxImageBytes = image.maxResourceSize;
    report.maxImageSide = std::min({image.maxExtent.width, image.maxExtent.height, image.maxExtent.depth});
  }

  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(device, &memory);
  for (uint32_t i = 0; i < memory.memoryHeapCount; ++i)
    if (memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
      report.deviceMemoryBytes = std::max<uint64_t>(report.deviceMemoryBytes, memory.memoryHeaps[i].size);

  uint32_t timestampBits = 0;
  int family = graphicsQueueFamily(device, &timestampBits);
  report.timestamps = timestampBits > 0 && limits.timestampPeriod > 0.0f;
  report.refusal = findRefusal(report, features, family);
  return report;
}

size_t chooseDevice(const std::vector<DeviceReport>& reports, const std::string& wanted) {
  std::string known;
  for (size_t i = 0; i < reports.size(); ++i) known += (i ? ", " : "") + std::to_string(i) + " (" + reports[i].name + ")";
  if (reports.empty()) throw Error("no Vulkan device found: install a driver (Debian: mesa-vulkan-drivers)", kExitDevice);

  if (wanted.empty()) {
    for (bool software : {false, true})
      for (size_t i = 0; i < reports.size(); ++i)
        if (reports[i].softwareDevice == software && reports[i].refusal.empty()) return i;
    throw Error("no Vulkan device can be used: " + reports[0].name + ": " + reports[0].refusal, kExitDevice);
  }

  size_t chosen = reports.size();
  bool isIndex = std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c); });
  if (isIndex && wanted.size() < 4) chosen = std::stoul(wanted);
  for (size_t i = 0; !isIndex && i < reports.size() && chosen == reports.size(); ++i)
    if (lower(reports[i].name).find(lower(wanted)) != std::string::npos) chosen = i;
  if (chosen >= reports.size()) throw Error("--device " + wanted + ": no such device; there are " + known + ", and cpu");
  if (!reports[chosen].refusal.empty())
    throw Error("--device " + wanted + ": " + reports[chosen].name + " can't be used: " + reports[chosen].refusal, kExitDevice);
  return chosen;
}

}  // namespace gridscope
