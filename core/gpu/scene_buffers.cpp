// See scene_buffers.h.
#include "core/gpu/scene_buffers.h"

#include <algorithm>

#include "core/gpu/diffuse_maps.h"
#include "shaders/shared/gpu/bindings.h"

namespace gridscope {

SceneBuffers::SceneBuffers(GpuPrograms& programs, std::span<const Image> images, const NumberedScene& numbered, uint32_t textureSize)
    : programs_(programs), numbered_(numbered) {
  upload(numbered);
  uploadImages(images, textureSize);
}

void SceneBuffers::upload(const NumberedScene& numbered) {
  auto fill = [&](int binding, const std::string& name, const auto& values) {
    std::span span(values);
    uploadBytes(programs_.gpu(), programs_.bound().makeBuffer(binding, name, span.size_bytes()), std::as_bytes(span));
  };
  fill(kBindObjectTriangles, "object triangles", numbered.objectTriangles);
  fill(kBindCorners, "corners", numbered.corners);
  fill(kBindInstances, "instances", numbered.instances);
  fill(kBindMaterials, "materials", numbered.materials);
  fill(kBindAlphaBytes, "alpha maps", numbered.alphaBytes);
  programs_.bound().makeBuffer(kBindWorldTriangles, "world triangles", uint64_t(numbered.triangleCount) * sizeof(Triangle));
  programs_.bound().makeBuffer(kBindMovedInstances, "moved instances", (uint64_t(numbered.instanceCount()) / 32 + 1) * sizeof(uint32_t));
}

void SceneBuffers::uploadImages(std::span<const Image> images, uint32_t textureSize) {
  const GpuDevice& gpu = programs_.gpu();
  uint32_t layers = std::max<uint32_t>(1, uint32_t(images.size()));
  if (layers > gpu.report().maxImageArrayLayers)
    throw Error("the scene has " + std::to_string(layers) + " images, but " + gpu.report().name + " takes " +
                    std::to_string(gpu.report().maxImageArrayLayers),
                kExitDevice);
  if (images.empty()) textureSize = 1;
  VkSamplerCreateInfo sampler{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  sampler.magFilter = sampler.minFilter = VK_FILTER_LINEAR;
  sampler.addressModeU = sampler.addressModeV = VK_SAMPLER_ADDRESS_MODE_REPEAT;
  const GpuImage& maps = programs_.bound().makeImage(kBindDiffuseMaps, "diffuse maps",
                                                     {.viewType = VK_IMAGE_VIEW_TYPE_2D_ARRAY,
                                                      .format = VK_FORMAT_R8G8B8A8_SRGB,
                                                      .extent = {textureSize, textureSize, 1},
                                                      .layers = layers,
                                                      .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT},
                                                     gpu.make(sampler, "diffuse maps"));
  GpuCommands commands(gpu);
  commands.layout(maps, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  commands.run();
  const std::vector<uint8_t> texels = diffuseLayers(images, textureSize);
  uploadImage(gpu, maps, std::as_bytes(std::span(texels)));
}

void SceneBuffers::setInstances(std::span<const Instance> instances) { programs_.write(kBindInstances, instances); }

void SceneBuffers::setMoved(std::span<const uint32_t> moved) {
  std::vector<uint32_t> bits(numbered_.instanceCount() / 32 + 1, 0);
  for (uint32_t instance : moved) bits[instance / 32] |= 1u << (instance % 32);
  programs_.write(kBindMovedInstances, std::span<const uint32_t>(bits));
}

PassArguments SceneBuffers::argumentsFor(InstanceRange range, uint32_t take) const {
  auto firstTriangle = [&](uint32_t instance) {
    return instance < numbered_.instanceCount() ? numbered_.instances[instance].firstWorldTriangle : numbered_.triangleCount;
  };
  return {range.begin, range.end, firstTriangle(range.begin), firstTriangle(range.end), take, 0};
}

void SceneBuffers::transform(GpuCommands& commands, InstanceRange range, uint32_t take) {
  PassArguments arguments = argumentsFor(range, take);
  programs_.dispatch(commands, "transform", {int(arguments.endTriangle - arguments.firstTriangle), 1, 1}, bytesOf(arguments));
  commands.barrier();
}

void SceneBuffers::drawInstances(GpuCommands& commands, InstanceRange range, bool world) {
  for (uint32_t i = range.begin; i < range.end; ++i) {
    const Instance& instance = numbered_.instances[i];
    vkCmdDraw(commands.handle(), 3 * instance.triangleCount, 1, 3 * (world ? instance.firstWorldTriangle : instance.firstTriangle), i);
  }
}

void SceneBuffers::transformAll() {
  GpuCommands commands(programs_.gpu());
  transform(commands, {0, numbered_.instanceCount()}, kTakeAll);
  commands.run();
}

}  // namespace gridscope
