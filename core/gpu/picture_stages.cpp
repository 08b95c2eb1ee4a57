// See picture_stages.h.
#include "core/gpu/picture_stages.h"

#include <algorithm>

#include "shaders/shared/base/view_element.h"
#include "shaders/shared/gpu/bindings.h"
#include "shaders/shared/trace/frame.h"

namespace gridscope {
namespace {

constexpr VkFormat kVisibilityFormat = VK_FORMAT_R32_UINT;
constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;

// What views may ask for and nobody may have found out: a word of zeros, too short for an element or one that says nothing, stands for it.
constexpr int kFindings[] = {kBindTruths, kBindTriangleCosts, kBindCellRays, kBindStableCells, kBindStableRays, kBindCellUpdates};

}  // namespace

PictureStages::PictureStages(GpuPrograms& programs, SceneBuffers& scene) : programs_(programs), scene_(scene) {
  const uint32_t nothing = 0;
  for (int binding : kFindings)
    uploadBytes(programs.gpu(), programs.bound().makeBuffer(binding, "nothing found", sizeof nothing), bytesOf(nothing));
}

PassDescription PictureStages::gatherPass() {
  return {.stem = "gather", .shaders = {"gather_vert", "gather_frag"}, .draws = DrawTargets{kVisibilityFormat, kDepthFormat}};
}

void PictureStages::makeTargets(uint32_t width, uint32_t height) {
  const GpuDevice& gpu = programs_.gpu();
  if (std::max(width, height) > gpu.report().maxImage2DSide)
    throw Error("--size: an image of " + std::to_string(width) + " x " + std::to_string(height) + " is larger than " + gpu.report().name +
                    " takes (" + std::to_string(gpu.report().maxImage2DSide) + " a side)",
                kExitDevice);
  BoundResources& bound = programs_.bound();
  bound.makeBuffer(kBindGather, "gather", uint64_t(width) * height * sizeof(GatherPixel));
  bound.makeBuffer(kBindViewElements, "view elements", uint64_t(width) * height * sizeof(ViewElement));
  const GpuImage& visibility = bound.makeImage(kBindVisibility, "visibility",
                                               {.format = kVisibilityFormat,
                                                .extent = {width, height, 1},
                                                .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_STORAGE_BIT});
  depth_ = GpuImage(gpu, "depth",
                    {.format = kDepthFormat,
                     .extent = {width, height, 1},
                     .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                     .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
  GpuCommands commands(gpu);
  commands.layout(visibility, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  commands.layout(depth_, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  commands.run();
}

// World triangles are rasterized into a reference a pixel; a compute pass makes the rest of it.
double PictureStages::gather() {
  const GpuImage& visibility = programs_.bound().image(kBindVisibility);
  const VkExtent2D extent{visibility.shape().extent.width, visibility.shape().extent.height};
  VkRenderingAttachmentInfo colour{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  colour.imageView = visibility.view();
  colour.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
  colour.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  colour.clearValue.color.uint32[0] = kNoReference;
  VkRenderingAttachmentInfo depth = colour;
  depth.imageView = depth_.view();
  depth.clearValue.depthStencil = {0.0f, 0};
  VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
  rendering.renderArea.extent = extent;
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = 1;
  rendering.pColorAttachments = &colour;
  rendering.pDepthAttachment = &depth;

  GpuCommands commands(programs_.gpu());
  commands.pass("gather", [&] {
    vkCmdBeginRendering(commands.handle(), &rendering);
    programs_.draw(commands, gatherPass(), extent, [&] { scene_.drawInstances(commands, {0, scene_.numbered().instanceCount()}, true); });
    vkCmdEndRendering(commands.handle());
    commands.barrier();
    programs_.dispatch(commands, "gather_resolve", {int(extent.width), int(extent.height), 1});
  });
  return commands.run()["gather"];
}

double PictureStages::bounce() {
  const VkExtent3D extent = programs_.bound().image(kBindVisibility).shape().extent;
  GpuCommands commands(programs_.gpu());
  commands.pass("bounce", [&] { programs_.dispatch(commands, "bounce", {int(extent.width), int(extent.height), 1}); });
  return commands.run()["bounce"];
}

void PictureStages::reserveElements(uint64_t count) {
  BoundResources& bound = programs_.bound();
  if (bound.byteCount(kBindViewElements) < count * sizeof(ViewElement))
    bound.makeBuffer(kBindViewElements, "view elements", count * sizeof(ViewElement));
}

double PictureStages::view(const std::string& stem, uint32_t width, uint32_t height) {
  GpuCommands commands(programs_.gpu());
  commands.pass(stem, [&] { programs_.dispatch(commands, stem, {int(width), int(height), 1}); });
  return commands.run()[stem];
}

}  // namespace gridscope
