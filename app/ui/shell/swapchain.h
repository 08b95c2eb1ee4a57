// The window's pictures: swapchain, render pass and the two frames in flight. A swapchain that no longer fits is made anew.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/ui/shell/device.h"

namespace gridscope {

class WindowSwapchain {
 public:
  static constexpr uint32_t kFramesInFlight = 2;

  explicit WindowSwapchain(const WindowDevice& device);
  ~WindowSwapchain();
  WindowSwapchain(const WindowSwapchain&) = delete;
  WindowSwapchain& operator=(const WindowSwapchain&) = delete;

  VkRenderPass renderPass() const { return renderPass_; }
  uint32_t imageCount() const { return uint32_t(images_.size()); }
  VkExtent2D extent() const { return extent_; }
  uint32_t frame() const { return frame_; }  // 0 .. kFramesInFlight - 1, of the frame that is recorded next

  // Draws one frame: `before` records what must lie outside the render pass, `inside` what it draws. Nothing happens while the window has
  // no area (minimised).
  void draw(VkExtent2D wanted, VkClearColorValue clear, const std::function<void(VkCommandBuffer)>& before,
            const std::function<void(VkCommandBuffer)>& inside);

 private:
  // What one frame in flight owns.
  struct Flight {
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkFence done = VK_NULL_HANDLE;
    VkSemaphore acquired = VK_NULL_HANDLE;
  };
  // What one image of the swapchain owns.
  struct Image {
    VkImageView view = VK_NULL_HANDLE;
    VkFramebuffer framebuffer = VK_NULL_HANDLE;
    VkSemaphore drawn = VK_NULL_HANDLE;
  };

  void chooseFormat();
  void makeRenderPass();
  void makeFlights();
  void makeImages(VkExtent2D wanted);
  void destroyImages();
  std::optional<uint32_t> acquire(VkExtent2D wanted);

  const WindowDevice& device_;
  const WindowVulkan& vk_;
  VkSurfaceFormatKHR format_{};
  VkPresentModeKHR presentMode_ = VK_PRESENT_MODE_FIFO_KHR;
  VkRenderPass renderPass_ = VK_NULL_HANDLE;
  VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
  VkExtent2D extent_{};
  std::vector<Image> images_;
  Flight flights_[kFramesInFlight];
  uint32_t frame_ = 0;
  bool outOfDate_ = true;
};

}  // namespace gridscope
