// See instance.h.
#include "core/gpu/instance.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "core/gpu/context.h"

namespace gridscope {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

std::atomic<uint32_t> messagesOfAll = 0;

bool hasLayer(const char* name) {
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(), [&](const auto& layer) { return !std::strcmp(layer.layerName, name); });
}

bool hasExtension(const char* name) {
  uint32_t count = 0;
  vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
  return std::any_of(extensions.begin(), extensions.end(), [&](const auto& e) { return !std::strcmp(e.extensionName, name); });
}

VKAPI_ATTR void VKAPI_CALL destroyInstance(NoParent, VkInstance instance, const VkAllocationCallbacks* callbacks) {
  vkDestroyInstance(instance, callbacks);
}

}  // namespace

uint32_t allValidationMessages() { return messagesOfAll; }

VKAPI_ATTR VkBool32 VKAPI_CALL GpuInstance::onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT,
                                                      const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  if (severity < VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT) return VK_FALSE;
  Messages& messages = *static_cast<Messages*>(user);
  ++messages.count;
  ++messagesOfAll;
  std::fprintf(stderr, "%s: %s\n", messages.prefix, data->pMessage);
  return VK_FALSE;
}

GpuInstance::GpuInstance(const Request& request) : messages_{.prefix = request.messagePrefix} {
  if (!loadVulkan()) throw Error("no Vulkan loader found: install libvulkan1", kExitDevice);
  if (request.validation && !hasLayer(kValidationLayer))
    throw Error("--validation: the validation layer is not installed (Debian: vulkan-validationlayers)", kExitDevice);
  debugUtils_ = hasExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  std::vector<const char*> extensions(request.extensions.begin(), request.extensions.end());
  if (debugUtils_) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

  // The messenger stands in the instance's own chain too: so it hears of the instance's making and end.
  VkDebugUtilsMessengerCreateInfoEXT messenger{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  messenger.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;  // performance hints are not errors: the grid stays in one layout
  messenger.pfnUserCallback = onMessage;
  messenger.pUserData = &messages_;
  VkValidationFeatureEnableEXT enables[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT, &messenger};
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = enables;

  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "gridscope";
  application.apiVersion = kVulkanVersion;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  info.enabledExtensionCount = uint32_t(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  if (request.validation) {
    info.pNext = &features;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &kValidationLayer;
  }
  VkInstance instance = VK_NULL_HANDLE;
  VK_CHECK(vkCreateInstance(&info, nullptr, &instance));
  loadVulkanFunctions(instance);
  instance_ = {NoParent{}, instance, destroyInstance};
  if (!request.validation) return;

  VkDebugUtilsMessengerEXT made = VK_NULL_HANDLE;
  VK_CHECK(vkCreateDebugUtilsMessengerEXT(instance, &messenger, nullptr, &made));
  messenger_ = {instance, made, vkDestroyDebugUtilsMessengerEXT};
}

std::vector<VkPhysicalDevice> GpuInstance::physicalDevices() const {
  uint32_t count = 0;
  vkEnumeratePhysicalDevices(handle(), &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(handle(), &count, devices.data());
  devices.resize(count);
  return devices;
}

}  // namespace gridscope
