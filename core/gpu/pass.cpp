// See pass.h.
#include "core/gpu/pass.h"

#include "core/gpu/pass_limits.h"
#include "core/gpu/shader_code.h"

namespace gridscope {
namespace {

VkShaderStageFlagBits stageFlag(ShaderStage stage) {
  switch (stage) {
    case ShaderStage::vertex: return VK_SHADER_STAGE_VERTEX_BIT;
    case ShaderStage::geometry: return VK_SHADER_STAGE_GEOMETRY_BIT;
    case ShaderStage::fragment: return VK_SHADER_STAGE_FRAGMENT_BIT;
    case ShaderStage::compute: return VK_SHADER_STAGE_COMPUTE_BIT;
  }
  return VK_SHADER_STAGE_ALL;
}

VkDescriptorType descriptorType(ResourceKind kind) {
  switch (kind) {
    case ResourceKind::storageBuffer: return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case ResourceKind::storageImage: return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case ResourceKind::sampledImage: return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  }
  return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

// The stages of a pass, ready for a pipeline, with all that the structures point to.
class PassStages {
 public:
  PassStages(const GpuDevice& gpu, const PassDescription& description, const ShaderConstants& constants) {
    for (const auto& [id, value] : constants) {
      entries_.push_back({id, uint32_t(values_.size() * sizeof(uint32_t)), sizeof(uint32_t)});
      values_.push_back(value);
    }
    constants_ = {uint32_t(entries_.size()), entries_.data(), values_.size() * sizeof(uint32_t), values_.data()};
    for (const std::string& shader : description.shaders) {
      const std::vector<uint32_t> words = makeExact(withoutUnused(shaderCode(shader)), gpu.report().roundingControl);
      VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
      info.codeSize = words.size() * sizeof(uint32_t);
      info.pCode = words.data();
      modules_.push_back(gpu.make(info, shader));
      VkPipelineShaderStageCreateInfo stage{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
      stage.stage = stageFlag(readFacts(words).stage);
      stage.module = modules_.back().get();
      stage.pName = "main";
      stage.pSpecializationInfo = &constants_;
      infos_.push_back(stage);
    }
  }
  PassStages(const PassStages&) = delete;
  PassStages& operator=(const PassStages&) = delete;

  std::span<const VkPipelineShaderStageCreateInfo> infos() const { return infos_; }

 private:
  std::vector<VkSpecializationMapEntry> entries_;
  std::vector<uint32_t> values_;
  VkSpecializationInfo constants_{};
  std::vector<Owned<VkShaderModule>> modules_;
  std::vector<VkPipelineShaderStageCreateInfo> infos_;
};

VkResult makeComputePipeline(VkDevice device, VkPipelineLayout layout, const PassStages& stages, VkPipeline& pipeline) {
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage = stages.infos()[0];
  info.layout = layout;
  return vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
}

VkResult makeGraphicsPipeline(VkDevice device, VkPipelineLayout layout, const PassStages& stages, const DrawTargets& targets,
                              VkPipeline& pipeline) {
  VkPipelineVertexInputStateCreateInfo vertex{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.polygonMode = VK_POLYGON_MODE_FILL;
  raster.lineWidth = 1.0f;
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  VkPipelineColorBlendAttachmentState attachment{};
  attachment.colorWriteMask = VK_COLOR_COMPONENT_R_BIT;
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.pAttachments = &attachment;
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  const VkDynamicState dynamicStates[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.pDynamicStates = dynamicStates;
  if (targets.colour == VK_FORMAT_UNDEFINED) {
    raster.rasterizerDiscardEnable = VK_TRUE;
  } else {
    viewport.viewportCount = viewport.scissorCount = 1;
    dynamic.dynamicStateCount = 2;
    depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
    depth.depthCompareOp = VK_COMPARE_OP_GREATER;
    blend.attachmentCount = 1;
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachmentFormats = &targets.colour;
    rendering.depthAttachmentFormat = targets.depth;
  }

  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  info.pNext = &rendering;
  info.stageCount = uint32_t(stages.infos().size());
  info.pStages = stages.infos().data();
  info.pVertexInputState = &vertex;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = layout;
  return vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
}

}  // namespace

PassDescription computePass(const std::string& stem) { return {.stem = stem, .shaders = {stem}, .draws = {}}; }

GpuPass::GpuPass(const GpuDevice& gpu, const PassDescription& description, const ShaderConstants& constants)
    : gpu_(gpu), stem_(description.stem), bindPoint_(description.draws ? VK_PIPELINE_BIND_POINT_GRAPHICS : VK_PIPELINE_BIND_POINT_COMPUTE) {
  readShaders(description);
  makeLayout();
  makePipeline(description, constants);
}

void GpuPass::readShaders(const PassDescription& description) {
  for (const std::string& shader : description.shaders) {
    const ShaderFacts facts = readFacts(shaderCode(shader));
    if (const std::string why = whyPassDoesNotFit(shader, facts, gpu_.report().passLimits); !why.empty())
      throw Error(gpu_.report().name + ": " + why, kExitDevice);
    stages_ |= stageFlag(facts.stage);
    std::copy(facts.localSize, facts.localSize + 3, localSize_);
    pushConstantBytes_ = std::max(pushConstantBytes_, facts.pushConstantBytes);
    for (const ShaderResource& resource : facts.resources) {
      Use& use = uses_[resource.binding];
      use.layout.binding = resource.binding;
      use.layout.descriptorType = descriptorType(resource.kind);
      use.layout.descriptorCount = 1;
      use.layout.stageFlags |= stageFlag(facts.stage);
      use.name = resource.name;
    }
  }
}

void GpuPass::makeLayout() {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  std::map<VkDescriptorType, uint32_t> counts;
  for (const auto& [binding, use] : uses_) {
    bindings.push_back(use.layout);
    ++counts[use.layout.descriptorType];
  }
  VkDescriptorSetLayoutCreateInfo setLayout{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  setLayout.bindingCount = uint32_t(bindings.size());
  setLayout.pBindings = bindings.data();
  setLayout_ = gpu_.make(setLayout, stem_);

  VkPushConstantRange range{stages_, 0, pushConstantBytes_};
  VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout.setLayoutCount = 1;
  layout.pSetLayouts = setLayout_.address();
  layout.pushConstantRangeCount = pushConstantBytes_ > 0 ? 1 : 0;
  layout.pPushConstantRanges = &range;
  layout_ = gpu_.make(layout, stem_);
  if (bindings.empty()) return;

  std::vector<VkDescriptorPoolSize> sizes;
  for (const auto& [type, count] : counts) sizes.push_back({type, count});
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = 1;
  pool.poolSizeCount = uint32_t(sizes.size());
  pool.pPoolSizes = sizes.data();
  pool_ = gpu_.make(pool, stem_);
  VkDescriptorSetAllocateInfo set{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  set.descriptorPool = pool_.get();
  set.descriptorSetCount = 1;
  set.pSetLayouts = setLayout_.address();
  VK_CHECK(vkAllocateDescriptorSets(gpu_.handle(), &set, &set_));
  gpu_.name(VK_OBJECT_TYPE_DESCRIPTOR_SET, set_, stem_);
}

void GpuPass::makePipeline(const PassDescription& description, const ShaderConstants& constants) {
  const PassStages stages(gpu_, description, constants);
  VkPipeline pipeline = VK_NULL_HANDLE;
  const VkResult result = description.draws ? makeGraphicsPipeline(gpu_.handle(), layout_.get(), stages, *description.draws, pipeline)
                                            : makeComputePipeline(gpu_.handle(), layout_.get(), stages, pipeline);
  if (result < 0) throw Error(stem_ + ": the device refuses this pass (" + resultName(result) + ")", kExitDevice);
  pipeline_ = {gpu_.handle(), pipeline, vkDestroyPipeline};
  gpu_.name(VK_OBJECT_TYPE_PIPELINE, pipeline, stem_);
}

void GpuPass::write(Use& use, const BoundResources& bound) {
  const BoundResources::Place* place = bound.find(int(use.layout.binding));
  if (!place) throw Error("the pass " + stem_ + " reads " + use.name + ", which nothing has filled", kExitDevice);
  if (place->version == use.versionWritten) return;
  const VkDescriptorBufferInfo buffer{place->buffer.handle(), 0, VK_WHOLE_SIZE};
  const VkDescriptorImageInfo image{place->sampler.get(), place->image.view(), VK_IMAGE_LAYOUT_GENERAL};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set_;
  write.dstBinding = use.layout.binding;
  write.descriptorCount = 1;
  write.descriptorType = use.layout.descriptorType;
  write.pBufferInfo = &buffer;
  write.pImageInfo = &image;
  vkUpdateDescriptorSets(gpu_.handle(), 1, &write, 0, nullptr);
  use.versionWritten = place->version;
}

void GpuPass::begin(VkCommandBuffer commands, const BoundResources& bound, std::span<const std::byte> arguments) {
  if (pushConstantBytes_ != arguments.size()) std::fprintf(stderr, "pass %s:\n", stem_.c_str());
  CHECK_EQ(pushConstantBytes_, arguments.size());
  for (auto& [binding, use] : uses_) write(use, bound);
  vkCmdBindPipeline(commands, bindPoint_, pipeline_.get());
  if (set_) vkCmdBindDescriptorSets(commands, bindPoint_, layout_.get(), 0, 1, &set_, 0, nullptr);
  if (!arguments.empty()) vkCmdPushConstants(commands, layout_.get(), stages_, 0, uint32_t(arguments.size()), arguments.data());
}

}  // namespace gridscope
