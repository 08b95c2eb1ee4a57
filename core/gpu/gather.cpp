// Gather, bounce and views on the Vulkan device.
#include "core/gpu/stages.h"

namespace gridscope {
namespace {

constexpr VkFormat kVisibilityFormat = VK_FORMAT_R32_UINT;
constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;

}  // namespace

void GpuStages::tryShaders(GpuContext& gpu) { GpuPrograms(gpu).makeAll(kVisibilityFormat, kDepthFormat); }

void GpuStages::makeTargets(uint32_t width, uint32_t height) {
  if (std::max(width, height) > gpu_.report().maxImage2DSide)
    throw Error("--size: an image of " + std::to_string(width) + " x " + std::to_string(height) + " is larger than " + gpu_.report().name +
                    " takes (" + std::to_string(gpu_.report().maxImage2DSide) + " a side)",
                kExitDevice);
  uint64_t pixels = uint64_t(width) * height;
  makeBuffer(kBindGather, "gather", pixels * sizeof(GatherPixel));
  makeBuffer(kBindRays, "rays", pixels * sizeof(Ray));
  makeBuffer(kBindHits, "hits", pixels * sizeof(Hit));
  makeBuffer(kBindCounters, "counters", pixels * sizeof(RayCounters));
  makeBuffer(kBindTraceStates, "trace states", pixels * sizeof(TraceState));
  makeBuffer(kBindViewElements, "view elements", pixels * sizeof(ViewElement));

  visibility_ = GpuImage(gpu_, "visibility",
                         {.format = kVisibilityFormat,
                          .extent = {width, height, 1},
                          .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_STORAGE_BIT});
  depth_ = GpuImage(gpu_, "depth",
                    {.format = kDepthFormat,
                     .extent = {width, height, 1},
                     .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                     .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
  programs_.bind(kBindVisibility, visibility_);
  GpuCommands commands(gpu_);
  commands.layout(visibility_, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  commands.layout(depth_, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  commands.run();
}

// World triangles are rasterized into a reference a pixel; a compute pass makes the rest of it.
double GpuStages::gather() {
  VkExtent2D extent{visibility_.shape().extent.width, visibility_.shape().extent.height};
  VkRenderingAttachmentInfo colour{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  colour.imageView = visibility_.view();
  colour.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
  colour.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  colour.clearValue.color.uint32[0] = kBlank;
  VkRenderingAttachmentInfo depth = colour;
  depth.imageView = depth_.view();
  depth.clearValue.depthStencil = {0.0f, 0};
  VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
  rendering.renderArea.extent = extent;
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = 1;
  rendering.pColorAttachments = &colour;
  rendering.pDepthAttachment = &depth;

  GpuCommands commands(gpu_);
  commands.pass("gather", [&] {
    vkCmdBeginRendering(commands.handle(), &rendering);
    programs_.bindGather(commands, kVisibilityFormat, kDepthFormat, extent);
    for (uint32_t i = 0; i < numbered_.instanceCount(); ++i) {
      const Instance& instance = numbered_.instances[i];
      vkCmdDraw(commands.handle(), 3 * instance.triangleCount, 1, 3 * instance.firstWorldTriangle, i);
    }
    vkCmdEndRendering(commands.handle());
    commands.barrier();
    programs_.dispatch(commands, "gather_resolve", {int(extent.width), int(extent.height), 1});
  });
  return commands.run()["gather"];
}

double GpuStages::bounce() {
  GpuCommands commands(gpu_);
  commands.pass("bounce", [&] {
    programs_.dispatch(commands, "bounce", {int(parameters_.camera.width), int(parameters_.camera.height), 1});
  });
  return commands.run()["bounce"];
}

double GpuStages::view(const std::string& name, uint32_t width, uint32_t height) {
  uint64_t bytes = uint64_t(width) * height * sizeof(ViewElement);
  if (buffers_[kBindViewElements].byteCount() < bytes) makeBuffer(kBindViewElements, "view elements", bytes);
  warm(std::span(&name, 1));
  GpuCommands commands(gpu_);
  commands.pass(name, [&] { programs_.dispatch(commands, name, {int(width), int(height), 1}); });
  return commands.run()[name];
}

}  // namespace gridscope
