// The Vulkan functions that the window uses, in a table of its own: core's are volk's globals and belong to the worker thread's instance.
#pragma once

#include "core/gpu/vulkan.h"

namespace gridscope {

#define WINDOW_INSTANCE_FUNCTIONS(take)                                                                                                   \
  take(DestroyInstance) take(EnumeratePhysicalDevices) take(GetPhysicalDeviceProperties) take(GetPhysicalDeviceQueueFamilyProperties)     \
      take(GetPhysicalDeviceMemoryProperties) take(GetPhysicalDeviceSurfaceSupportKHR) take(GetPhysicalDeviceSurfaceCapabilitiesKHR)      \
          take(GetPhysicalDeviceSurfaceFormatsKHR) take(GetPhysicalDeviceSurfacePresentModesKHR) take(EnumerateDeviceExtensionProperties) \
              take(CreateDevice) take(GetDeviceProcAddr) take(DestroySurfaceKHR)

#define WINDOW_DEVICE_FUNCTIONS(take)                                                                                                      \
  take(DestroyDevice) take(GetDeviceQueue) take(DeviceWaitIdle) take(QueueSubmit) take(QueuePresentKHR) take(CreateSwapchainKHR)           \
      take(DestroySwapchainKHR) take(GetSwapchainImagesKHR) take(AcquireNextImageKHR) take(CreateImageView) take(DestroyImageView)         \
          take(CreateRenderPass) take(DestroyRenderPass) take(CreateFramebuffer) take(DestroyFramebuffer) take(CreateCommandPool)          \
              take(DestroyCommandPool) take(ResetCommandPool) take(AllocateCommandBuffers) take(BeginCommandBuffer) take(EndCommandBuffer) \
                  take(CreateFence) take(DestroyFence) take(WaitForFences) take(ResetFences) take(CreateSemaphore) take(DestroySemaphore)  \
                      take(CreateBuffer) take(DestroyBuffer) take(GetBufferMemoryRequirements) take(CreateImage) take(DestroyImage)        \
                          take(GetImageMemoryRequirements) take(AllocateMemory) take(FreeMemory) take(BindBufferMemory)                    \
                              take(BindImageMemory) take(MapMemory) take(UnmapMemory) take(CreateSampler) take(DestroySampler)             \
                                  take(CreateDescriptorSetLayout) take(DestroyDescriptorSetLayout) take(CreateDescriptorPool)              \
                                      take(DestroyDescriptorPool) take(AllocateDescriptorSets) take(FreeDescriptorSets)                    \
                                          take(UpdateDescriptorSets) take(CreatePipelineLayout) take(DestroyPipelineLayout)                \
                                              take(CreateShaderModule) take(DestroyShaderModule) take(CreateGraphicsPipelines)             \
                                                  take(DestroyPipeline) take(CmdBeginRenderPass) take(CmdEndRenderPass)                    \
                                                      take(CmdPipelineBarrier) take(CmdCopyBufferToImage) take(CmdCopyImageToBuffer)       \
                                                          take(CmdBindPipeline) take(CmdBindDescriptorSets) take(CmdPushConstants)         \
                                                              take(CmdSetViewport) take(CmdSetScissor) take(CmdDraw)

// Null until the instance or the device is made.
struct WindowVulkan {
  PFN_vkGetInstanceProcAddr GetInstanceProcAddr = nullptr;
#define WINDOW_MEMBER(name) PFN_vk##name name = nullptr;
  WINDOW_INSTANCE_FUNCTIONS(WINDOW_MEMBER)
  WINDOW_DEVICE_FUNCTIONS(WINDOW_MEMBER)
#undef WINDOW_MEMBER

  void loadInstance(VkInstance instance);
  void loadDevice(VkDevice device);
};

}  // namespace gridscope
