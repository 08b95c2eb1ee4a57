// See vulkan.h.
#define VOLK_IMPLEMENTATION
#include "core/gpu/vulkan.h"

#include <cstring>
#include <mutex>

namespace gridscope {

bool loadVulkan() {
  static const bool ready = volkInitialize() == VK_SUCCESS;
  return ready;
}

void loadVulkanFunctions(VkInstance instance) {
  static std::once_flag loaded;
  std::call_once(loaded, [&] { volkLoadInstance(instance); });
}

const char* resultName(VkResult result) {
  switch (result) {
#define NAME(value) \
  case value: return #value
    NAME(VK_SUCCESS);
    NAME(VK_NOT_READY);
    NAME(VK_TIMEOUT);
    NAME(VK_ERROR_OUT_OF_HOST_MEMORY);
    NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY);
    NAME(VK_ERROR_OUT_OF_POOL_MEMORY);
    NAME(VK_ERROR_INITIALIZATION_FAILED);
    NAME(VK_ERROR_DEVICE_LOST);
    NAME(VK_ERROR_MEMORY_MAP_FAILED);
    NAME(VK_ERROR_LAYER_NOT_PRESENT);
    NAME(VK_ERROR_EXTENSION_NOT_PRESENT);
    NAME(VK_ERROR_FEATURE_NOT_PRESENT);
    NAME(VK_ERROR_INCOMPATIBLE_DRIVER);
    NAME(VK_ERROR_TOO_MANY_OBJECTS);
    NAME(VK_ERROR_FORMAT_NOT_SUPPORTED);
    NAME(VK_ERROR_FRAGMENTED_POOL);
    NAME(VK_ERROR_SURFACE_LOST_KHR);
    NAME(VK_ERROR_NATIVE_WINDOW_IN_USE_KHR);
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

}  // namespace gridscope
