// Vulkan as the rest of this folder sees it: its functions (volk), results as errors, and objects that end with their holder.
#pragma once

#include <utility>

#include <volk.h>

#include "core/base/error.h"

namespace gridscope {

inline constexpr uint32_t kVulkanVersion = VK_API_VERSION_1_3;  // that is asked for

// Finds the Vulkan loader, once for the process; false: there is none.
bool loadVulkan();
// Once for the process, from its first instance: the loader's entry points, which look at their handle to find its device and the layers of
// that device. Instances and devices on several threads share them; functions of one device alone would not do for another.
void loadVulkanFunctions(VkInstance instance);

// Text of a result, "VK_ERROR_DEVICE_LOST" say.
const char* resultName(VkResult result);

// Throws Error (kExitDevice) that names the call and its result, for results that are failures.
void checkVulkan(VkResult result, const char* call);

#define VK_CHECK(call) ::gridscope::checkVulkan((call), #call)

// A Vulkan object that is destroyed with its holder; move-only. Parent: what it was made from, which must outlive it. Nothing that throws
// may stand between the call that made the object and its Owned.
template <typename Handle, typename Parent = VkDevice>
class Owned {
 public:
  using Destroy = void(VKAPI_PTR*)(Parent, Handle, const VkAllocationCallbacks*);

  Owned() = default;
  Owned(Parent parent, Handle handle, Destroy destroy) : parent_(parent), handle_(handle), destroy_(destroy) {}
  Owned(Owned&& other) noexcept { swap(other); }
  Owned& operator=(Owned&& other) noexcept {
    Owned old(std::move(*this));
    swap(other);
    return *this;
  }
  ~Owned() {
    if (handle_) destroy_(parent_, handle_, nullptr);
  }

  Handle get() const { return handle_; }
  const Handle* address() const { return &handle_; }  // for calls that take a list
  explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }

 private:
  void swap(Owned& other) noexcept {
    std::swap(parent_, other.parent_);
    std::swap(handle_, other.handle_);
    std::swap(destroy_, other.destroy_);
  }

  Parent parent_{};
  Handle handle_ = VK_NULL_HANDLE;
  Destroy destroy_ = nullptr;
};

// The parent of what has none.
struct NoParent {};

// How the object that a structure describes is made and destroyed, and what debuggers call its type.
template <typename Info>
struct VulkanKind;

#define VULKAN_KIND(Name, TYPE)                                 \
  template <>                                                   \
  struct VulkanKind<Vk##Name##CreateInfo> {                     \
    using Handle = Vk##Name;                                    \
    static constexpr auto create = &vkCreate##Name;             \
    static constexpr auto destroy = &vkDestroy##Name;           \
    static constexpr VkObjectType type = VK_OBJECT_TYPE_##TYPE; \
    static constexpr const char* call = "vkCreate" #Name;       \
  };
VULKAN_KIND(Buffer, BUFFER)
VULKAN_KIND(CommandPool, COMMAND_POOL)
VULKAN_KIND(DescriptorPool, DESCRIPTOR_POOL)
VULKAN_KIND(DescriptorSetLayout, DESCRIPTOR_SET_LAYOUT)
VULKAN_KIND(Fence, FENCE)
VULKAN_KIND(Framebuffer, FRAMEBUFFER)
VULKAN_KIND(Image, IMAGE)
VULKAN_KIND(ImageView, IMAGE_VIEW)
VULKAN_KIND(PipelineLayout, PIPELINE_LAYOUT)
VULKAN_KIND(QueryPool, QUERY_POOL)
VULKAN_KIND(RenderPass, RENDER_PASS)
VULKAN_KIND(Sampler, SAMPLER)
VULKAN_KIND(Semaphore, SEMAPHORE)
VULKAN_KIND(ShaderModule, SHADER_MODULE)
#undef VULKAN_KIND

}  // namespace gridscope
