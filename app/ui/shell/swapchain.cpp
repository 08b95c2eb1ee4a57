// See swapchain.h.
#include "app/ui/shell/swapchain.h"

#include <algorithm>

namespace gridscope {

WindowSwapchain::WindowSwapchain(const WindowDevice& device) : device_(device), vk_(device.vulkan()) {
  chooseFormat();
  makeRenderPass();
  makeFlights();
}

WindowSwapchain::~WindowSwapchain() {
  vk_.DeviceWaitIdle(device_.device());
  destroyImages();
  if (swapchain_) vk_.DestroySwapchainKHR(device_.device(), swapchain_, nullptr);
  for (Flight& flight : flights_) {
    vk_.DestroySemaphore(device_.device(), flight.acquired, nullptr);
    vk_.DestroyFence(device_.device(), flight.done, nullptr);
    vk_.DestroyCommandPool(device_.device(), flight.pool, nullptr);
  }
  vk_.DestroyRenderPass(device_.device(), renderPass_, nullptr);
}

// Colours are sRGB values already: a format that encodes again would be wrong. Presenting need not wait for the display.
void WindowSwapchain::chooseFormat() {
  uint32_t count = 0;
  VK_CHECK(vk_.GetPhysicalDeviceSurfaceFormatsKHR(device_.physicalDevice(), device_.surface(), &count, nullptr));
  std::vector<VkSurfaceFormatKHR> formats(count);
  VK_CHECK(vk_.GetPhysicalDeviceSurfaceFormatsKHR(device_.physicalDevice(), device_.surface(), &count, formats.data()));
  format_ = formats.at(0);
  for (const VkSurfaceFormatKHR& format : formats)
    if (format.format == VK_FORMAT_B8G8R8A8_UNORM || format.format == VK_FORMAT_R8G8B8A8_UNORM) {
      format_ = format;
      break;
    }
  VK_CHECK(vk_.GetPhysicalDeviceSurfacePresentModesKHR(device_.physicalDevice(), device_.surface(), &count, nullptr));
  std::vector<VkPresentModeKHR> modes(count);
  VK_CHECK(vk_.GetPhysicalDeviceSurfacePresentModesKHR(device_.physicalDevice(), device_.surface(), &count, modes.data()));
  for (VkPresentModeKHR mode : {VK_PRESENT_MODE_MAILBOX_KHR, VK_PRESENT_MODE_IMMEDIATE_KHR})
    if (std::ranges::find(modes, mode) != modes.end()) {
      presentMode_ = mode;
      break;
    }
}

void WindowSwapchain::makeRenderPass() {
  VkAttachmentDescription attachment{};
  attachment.format = format_.format;
  attachment.samples = VK_SAMPLE_COUNT_1_BIT;
  attachment.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  attachment.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  attachment.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  attachment.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
  VkAttachmentReference colour{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &colour;
  VkSubpassDependency dependency{VK_SUBPASS_EXTERNAL,
                                 0,
                                 VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                 VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                 0,
                                 VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                                 0};
  VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
  info.attachmentCount = 1;
  info.pAttachments = &attachment;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  info.dependencyCount = 1;
  info.pDependencies = &dependency;
  VK_CHECK(vk_.CreateRenderPass(device_.device(), &info, nullptr, &renderPass_));
}

void WindowSwapchain::makeFlights() {
  for (Flight& flight : flights_) {
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.queueFamilyIndex = device_.queueFamily();
    VK_CHECK(vk_.CreateCommandPool(device_.device(), &pool, nullptr, &flight.pool));
    VkCommandBufferAllocateInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    commands.commandPool = flight.pool;
    commands.commandBufferCount = 1;
    VK_CHECK(vk_.AllocateCommandBuffers(device_.device(), &commands, &flight.commands));
    VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, nullptr, VK_FENCE_CREATE_SIGNALED_BIT};
    VK_CHECK(vk_.CreateFence(device_.device(), &fence, nullptr, &flight.done));
    VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VK_CHECK(vk_.CreateSemaphore(device_.device(), &semaphore, nullptr, &flight.acquired));
  }
}

void WindowSwapchain::destroyImages() {
  for (Image& image : images_) {
    vk_.DestroySemaphore(device_.device(), image.drawn, nullptr);
    vk_.DestroyFramebuffer(device_.device(), image.framebuffer, nullptr);
    vk_.DestroyImageView(device_.device(), image.view, nullptr);
  }
  images_.clear();
}

void WindowSwapchain::makeImages(VkExtent2D wanted) {
  VK_CHECK(vk_.DeviceWaitIdle(device_.device()));
  destroyImages();
  VkSurfaceCapabilitiesKHR surface;
  VK_CHECK(vk_.GetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physicalDevice(), device_.surface(), &surface));
  extent_ = surface.currentExtent.width != 0xFFFFFFFFu ? surface.currentExtent : wanted;
  extent_.width = std::clamp(extent_.width, surface.minImageExtent.width, surface.maxImageExtent.width);
  extent_.height = std::clamp(extent_.height, surface.minImageExtent.height, surface.maxImageExtent.height);
  if (extent_.width == 0 || extent_.height == 0) return;

  VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = device_.surface();
  info.minImageCount = std::max(3u, surface.minImageCount);
  if (surface.maxImageCount > 0) info.minImageCount = std::min(info.minImageCount, surface.maxImageCount);
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = extent_;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  info.preTransform = surface.currentTransform;
  info.compositeAlpha = surface.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                                                                                            : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
  info.presentMode = presentMode_;
  info.clipped = VK_TRUE;
  info.oldSwapchain = swapchain_;
  VkSwapchainKHR made = VK_NULL_HANDLE;
  VK_CHECK(vk_.CreateSwapchainKHR(device_.device(), &info, nullptr, &made));
  if (swapchain_) vk_.DestroySwapchainKHR(device_.device(), swapchain_, nullptr);
  swapchain_ = made;

  uint32_t count = 0;
  VK_CHECK(vk_.GetSwapchainImagesKHR(device_.device(), swapchain_, &count, nullptr));
  std::vector<VkImage> images(count);
  VK_CHECK(vk_.GetSwapchainImagesKHR(device_.device(), swapchain_, &count, images.data()));
  images_.resize(count);
  for (uint32_t i = 0; i < count; ++i) {
    VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = images[i];
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format_.format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VK_CHECK(vk_.CreateImageView(device_.device(), &view, nullptr, &images_[i].view));
    VkFramebufferCreateInfo framebuffer{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    framebuffer.renderPass = renderPass_;
    framebuffer.attachmentCount = 1;
    framebuffer.pAttachments = &images_[i].view;
    framebuffer.width = extent_.width;
    framebuffer.height = extent_.height;
    framebuffer.layers = 1;
    VK_CHECK(vk_.CreateFramebuffer(device_.device(), &framebuffer, nullptr, &images_[i].framebuffer));
    VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VK_CHECK(vk_.CreateSemaphore(device_.device(), &semaphore, nullptr, &images_[i].drawn));
  }
  outOfDate_ = false;
}

std::optional<uint32_t> WindowSwapchain::acquire(VkExtent2D wanted) {
  for (int attempt = 0; attempt < 3; ++attempt) {
    if (outOfDate_ || extent_.width != wanted.width || extent_.height != wanted.height) makeImages(wanted);
    if (images_.empty()) return std::nullopt;
    uint32_t index = 0;
    const VkResult result =
        vk_.AcquireNextImageKHR(device_.device(), swapchain_, UINT64_MAX, flights_[frame_].acquired, VK_NULL_HANDLE, &index);
    if (result == VK_SUCCESS) return index;
    outOfDate_ = true;
    if (result == VK_SUBOPTIMAL_KHR) return index;
    if (result != VK_ERROR_OUT_OF_DATE_KHR) checkVulkan(result, "vkAcquireNextImageKHR");
  }
  return std::nullopt;
}

void WindowSwapchain::draw(VkExtent2D wanted, VkClearColorValue clear, const std::function<void(VkCommandBuffer)>& before,
                           const std::function<void(VkCommandBuffer)>& inside) {
  if (wanted.width == 0 || wanted.height == 0) return;
  Flight& flight = flights_[frame_];
  VK_CHECK(vk_.WaitForFences(device_.device(), 1, &flight.done, VK_TRUE, UINT64_MAX));
  const std::optional<uint32_t> index = acquire(wanted);
  if (!index) return;

  VK_CHECK(vk_.ResetFences(device_.device(), 1, &flight.done));
  VK_CHECK(vk_.ResetCommandPool(device_.device(), flight.pool, 0));
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, nullptr, VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  VK_CHECK(vk_.BeginCommandBuffer(flight.commands, &begin));
  before(flight.commands);
  VkClearValue value{clear};
  VkRenderPassBeginInfo pass{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
  pass.renderPass = renderPass_;
  pass.framebuffer = images_[*index].framebuffer;
  pass.renderArea.extent = extent_;
  pass.clearValueCount = 1;
  pass.pClearValues = &value;
  vk_.CmdBeginRenderPass(flight.commands, &pass, VK_SUBPASS_CONTENTS_INLINE);
  inside(flight.commands);
  vk_.CmdEndRenderPass(flight.commands);
  VK_CHECK(vk_.EndCommandBuffer(flight.commands));

  const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submit.waitSemaphoreCount = 1;
  submit.pWaitSemaphores = &flight.acquired;
  submit.pWaitDstStageMask = &stage;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &flight.commands;
  submit.signalSemaphoreCount = 1;
  submit.pSignalSemaphores = &images_[*index].drawn;
  VK_CHECK(vk_.QueueSubmit(device_.queue(), 1, &submit, flight.done));

  VkPresentInfoKHR present{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  present.waitSemaphoreCount = 1;
  present.pWaitSemaphores = &images_[*index].drawn;
  present.swapchainCount = 1;
  present.pSwapchains = &swapchain_;
  present.pImageIndices = &*index;
  const VkResult result = vk_.QueuePresentKHR(device_.queue(), &present);
  if (result == VK_SUBOPTIMAL_KHR || result == VK_ERROR_OUT_OF_DATE_KHR)
    outOfDate_ = true;
  else
    checkVulkan(result, "vkQueuePresentKHR");
  frame_ = (frame_ + 1) % kFramesInFlight;
}

}  // namespace gridscope
