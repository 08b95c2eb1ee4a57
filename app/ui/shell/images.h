// The window's pictures on its device: textures uploaded when they change, and drawn from ImGui's draw lists by a pipeline of our own. Nearest
// texel when enlarged, linear when reduced.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/ui/shell/swapchain.h"
#include "app/ui/widgets/images.h"

namespace gridscope {

class DeviceImages : public WindowImages {
 public:
  DeviceImages(const WindowDevice& device, VkRenderPass renderPass);
  ~DeviceImages() override;
  DeviceImages(const DeviceImages&) = delete;
  DeviceImages& operator=(const DeviceImages&) = delete;

  void set(const std::string& key, uint32_t width, uint32_t height, std::span<const uint8_t> rgba) override;
  void draw(ImDrawList& list, const std::string& key, ImVec2 low, ImVec2 high, ImVec2 uvLow, ImVec2 uvHigh) override;

  // Of each frame: forgets what the last one drew; what is to be uploaded, recorded outside the render pass; then the frame's command buffer for the draw lists.
  void beginFrame();
  void upload(VkCommandBuffer commands, uint32_t frame);
  void beginDrawing(VkCommandBuffer commands, VkExtent2D extent);

 private:
  struct Texture {
    uint32_t width = 0, height = 0;
    VkImage image = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkDescriptorSet sets[2] = {};  // nearest, linear
    bool filled = false;
    std::vector<uint8_t> waiting;  // bytes to upload; empty: none
  };
  // A host-visible buffer of one frame in flight.
  struct Staging {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize bytes = 0;
    uint8_t* mapped = nullptr;
  };
  // One picture of a draw list, alive until the list is rendered.
  struct Draw {
    DeviceImages* images;
    VkDescriptorSet set;
    float arguments[8];  // screen low, high; uv low, high
  };

  bool has(const std::string& key) const { return textures_.contains(key); }
  static void drawCallback(const ImDrawList* list, const ImDrawCmd* command);
  void record(const Draw& draw, const ImVec4& clip);
  void makePipeline(VkRenderPass renderPass);
  void makeTexture(Texture& texture);
  void destroyTexture(Texture& texture);
  void reserveStaging(Staging& staging, VkDeviceSize bytes);

  const WindowDevice& device_;
  const WindowVulkan& vk_;
  VkSampler samplers_[2] = {};
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  std::map<std::string, Texture> textures_;
  Staging staging_[WindowSwapchain::kFramesInFlight];
  std::vector<Draw*> draws_;  // of the frame that is built
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkExtent2D extent_{};
};

}  // namespace gridscope
