// See device.h.
#include "core/gpu/device.h"

namespace gridscope {
namespace {

VKAPI_ATTR void VKAPI_CALL destroyDevice(NoParent, VkDevice device, const VkAllocationCallbacks* callbacks) {
  vkDestroyDevice(device, callbacks);
}

}  // namespace

GpuDevice::GpuDevice(const GpuInstance& instance, const Request& request)
    : instance_(instance),
      physicalDevice_(request.physicalDevice),
      queueFamily_(request.queueFamily),
      report_(reportDevice(request.physicalDevice)) {
  float priority = 1.0f;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = queueFamily_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = request.features;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = uint32_t(request.extensions.size());
  info.ppEnabledExtensionNames = request.extensions.data();
  VkDevice device = VK_NULL_HANDLE;
  VK_CHECK(vkCreateDevice(physicalDevice_, &info, nullptr, &device));
  device_ = {NoParent{}, device, destroyDevice};
  name(VK_OBJECT_TYPE_DEVICE, device, report_.name);
  vkGetDeviceQueue(device, queueFamily_, 0, &queue_);
  name(VK_OBJECT_TYPE_QUEUE, queue_, "queue");

  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physicalDevice_, &properties);
  if (report_.timestamps) timestampPeriodNs_ = properties.limits.timestampPeriod;

  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  pool.queueFamilyIndex = queueFamily_;
  commandPool_ = make(pool, "commands");
}

GpuDevice::~GpuDevice() { vkDeviceWaitIdle(handle()); }

Owned<VkDeviceMemory> GpuDevice::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties,
                                          const std::string& objectName) const {
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = needs.size;
  info.memoryTypeIndex = memoryType(needs.memoryTypeBits, properties);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkResult result = vkAllocateMemory(handle(), &info, nullptr, &memory);
  if (result != VK_SUCCESS)
    throw Error(report_.name + " has no " + std::to_string(needs.size >> 20) + " MiB left for the " + objectName + " (" +
                    resultName(result) + "); take fewer --cells, a smaller --capacity or a smaller --size",
                kExitDevice);
  Owned<VkDeviceMemory> owned(handle(), memory, vkFreeMemory);
  name(VK_OBJECT_TYPE_DEVICE_MEMORY, memory, objectName);
  return owned;
}

uint32_t GpuDevice::memoryType(uint32_t typeBits, VkMemoryPropertyFlags properties) const {
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physicalDevice_, &memory);
  for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
    if ((typeBits & (1u << i)) && (memory.memoryTypes[i].propertyFlags & properties) == properties) return i;
  throw Error(report_.name + " has no memory of the kind that is needed", kExitDevice);
}

void GpuDevice::nameObject(VkObjectType type, uint64_t object, const std::string& text) const {
  if (!instance_.debugUtils()) return;
  VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
  info.objectType = type;
  info.objectHandle = object;
  info.pObjectName = text.c_str();
  vkSetDebugUtilsObjectNameEXT(handle(), &info);
}

void GpuDevice::beginLabel(VkCommandBuffer commands, const std::string& text) const {
  if (!instance_.debugUtils()) return;
  VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
  label.pLabelName = text.c_str();
  vkCmdBeginDebugUtilsLabelEXT(commands, &label);
}

void GpuDevice::endLabel(VkCommandBuffer commands) const {
  if (instance_.debugUtils()) vkCmdEndDebugUtilsLabelEXT(commands);
}

}  // namespace gridscope
