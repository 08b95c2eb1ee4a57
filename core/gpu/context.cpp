// See context.h.
#define VOLK_IMPLEMENTATION
#include "core/gpu/context.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <mutex>
#include <span>

namespace gridscope {
namespace {

constexpr uint32_t kApiVersion = VK_API_VERSION_1_3;

// Vulkan structures that are asked for in one chain.
struct Features {
  VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  Features() { core.pNext = &v12, v12.pNext = &v13; }
  Features(const Features&) = delete;
};

bool loaderReady() {
  static const bool ready = volkInitialize() == VK_SUCCESS;
  return ready;
}

// Once for the process, from its first instance: the loader's entry points, which look at their handle to find its device and the layers
// of that device. Contexts on several threads share them; functions of one device alone would not do for another.
void loadFunctions(VkInstance instance) {
  static std::once_flag loaded;
  std::call_once(loaded, [&] { volkLoadInstance(instance); });
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

bool hasLayer(const char* name) {
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(), [&](const auto& layer) { return !std::strcmp(layer.layerName, name); });
}

bool hasInstanceExtension(const char* name) {
  uint32_t count = 0;
  vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
  return std::any_of(extensions.begin(), extensions.end(), [&](const auto& e) { return !std::strcmp(e.extensionName, name); });
}

std::vector<VkPhysicalDevice> physicalDevices(VkInstance instance) {
  uint32_t count = 0;
  vkEnumeratePhysicalDevices(instance, &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(instance, &count, devices.data());
  devices.resize(count);
  return devices;
}

// One queue that does graphics and compute.
int graphicsQueueFamily(VkPhysicalDevice device, uint32_t* timestampBits = nullptr) {
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

// The first thing that is missing, for a person.
std::string findRefusal(const DeviceReport& report, const Features& features, int queueFamily) {
  if (report.apiVersion < kApiVersion) return "it offers Vulkan below 1.3; update its driver";
  if (queueFamily < 0) return "it has no queue for graphics and compute";
  if (!report.imageAtomics) return "it has no atomics on 3D r32ui storage images";
  if (!report.float64) return "it has no 64-bit floats, without which results are not the same bits as elsewhere";
  if (!report.scalarLayout) return "it has no scalar block layout";
  if (!features.v13.dynamicRendering || !features.v13.synchronization2) return "it has no dynamic rendering or synchronization2";
  return "";
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
  report.softwareDevice = properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  report.maxImageSide = limits.maxImageDimension3D;
  report.maxImage2DSide = limits.maxImageDimension2D;
  report.maxImageArrayLayers = limits.maxImageArrayLayers;
  report.maxStorageBufferBytes = limits.maxStorageBufferRange;
  report.maxAllocationBytes = maintenance.maxMemoryAllocationSize;
  report.roundingControl = floats.shaderRoundingModeRTEFloat32 && floats.shaderSignedZeroInfNanPreserveFloat32;

  Features features;
  if (report.apiVersion >= kApiVersion) vkGetPhysicalDeviceFeatures2(device, &features.core);
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

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  if (severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT) {
    ++*static_cast<uint32_t*>(user);
    std::fprintf(stderr, "validation: %s\n", data->pMessage);
  }
  return VK_FALSE;
}

// `layers`, `next`: of validation.
VkInstance makeInstance(std::span<const char* const> layers = {}, const void* next = nullptr) {
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "gridscope";
  application.apiVersion = kApiVersion;
  std::vector<const char*> extensions;
  if (hasInstanceExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME)) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pNext = next;
  info.pApplicationInfo = &application;
  info.enabledExtensionCount = uint32_t(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  info.enabledLayerCount = uint32_t(layers.size());
  info.ppEnabledLayerNames = layers.data();
  VkInstance instance = VK_NULL_HANDLE;
  VK_CHECK(vkCreateInstance(&info, nullptr, &instance));
  loadFunctions(instance);
  return instance;
}

// The chosen device's place in the loader's order.
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

}  // namespace

const char* resultName(VkResult result) {
  switch (result) {
#define NAME(value) \
  case value: return #value
    NAME(VK_SUCCESS);
    NAME(VK_NOT_READY);
    NAME(VK_TIMEOUT);
    NAME(VK_ERROR_OUT_OF_HOST_MEMORY);
    NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY);
    NAME(VK_ERROR_INITIALIZATION_FAILED);
    NAME(VK_ERROR_DEVICE_LOST);
    NAME(VK_ERROR_MEMORY_MAP_FAILED);
    NAME(VK_ERROR_LAYER_NOT_PRESENT);
    NAME(VK_ERROR_EXTENSION_NOT_PRESENT);
    NAME(VK_ERROR_FEATURE_NOT_PRESENT);
    NAME(VK_ERROR_INCOMPATIBLE_DRIVER);
    NAME(VK_ERROR_FORMAT_NOT_SUPPORTED);
    NAME(VK_ERROR_SURFACE_LOST_KHR);
    NAME(VK_ERROR_OUT_OF_DATE_KHR);
    NAME(VK_SUBOPTIMAL_KHR);
#undef NAME
    default: return "an unknown result";
  }
}

void checkVulkan(VkResult result, const char* call) {
  if (result >= 0) return;
  std::string name(call, std::strcspn(call, "("));
  std::string advice = result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY
                           ? "; take fewer --cells or a smaller --capacity"
                           : "";
  throw Error(name + " failed with " + resultName(result) + advice, kExitDevice);
}

std::vector<DeviceReport> listDevices() {
  if (!loaderReady()) return {};
  VkInstance instance = VK_NULL_HANDLE;
  try {
    instance = makeInstance();
  } catch (const Error&) {
    return {};  // a loader without a driver
  }
  std::vector<DeviceReport> reports;
  for (VkPhysicalDevice device : physicalDevices(instance)) reports.push_back(reportDevice(device));
  vkDestroyInstance(instance, nullptr);
  return reports;
}

GpuContext::GpuContext(const GpuOptions& options) {
  if (!loaderReady()) throw Error("no Vulkan loader found: install libvulkan1", kExitDevice);
  createInstance(options.validation);
  std::vector<VkPhysicalDevice> devices = physicalDevices(instance_);
  std::vector<DeviceReport> reports;
  for (VkPhysicalDevice device : devices) reports.push_back(reportDevice(device));
  size_t chosen = chooseDevice(reports, options.device);
  physicalDevice_ = devices[chosen];
  report_ = reports[chosen];
  createDevice();
}

void GpuContext::createInstance(bool validation) {
  // Core and synchronization validation.
  const char* layer = "VK_LAYER_KHRONOS_validation";
  VkValidationFeatureEnableEXT enables[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = enables;
  if (validation && !hasLayer(layer))
    throw Error("--validation: the validation layer is not installed (Debian: vulkan-validationlayers)", kExitDevice);
  instance_ = validation ? makeInstance(std::span(&layer, 1), &features) : makeInstance();

  if (validation) {
    VkDebugUtilsMessengerCreateInfoEXT messenger{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    messenger.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    messenger.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;  // performance hints are not errors: the grid stays in one layout
    messenger.pfnUserCallback = onMessage;
    messenger.pUserData = &validationMessages_;
    VK_CHECK(vkCreateDebugUtilsMessengerEXT(instance_, &messenger, nullptr, &messenger_));
  }
}

void GpuContext::createDevice() {
  queueFamily_ = uint32_t(graphicsQueueFamily(physicalDevice_));
  float priority = 1.0f;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = queueFamily_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;

  Features features;
  features.core.features.shaderFloat64 = VK_TRUE;
  features.core.features.fragmentStoresAndAtomics = VK_TRUE;
  features.core.features.geometryShader = report_.geometryStage;
  features.core.features.vertexPipelineStoresAndAtomics = report_.geometryStage;
  features.v12.scalarBlockLayout = VK_TRUE;
  features.v13.dynamicRendering = VK_TRUE;
  features.v13.synchronization2 = VK_TRUE;

  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = &features.core;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  VK_CHECK(vkCreateDevice(physicalDevice_, &info, nullptr, &device_));
  vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);

  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physicalDevice_, &properties);
  timestampPeriodNs_ = properties.limits.timestampPeriod;

  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  pool.queueFamilyIndex = queueFamily_;
  VK_CHECK(vkCreateCommandPool(device_, &pool, nullptr, &commandPool_));
}

GpuContext::~GpuContext() {
  if (device_) {
    vkDeviceWaitIdle(device_);
    vkDestroyCommandPool(device_, commandPool_, nullptr);
    vkDestroyDevice(device_, nullptr);
  }
  if (messenger_) vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
  if (instance_) vkDestroyInstance(instance_, nullptr);
}

GridLimits GpuContext::gridLimits() const {
  GridLimits limits;
  limits.maxImageSide = report_.maxImageSide;
  limits.maxImageBytes = std::min(report_.maxImageBytes, report_.maxAllocationBytes);
  limits.maxMemoryBytes = report_.deviceMemoryBytes;
  limits.device = report_.name.c_str();
  return limits;
}

uint32_t GpuContext::memoryType(uint32_t typeBits, VkMemoryPropertyFlags properties) const {
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physicalDevice_, &memory);
  for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
    if ((typeBits & (1u << i)) && (memory.memoryTypes[i].propertyFlags & properties) == properties) return i;
  throw Error(report_.name + " has no memory of the kind that is needed", kExitDevice);
}

void GpuContext::name(VkObjectType type, uint64_t handle, const std::string& text) const {
  if (!vkSetDebugUtilsObjectNameEXT || !messenger_) return;
  VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
  info.objectType = type;
  info.objectHandle = handle;
  info.pObjectName = text.c_str();
  vkSetDebugUtilsObjectNameEXT(device_, &info);
}

}  // namespace gridscope
