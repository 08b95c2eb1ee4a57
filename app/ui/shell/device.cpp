// See device.h.
#include "app/ui/shell/device.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdio>
#include <vector>

namespace gridscope {

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  if (severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT) {
    std::fprintf(stderr, "validation (window): %s\n", data->pMessage);
    ++*static_cast<std::atomic<uint32_t>*>(user);
  }
  return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(std::atomic<uint32_t>& counter) {
  VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  info.pfnUserCallback = onMessage;
  info.pUserData = &counter;
  return info;
}

}  // namespace

void WindowVulkan::loadInstance(VkInstance instance) {
#define WINDOW_LOAD(name) name = reinterpret_cast<PFN_vk##name>(GetInstanceProcAddr(instance, "vk" #name));
  WINDOW_INSTANCE_FUNCTIONS(WINDOW_LOAD)
#undef WINDOW_LOAD
}

void WindowVulkan::loadDevice(VkDevice device) {
#define WINDOW_LOAD(name) name = reinterpret_cast<PFN_vk##name>(GetDeviceProcAddr(device, "vk" #name));
  WINDOW_DEVICE_FUNCTIONS(WINDOW_LOAD)
#undef WINDOW_LOAD
}

WindowDevice::WindowDevice(GLFWwindow* window, bool validation) {
  if (!glfwVulkanSupported())
    throw Error("the window needs a Vulkan driver that can show pictures; 'gridscope info' lists the devices", kExitDevice);
  createInstance(validation);
  VK_CHECK(glfwCreateWindowSurface(instance_, window, nullptr, &surface_));
  chooseDevice();
  createDevice();
}

WindowDevice::~WindowDevice() {
  if (device_) vulkan_.DestroyDevice(device_, nullptr);
  if (surface_) vulkan_.DestroySurfaceKHR(instance_, surface_, nullptr);
  if (messenger_)
    reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(vulkan_.GetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"))(
        instance_, messenger_, nullptr);
  if (instance_) vulkan_.DestroyInstance(instance_, nullptr);
}

std::string WindowDevice::whyNone() {
  const std::string none = "no Vulkan device can show pictures on this display";
  if (!glfwVulkanSupported()) return none;
  try {
    WindowDevice probe;
    probe.createInstance(false);
    uint32_t count = 0;
    VK_CHECK(probe.vulkan_.EnumeratePhysicalDevices(probe.instance_, &count, nullptr));
    std::vector<VkPhysicalDevice> devices(count);
    VK_CHECK(probe.vulkan_.EnumeratePhysicalDevices(probe.instance_, &count, devices.data()));
    for (VkPhysicalDevice device : devices) {
      uint32_t families = 0;
      probe.vulkan_.GetPhysicalDeviceQueueFamilyProperties(device, &families, nullptr);
      for (uint32_t family = 0; family < families; ++family)
        if (glfwGetPhysicalDevicePresentationSupport(probe.instance_, device, family)) return "";
    }
  } catch (const Error& error) {
    return none + " (" + error.what() + ")";
  }
  return none;
}

void WindowDevice::createInstance(bool validation) {
  vulkan_.GetInstanceProcAddr = reinterpret_cast<PFN_vkGetInstanceProcAddr>(glfwGetInstanceProcAddress(nullptr, "vkGetInstanceProcAddr"));
  uint32_t count = 0;
  const char** required = glfwGetRequiredInstanceExtensions(&count);
  std::vector<const char*> extensions(required, required + count);

  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "gridscope";
  application.apiVersion = VK_API_VERSION_1_2;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  VkValidationFeatureEnableEXT synchronization = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = &synchronization;
  VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(validationMessages_);
  if (validation) {
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &kValidationLayer;
    info.pNext = &features;
    features.pNext = &messenger;
  }
  info.enabledExtensionCount = uint32_t(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  auto create = reinterpret_cast<PFN_vkCreateInstance>(vulkan_.GetInstanceProcAddr(nullptr, "vkCreateInstance"));
  const VkResult result = create(&info, nullptr, &instance_);
  if (result == VK_ERROR_LAYER_NOT_PRESENT) throw Error("--validation: Vulkan's validation layers are not installed", kExitDevice);
  checkVulkan(result, "vkCreateInstance");
  vulkan_.loadInstance(instance_);
  if (!validation) return;
  auto createMessenger =
      reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(vulkan_.GetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
  messenger = messengerInfo(validationMessages_);
  VK_CHECK(createMessenger(instance_, &messenger, nullptr, &messenger_));
}

// The first device that can draw and present; hardware before software.
void WindowDevice::chooseDevice() {
  uint32_t count = 0;
  VK_CHECK(vulkan_.EnumeratePhysicalDevices(instance_, &count, nullptr));
  std::vector<VkPhysicalDevice> devices(count);
  VK_CHECK(vulkan_.EnumeratePhysicalDevices(instance_, &count, devices.data()));
  bool software = true;
  for (VkPhysicalDevice device : devices) {
    VkPhysicalDeviceProperties properties;
    vulkan_.GetPhysicalDeviceProperties(device, &properties);
    uint32_t families = 0;
    vulkan_.GetPhysicalDeviceQueueFamilyProperties(device, &families, nullptr);
    std::vector<VkQueueFamilyProperties> queues(families);
    vulkan_.GetPhysicalDeviceQueueFamilyProperties(device, &families, queues.data());
    for (uint32_t family = 0; family < families; ++family) {
      VkBool32 presents = VK_FALSE;
      vulkan_.GetPhysicalDeviceSurfaceSupportKHR(device, family, surface_, &presents);
      if (!presents || !(queues[family].queueFlags & VK_QUEUE_GRAPHICS_BIT)) continue;
      const bool isSoftware = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
      if (physicalDevice_ && !(software && !isSoftware)) continue;
      physicalDevice_ = device;
      queueFamily_ = family;
      software = isSoftware;
      break;
    }
  }
  if (!physicalDevice_) throw Error("no Vulkan device can show pictures on this display; render with: gridscope render SCENE", kExitDevice);
}

void WindowDevice::createDevice() {
  const float priority = 1.0f;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = queueFamily_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  const char* extension = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = 1;
  info.ppEnabledExtensionNames = &extension;
  VK_CHECK(vulkan_.CreateDevice(physicalDevice_, &info, nullptr, &device_));
  vulkan_.loadDevice(device_);
  vulkan_.GetDeviceQueue(device_, queueFamily_, 0, &queue_);
}

uint32_t WindowDevice::memoryType(uint32_t typeBits, VkMemoryPropertyFlags properties) const {
  VkPhysicalDeviceMemoryProperties memory;
  vulkan_.GetPhysicalDeviceMemoryProperties(physicalDevice_, &memory);
  for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
    if ((typeBits & (1u << i)) && (memory.memoryTypes[i].propertyFlags & properties) == properties) return i;
  throw Error("the window's device has no memory of the kind that is needed", kExitDevice);
}

void WindowDevice::waitIdle() const { VK_CHECK(vulkan_.DeviceWaitIdle(device_)); }

}  // namespace gridscope
