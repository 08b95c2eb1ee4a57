// See images.h.
#include "app/ui/shell/images.h"

#include <algorithm>
#include <cstring>

#include "core/gpu/shader_code.h"

namespace gridscope {

namespace {

constexpr uint32_t kMostTextures = 64;
constexpr VkFormat kFormat = VK_FORMAT_R8G8B8A8_UNORM;

VkShaderModule makeModule(const WindowDevice& device, const char* stem) {
  const std::span<const uint32_t> words = shaderCode(stem);
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = words.size_bytes();
  info.pCode = words.data();
  VkShaderModule module = VK_NULL_HANDLE;
  VK_CHECK(device.vulkan().CreateShaderModule(device.device(), &info, nullptr, &module));
  return module;
}

}  // namespace

DeviceImages::DeviceImages(const WindowDevice& device, VkRenderPass renderPass) : device_(device), vk_(device.vulkan()) {
  for (int i = 0; i < 2; ++i) {
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = info.minFilter = i == 0 ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VK_CHECK(vk_.CreateSampler(device_.device(), &info, nullptr, &samplers_[i]));
  }
  VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo set{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  set.bindingCount = 1;
  set.pBindings = &binding;
  VK_CHECK(vk_.CreateDescriptorSetLayout(device_.device(), &set, nullptr, &setLayout_));
  VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2 * kMostTextures};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
  pool.maxSets = 2 * kMostTextures;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &size;
  VK_CHECK(vk_.CreateDescriptorPool(device_.device(), &pool, nullptr, &pool_));
  makePipeline(renderPass);
}

DeviceImages::~DeviceImages() {
  vk_.DeviceWaitIdle(device_.device());
  for (Draw* draw : draws_) delete draw;
  for (auto& [key, texture] : textures_) destroyTexture(texture);
  for (Staging& staging : staging_) {
    vk_.DestroyBuffer(device_.device(), staging.buffer, nullptr);
    vk_.FreeMemory(device_.device(), staging.memory, nullptr);
  }
  vk_.DestroyPipeline(device_.device(), pipeline_, nullptr);
  vk_.DestroyPipelineLayout(device_.device(), layout_, nullptr);
  vk_.DestroyDescriptorPool(device_.device(), pool_, nullptr);
  vk_.DestroyDescriptorSetLayout(device_.device(), setLayout_, nullptr);
  for (VkSampler sampler : samplers_) vk_.DestroySampler(device_.device(), sampler, nullptr);
}

void DeviceImages::makePipeline(VkRenderPass renderPass) {
  VkPushConstantRange range{VK_SHADER_STAGE_VERTEX_BIT, 0, 8 * sizeof(float)};
  VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &setLayout_;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &range;
  VK_CHECK(vk_.CreatePipelineLayout(device_.device(), &layout, nullptr, &layout_));

  VkShaderModule vertex = makeModule(device_, "window_image_vert"), fragment = makeModule(device_, "window_image_frag");
  VkPipelineShaderStageCreateInfo stages[2] = {{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO},
                                               {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO}};
  stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
  stages[0].module = vertex;
  stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
  stages[1].module = fragment;
  stages[0].pName = stages[1].pName = "main";
  VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.lineWidth = 1.0f;
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineColorBlendAttachmentState attachment{};
  attachment.blendEnable = VK_TRUE;
  attachment.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
  attachment.dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  attachment.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  attachment.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  attachment.colorWriteMask = 0xF;
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = 1;
  blend.pAttachments = &attachment;
  const VkDynamicState dynamicStates[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = 2;
  dynamic.pDynamicStates = dynamicStates;
  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  info.stageCount = 2;
  info.pStages = stages;
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = layout_;
  info.renderPass = renderPass;
  VK_CHECK(vk_.CreateGraphicsPipelines(device_.device(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_));
  vk_.DestroyShaderModule(device_.device(), vertex, nullptr);
  vk_.DestroyShaderModule(device_.device(), fragment, nullptr);
}

void DeviceImages::set(const std::string& key, uint32_t width, uint32_t height, std::span<const uint8_t> rgba) {
  CHECK_EQ(rgba.size(), size_t{4} * width * height);
  if (width == 0 || height == 0 || (!has(key) && textures_.size() >= kMostTextures)) return;
  Texture& texture = textures_[key];
  if (texture.width != width || texture.height != height) {
    if (texture.image) {
      vk_.DeviceWaitIdle(device_.device());
      destroyTexture(texture);
    }
    texture.width = width;
    texture.height = height;
    makeTexture(texture);
  }
  texture.waiting.assign(rgba.begin(), rgba.end());
}

void DeviceImages::makeTexture(Texture& texture) {
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = kFormat;
  info.extent = {texture.width, texture.height, 1};
  info.mipLevels = info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  VK_CHECK(vk_.CreateImage(device_.device(), &info, nullptr, &texture.image));
  VkMemoryRequirements needs;
  vk_.GetImageMemoryRequirements(device_.device(), texture.image, &needs);
  VkMemoryAllocateInfo memory{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  memory.allocationSize = needs.size;
  memory.memoryTypeIndex = device_.memoryType(needs.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  VK_CHECK(vk_.AllocateMemory(device_.device(), &memory, nullptr, &texture.memory));
  VK_CHECK(vk_.BindImageMemory(device_.device(), texture.image, texture.memory, 0));
  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = texture.image;
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = kFormat;
  view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VK_CHECK(vk_.CreateImageView(device_.device(), &view, nullptr, &texture.view));

  for (int i = 0; i < 2; ++i) {
    VkDescriptorSetAllocateInfo set{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    set.descriptorPool = pool_;
    set.descriptorSetCount = 1;
    set.pSetLayouts = &setLayout_;
    VK_CHECK(vk_.AllocateDescriptorSets(device_.device(), &set, &texture.sets[i]));
    VkDescriptorImageInfo image{samplers_[i], texture.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = texture.sets[i];
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = &image;
    vk_.UpdateDescriptorSets(device_.device(), 1, &write, 0, nullptr);
  }
  texture.filled = false;
}

void DeviceImages::destroyTexture(Texture& texture) {
  vk_.FreeDescriptorSets(device_.device(), pool_, 2, texture.sets);
  vk_.DestroyImageView(device_.device(), texture.view, nullptr);
  vk_.DestroyImage(device_.device(), texture.image, nullptr);
  vk_.FreeMemory(device_.device(), texture.memory, nullptr);
  texture = {};
}

// The frame that used this buffer before is done: its fence was waited for.
void DeviceImages::reserveStaging(Staging& staging, VkDeviceSize bytes) {
  if (staging.bytes >= bytes) return;
  vk_.DestroyBuffer(device_.device(), staging.buffer, nullptr);
  vk_.FreeMemory(device_.device(), staging.memory, nullptr);
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = bytes;
  info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
  VK_CHECK(vk_.CreateBuffer(device_.device(), &info, nullptr, &staging.buffer));
  VkMemoryRequirements needs;
  vk_.GetBufferMemoryRequirements(device_.device(), staging.buffer, &needs);
  VkMemoryAllocateInfo memory{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  memory.allocationSize = needs.size;
  memory.memoryTypeIndex =
      device_.memoryType(needs.memoryTypeBits, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  VK_CHECK(vk_.AllocateMemory(device_.device(), &memory, nullptr, &staging.memory));
  VK_CHECK(vk_.BindBufferMemory(device_.device(), staging.buffer, staging.memory, 0));
  void* mapped = nullptr;
  VK_CHECK(vk_.MapMemory(device_.device(), staging.memory, 0, VK_WHOLE_SIZE, 0, &mapped));
  staging.mapped = static_cast<uint8_t*>(mapped);
  staging.bytes = bytes;
}

void DeviceImages::upload(VkCommandBuffer commands, uint32_t frame) {
  VkDeviceSize bytes = 0;
  for (const auto& [key, texture] : textures_) bytes += texture.waiting.size();
  if (bytes == 0) return;
  Staging& staging = staging_[frame];
  reserveStaging(staging, bytes);
  VkDeviceSize offset = 0;
  for (auto& [key, texture] : textures_) {
    if (texture.waiting.empty()) continue;
    std::memcpy(staging.mapped + offset, texture.waiting.data(), texture.waiting.size());
    VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.srcAccessMask = texture.filled ? VkAccessFlags{VK_ACCESS_SHADER_READ_BIT} : VkAccessFlags{0};
    barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.oldLayout = texture.filled ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_UNDEFINED;
    barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = texture.image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vk_.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0, nullptr, 1,
                           &barrier);
    VkBufferImageCopy copy{};
    copy.bufferOffset = offset;
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = {texture.width, texture.height, 1};
    vk_.CmdCopyBufferToImage(commands, staging.buffer, texture.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    vk_.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, 0, 0, nullptr, 0, nullptr, 1,
                           &barrier);
    offset += texture.waiting.size();
    texture.waiting.clear();
    texture.filled = true;
  }
}

void DeviceImages::draw(ImDrawList& list, const std::string& key, ImVec2 low, ImVec2 high, ImVec2 uvLow, ImVec2 uvHigh) {
  const auto found = textures_.find(key);
  if (found == textures_.end()) return;
  const Texture& texture = found->second;
  const float scale = (high.x - low.x) / std::max(1e-6f, (uvHigh.x - uvLow.x) * float(texture.width));
  auto* draw = new Draw{this, texture.sets[scale >= 1.0f ? 0 : 1], {low.x, low.y, high.x, high.y, uvLow.x, uvLow.y, uvHigh.x, uvHigh.y}};
  draws_.push_back(draw);
  list.AddCallback(drawCallback, draw);
  list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
}

void DeviceImages::beginFrame() {
  for (Draw* draw : draws_) delete draw;
  draws_.clear();
}

void DeviceImages::beginDrawing(VkCommandBuffer commands, VkExtent2D extent) {
  commands_ = commands;
  extent_ = extent;
}

void DeviceImages::drawCallback(const ImDrawList*, const ImDrawCmd* command) {
  const Draw& draw = *static_cast<const Draw*>(command->UserCallbackData);
  draw.images->record(draw, command->ClipRect);
}

void DeviceImages::record(const Draw& draw, const ImVec4& clip) {
  const int left = std::max(0, int(clip.x)), top = std::max(0, int(clip.y));
  const int right = std::min(int(extent_.width), int(clip.z)), bottom = std::min(int(extent_.height), int(clip.w));
  if (right <= left || bottom <= top) return;
  VkRect2D scissor{{left, top}, {uint32_t(right - left), uint32_t(bottom - top)}};
  float arguments[8];
  std::copy_n(draw.arguments, 8, arguments);
  for (int i = 0; i < 4; ++i) arguments[i] = 2.0f * arguments[i] / float(i % 2 == 0 ? extent_.width : extent_.height) - 1.0f;
  vk_.CmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
  vk_.CmdBindDescriptorSets(commands_, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &draw.set, 0, nullptr);
  vk_.CmdPushConstants(commands_, layout_, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof arguments, arguments);
  vk_.CmdSetScissor(commands_, 0, 1, &scissor);
  vk_.CmdDraw(commands_, 4, 1, 0, 0);
}

}  // namespace gridscope
