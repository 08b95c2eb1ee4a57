// See program.h.
#include "core/gpu/program.h"

#include <array>
#include <bit>
#include <vector>

#include "core/gpu/shader_code.h"

namespace gridscope {
namespace {

constexpr uint32_t kPushConstantBytes = 128;  // what every device has

VkDescriptorType bindingType(int binding) {
  static_assert(kBindGrid == 0 && kBindVisibility == 1 && kBindDiffuseMaps == 2);
  if (binding == kBindGrid || binding == kBindVisibility) return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
  if (binding == kBindDiffuseMaps) return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

// One entry a member, in the members' order.
const VkSpecializationMapEntry kSpecializationEntries[] = {{0, 0, 4}, {1, 4, 4}, {2, 8, 4}, {3, 12, 4}, {4, 16, 4}};
static_assert(sizeof(SpecializedSettings) == 4 * std::size(kSpecializationEntries));

VkSpecializationInfo specialization(const SpecializedSettings& settings) {
  return {uint32_t(std::size(kSpecializationEntries)), kSpecializationEntries, sizeof(SpecializedSettings), &settings};
}

VkPipelineShaderStageCreateInfo stageInfo(VkShaderStageFlagBits stage, VkShaderModule module, const VkSpecializationInfo& constants) {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = stage;
  info.module = module;
  info.pName = "main";
  info.pSpecializationInfo = &constants;
  return info;
}

Error refusal(const std::string& stem, VkResult result) {
  return Error(stem + ": the device refuses this pass (" + resultName(result) + ")", kExitDevice);
}

}  // namespace

// What the two graphics passes have in common: triangles without vertex buffers, no culling, no blending.
struct GpuPrograms::GraphicsState {
  VkPipelineVertexInputStateCreateInfo vertex{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  VkPipelineColorBlendAttachmentState attachment{};
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  VkDynamicState dynamicStates[2] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};

  GraphicsState() {
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    raster.polygonMode = VK_POLYGON_MODE_FILL;
    raster.lineWidth = 1.0f;
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    attachment.colorWriteMask = VK_COLOR_COMPONENT_R_BIT;
    blend.pAttachments = &attachment;
    dynamic.pDynamicStates = dynamicStates;
  }
  GraphicsState(const GraphicsState&) = delete;

  VkResult make(VkDevice device, VkPipelineLayout layout, std::span<const VkPipelineShaderStageCreateInfo> stages, VkPipeline& pipeline) {
    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    info.pNext = &rendering;
    info.stageCount = uint32_t(stages.size());
    info.pStages = stages.data();
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
};

GpuPrograms::GpuPrograms(GpuContext& gpu) : gpu_(gpu) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (int binding = 0; binding < kBindingCount; ++binding)
    bindings.push_back({uint32_t(binding), bindingType(binding), 1, VK_SHADER_STAGE_ALL, nullptr});
  VkDescriptorSetLayoutCreateInfo setLayout{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  setLayout.bindingCount = kBindingCount;
  setLayout.pBindings = bindings.data();
  VK_CHECK(vkCreateDescriptorSetLayout(gpu.device(), &setLayout, nullptr, &setLayout_));

  VkPushConstantRange range{VK_SHADER_STAGE_ALL, 0, kPushConstantBytes};
  VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &setLayout_;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &range;
  VK_CHECK(vkCreatePipelineLayout(gpu.device(), &layout, nullptr, &layout_));

  VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 2},
                                  {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1},
                                  {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, kBindingCount - 3}};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = 1;
  pool.poolSizeCount = 3;
  pool.pPoolSizes = sizes;
  VK_CHECK(vkCreateDescriptorPool(gpu.device(), &pool, nullptr, &pool_));
  VkDescriptorSetAllocateInfo set{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  set.descriptorPool = pool_;
  set.descriptorSetCount = 1;
  set.pSetLayouts = &setLayout_;
  VK_CHECK(vkAllocateDescriptorSets(gpu.device(), &set, &set_));
  bindPlaceholders();
}

void GpuPrograms::bindPlaceholders() {
  placeholder_ = GpuBuffer(gpu_, "placeholder", 4);
  for (int binding = 0; binding < kBindingCount; ++binding)
    if (bindingType(binding) == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER) bind(binding, placeholder_);

  VkSamplerCreateInfo sampler{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  VK_CHECK(vkCreateSampler(gpu_.device(), &sampler, nullptr, &placeholderSampler_));
  ImageShape storage{.format = VK_FORMAT_R32_UINT, .usage = VK_IMAGE_USAGE_STORAGE_BIT};
  ImageShape volume = storage, layers = storage;
  volume.type = VK_IMAGE_TYPE_3D;
  volume.viewType = VK_IMAGE_VIEW_TYPE_3D;
  layers.viewType = VK_IMAGE_VIEW_TYPE_2D_ARRAY;
  layers.format = VK_FORMAT_R8G8B8A8_SRGB;
  layers.usage = VK_IMAGE_USAGE_SAMPLED_BIT;
  const std::pair<int, ImageShape> images[] = {{kBindGrid, volume}, {kBindVisibility, storage}, {kBindDiffuseMaps, layers}};
  GpuCommands commands(gpu_);
  for (const auto& [binding, shape] : images) {
    GpuImage& image = placeholderImages_[binding];
    image = GpuImage(gpu_, "placeholder", shape);
    commands.layout(image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
    bind(binding, image, placeholderSampler_);
  }
  commands.run();
}

GpuPrograms::~GpuPrograms() {
  for (auto& [stem, program] : programs_) vkDestroyPipeline(gpu_.device(), program.pipeline, nullptr);
  for (auto& [stem, pipeline] : graphics_) vkDestroyPipeline(gpu_.device(), pipeline, nullptr);
  vkDestroySampler(gpu_.device(), placeholderSampler_, nullptr);
  vkDestroyDescriptorPool(gpu_.device(), pool_, nullptr);
  vkDestroyPipelineLayout(gpu_.device(), layout_, nullptr);
  vkDestroyDescriptorSetLayout(gpu_.device(), setLayout_, nullptr);
}

void GpuPrograms::bind(int binding, const GpuBuffer& buffer) {
  VkDescriptorBufferInfo info{buffer.handle(), 0, VK_WHOLE_SIZE};
  writeDescriptor(binding, &info, nullptr);
}

void GpuPrograms::bind(int binding, const GpuImage& image, VkSampler sampler) {
  VkDescriptorImageInfo info{sampler, image.view(), VK_IMAGE_LAYOUT_GENERAL};
  writeDescriptor(binding, nullptr, &info);
}

void GpuPrograms::writeDescriptor(int binding, const VkDescriptorBufferInfo* buffer, const VkDescriptorImageInfo* image) {
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set_;
  write.dstBinding = uint32_t(binding);
  write.descriptorCount = 1;
  write.descriptorType = bindingType(binding);
  write.pBufferInfo = buffer;
  write.pImageInfo = image;
  vkUpdateDescriptorSets(gpu_.device(), 1, &write, 0, nullptr);
}

std::string GpuPrograms::key(const std::string& stem) const {
  std::string text = stem;
  for (uint32_t value : std::bit_cast<std::array<uint32_t, std::size(kSpecializationEntries)>>(specialized_))
    text += " " + std::to_string(value);
  return text;
}

VkShaderModule GpuPrograms::makeModule(const std::string& stem) {
  std::vector<uint32_t> words = makeExact(shaderCode(stem), gpu_.report().roundingControl);
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = words.size() * sizeof(uint32_t);
  info.pCode = words.data();
  VkShaderModule module = VK_NULL_HANDLE;
  VK_CHECK(vkCreateShaderModule(gpu_.device(), &info, nullptr, &module));
  gpu_.name(VK_OBJECT_TYPE_SHADER_MODULE, uint64_t(module), stem);
  return module;
}

GpuPrograms::Program& GpuPrograms::program(const std::string& stem) {
  auto found = programs_.find(key(stem));
  if (found != programs_.end()) return found->second;
  ShaderFacts facts = readFacts(shaderCode(stem));
  Program program;
  std::copy(facts.localSize, facts.localSize + 3, program.localSize);
  program.pushConstantBytes = facts.pushConstantBytes;

  VkShaderModule module = makeModule(stem);
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  VkSpecializationInfo constants = specialization(specialized_);
  info.stage = stageInfo(VK_SHADER_STAGE_COMPUTE_BIT, module, constants);
  info.layout = layout_;
  VkResult result = vkCreateComputePipelines(gpu_.device(), VK_NULL_HANDLE, 1, &info, nullptr, &program.pipeline);
  vkDestroyShaderModule(gpu_.device(), module, nullptr);
  if (result < 0) throw refusal(stem, result);
  gpu_.name(VK_OBJECT_TYPE_PIPELINE, uint64_t(program.pipeline), stem);
  return programs_.emplace(key(stem), program).first->second;
}

bool GpuPrograms::warm(GpuCommands& commands, const std::string& stem) {
  Program& pass = program(stem);
  if (pass.warm) return false;
  pass.warm = true;
  std::vector<std::byte> zeros(pass.pushConstantBytes);
  begin(commands, pass, stem, zeros);
  vkCmdDispatch(commands.handle(), 1, 1, 1);
  commands.barrier();
  return true;
}

void GpuPrograms::begin(GpuCommands& commands, const Program& program, const std::string& stem, std::span<const std::byte> arguments) {
  if (program.pushConstantBytes != arguments.size()) std::fprintf(stderr, "pass %s:\n", stem.c_str());
  CHECK_EQ(program.pushConstantBytes, arguments.size());
  vkCmdBindPipeline(commands.handle(), VK_PIPELINE_BIND_POINT_COMPUTE, program.pipeline);
  vkCmdBindDescriptorSets(commands.handle(), VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0, nullptr);
  if (!arguments.empty())
    vkCmdPushConstants(commands.handle(), layout_, VK_SHADER_STAGE_ALL, 0, uint32_t(arguments.size()), arguments.data());
}

void GpuPrograms::dispatch(GpuCommands& commands, const std::string& stem, ivec3 invocations, std::span<const std::byte> arguments) {
  const Program& pass = program(stem);
  if (invocations.x <= 0 || invocations.y <= 0 || invocations.z <= 0) return;
  begin(commands, pass, stem, arguments);
  auto groups = [&](int axis) { return (uint32_t(invocations[axis]) + pass.localSize[axis] - 1) / pass.localSize[axis]; };
  vkCmdDispatch(commands.handle(), groups(0), groups(1), groups(2));
}

void GpuPrograms::dispatchIndirect(GpuCommands& commands, const std::string& stem, const GpuBuffer& buffer, uint64_t offset,
                                   std::span<const std::byte> arguments) {
  begin(commands, program(stem), stem, arguments);
  vkCmdDispatchIndirect(commands.handle(), buffer.handle(), offset);
}

void GpuPrograms::bindGraphics(GpuCommands& commands, VkPipeline pipeline) {
  vkCmdBindPipeline(commands.handle(), VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
  vkCmdBindDescriptorSets(commands.handle(), VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &set_, 0, nullptr);
}

VkPipeline GpuPrograms::graphics(const std::string& stem, std::initializer_list<GraphicsStage> stages, GraphicsState& state) {
  VkPipeline& pipeline = graphics_[key(stem)];
  if (pipeline) return pipeline;
  const VkSpecializationInfo constants = specialization(specialized_);
  std::vector<VkPipelineShaderStageCreateInfo> infos;
  for (const auto& [stage, ending] : stages) infos.push_back(stageInfo(stage, makeModule(stem + ending), constants));
  const VkResult result = state.make(gpu_.device(), layout_, infos, pipeline);
  for (const VkPipelineShaderStageCreateInfo& info : infos) vkDestroyShaderModule(gpu_.device(), info.module, nullptr);
  if (result < 0) throw refusal(stem, result);
  return pipeline;
}

VkPipeline GpuPrograms::buildRaster() {
  GraphicsState state;
  state.raster.rasterizerDiscardEnable = VK_TRUE;
  return graphics("build_raster", {{VK_SHADER_STAGE_VERTEX_BIT, "_vert"}, {VK_SHADER_STAGE_GEOMETRY_BIT, "_geom"}}, state);
}

VkPipeline GpuPrograms::gather(VkFormat colour, VkFormat depth) {
  GraphicsState state;
  state.viewport.viewportCount = state.viewport.scissorCount = 1;
  state.dynamic.dynamicStateCount = 2;
  state.depth.depthTestEnable = state.depth.depthWriteEnable = VK_TRUE;
  state.depth.depthCompareOp = VK_COMPARE_OP_GREATER;  // reversed depth: near is 1
  state.blend.attachmentCount = 1;
  state.rendering.colorAttachmentCount = 1;
  state.rendering.pColorAttachmentFormats = &colour;
  state.rendering.depthAttachmentFormat = depth;
  return graphics("gather", {{VK_SHADER_STAGE_VERTEX_BIT, "_vert"}, {VK_SHADER_STAGE_FRAGMENT_BIT, "_frag"}}, state);
}

void GpuPrograms::makeAll(VkFormat colour, VkFormat depth) {
  for (const ShaderCode& shader : allShaders())
    if (shader.source.ends_with(".comp")) program(std::string(shader.stem));
  gather(colour, depth);
  if (gpu_.report().geometryStage) buildRaster();
}

void GpuPrograms::bindBuildRaster(GpuCommands& commands) { bindGraphics(commands, buildRaster()); }

void GpuPrograms::bindGather(GpuCommands& commands, VkFormat colour, VkFormat depth, VkExtent2D extent) {
  bindGraphics(commands, gather(colour, depth));
  VkViewport viewport{0.0f, 0.0f, float(extent.width), float(extent.height), 0.0f, 1.0f};
  VkRect2D scissor{{0, 0}, extent};
  vkCmdSetViewport(commands.handle(), 0, 1, &viewport);
  vkCmdSetScissor(commands.handle(), 0, 1, &scissor);
}

}  // namespace gridscope
