// Uploading a scene: triangles, corners, instances, materials, alpha maps, and the diffuse maps as layers of one array image.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/gpu/stages.h"

namespace gridscope {
namespace {

constexpr VkFormat kDiffuseFormat = VK_FORMAT_R8G8B8A8_SRGB;

const std::array<float, 256>& linearOfSrgb() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values;
    for (int i = 0; i < 256; ++i) {
      float s = float(i) / 255.0f;
      values[i] = s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
    }
    return values;
  }();
  return table;
}

uint8_t srgbOfLinear(float linear) {
  float s = linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
  return uint8_t(std::clamp(s * 255.0f + 0.5f, 0.0f, 255.0f));
}

// One texel of the resized image: the mean over the box of texels that it covers, or the bilinear blend when enlarged.
struct Axis {
  uint32_t first, last;  // texels covered, both included
  float blend;           // of `last` against `first`, when the image is enlarged; negative: mean
};

Axis coveredTexels(uint32_t texel, uint32_t size, uint32_t sourceSize) {
  float scale = float(sourceSize) / float(size);
  if (scale > 1.0f) {
    uint32_t first = uint32_t(float(texel) * scale), last = uint32_t(std::ceil(float(texel + 1) * scale)) - 1;
    return {std::min(first, sourceSize - 1), std::min(std::max(first, last), sourceSize - 1), -1.0f};
  }
  float centre = (float(texel) + 0.5f) * scale - 0.5f;
  float low = std::floor(centre);
  auto wrapped = [&](float at) { return uint32_t((int64_t(at) + sourceSize) % sourceSize); };
  return {wrapped(low), wrapped(low + 1.0f), centre - low};
}

// Resizes to a square layer in linear colour, colour weighted by nothing (alpha keying has maps of its own).
void resizeLayer(const Image& image, uint32_t size, std::span<uint8_t> layer) {
  for (uint32_t y = 0; y < size; ++y) {
    Axis rows = coveredTexels(y, size, image.height);
    for (uint32_t x = 0; x < size; ++x) {
      Axis columns = coveredTexels(x, size, image.width);
      float sum[3] = {}, weights = 0.0f;
      auto take = [&](uint32_t row, uint32_t column, float weight) {
        const uint8_t* texel = &image.rgba[4 * (size_t(row) * image.width + column)];
        for (int c = 0; c < 3; ++c) sum[c] += weight * linearOfSrgb()[texel[c]];
        weights += weight;
      };
      auto takeRow = [&](uint32_t row, float weight) {
        if (columns.blend >= 0.0f) {
          take(row, columns.first, weight * (1.0f - columns.blend));
          take(row, columns.last, weight * columns.blend);
        } else {
          for (uint32_t column = columns.first; column <= columns.last; ++column) take(row, column, weight);
        }
      };
      if (rows.blend >= 0.0f) {
        takeRow(rows.first, 1.0f - rows.blend);
        takeRow(rows.last, rows.blend);
      } else {
        for (uint32_t row = rows.first; row <= rows.last; ++row) takeRow(row, 1.0f);
      }
      uint8_t* out = &layer[4 * (size_t(y) * size + x)];
      for (int c = 0; c < 3; ++c) out[c] = srgbOfLinear(sum[c] / std::max(weights, 1e-6f));
      out[3] = 255;
    }
  }
}

void copyLayer(const Image& image, uint32_t size, std::span<uint8_t> layer) {
  if (image.width == size && image.height == size)
    std::copy(image.rgba.begin(), image.rgba.end(), layer.begin());
  else
    resizeLayer(image, size, layer);
}

}  // namespace

GpuStages::GpuStages(GpuContext& gpu, std::span<const Image> images, const NumberedScene& numbered, const FrameSettings& settings)
    : gpu_(gpu), numbered_(numbered), programs_(gpu) {
  uploadScene(numbered);
  uploadImages(images, settings.textureSize);
  makeTargets(settings.width, settings.height);
}

GpuStages::~GpuStages() { vkDestroySampler(gpu_.device(), sampler_, nullptr); }

void GpuStages::makeBuffer(int binding, const std::string& name, uint64_t byteCount) {
  buffers_[binding] = GpuBuffer(gpu_, name, byteCount);
  programs_.bind(binding, buffers_[binding]);
}

void GpuStages::uploadScene(const NumberedScene& numbered) {
  auto fill = [&](int binding, const std::string& name, const auto& values) {
    std::span span(values);
    makeBuffer(binding, name, span.size_bytes());
    uploadBytes(gpu_, buffers_[binding], std::as_bytes(span));
  };
  fill(kBindObjectTriangles, "object triangles", numbered.objectTriangles);
  fill(kBindCorners, "corners", numbered.corners);
  fill(kBindInstances, "instances", numbered.instances);
  fill(kBindMaterials, "materials", numbered.materials);
  fill(kBindAlphaBytes, "alpha maps", numbered.alphaBytes);
  makeBuffer(kBindWorldTriangles, "world triangles", uint64_t(numbered.triangleCount) * sizeof(Triangle));
  makeBuffer(kBindParameters, "parameters", sizeof(FrameParameters));
  makeBuffer(kBindBuildReport, "build report", sizeof(BuildReport));
  makeBuffer(kBindBigTriangles, "lists of big triangles", uint64_t(numbered.triangleCount) * kBigClassCount * sizeof(uint32_t));
  makeBuffer(kBindBigDispatch, "big dispatch", sizeof(BigDispatch));
  makeBuffer(kBindStatistics, "statistics", sizeof(GridStatistics));
  makeBuffer(kBindMovedInstances, "moved instances", (uint64_t(numbered.instanceCount()) / 32 + 1) * sizeof(uint32_t));
  makeBuffer(kBindUpdateCounts, "update counts", 2 * sizeof(uint32_t));
  makeBuffer(kBindTraceReport, "trace report", 2 * sizeof(uint32_t));
}

void GpuStages::uploadImages(std::span<const Image> images, uint32_t textureSize) {
  uint32_t layers = std::max<uint32_t>(1, uint32_t(images.size()));
  if (layers > gpu_.report().maxImageArrayLayers)
    throw Error("the scene has " + std::to_string(layers) + " images, but " + gpu_.report().name + " takes " +
                    std::to_string(gpu_.report().maxImageArrayLayers),
                kExitDevice);
  if (images.empty()) textureSize = 1;
  ImageShape shape{.viewType = VK_IMAGE_VIEW_TYPE_2D_ARRAY,
                   .format = kDiffuseFormat,
                   .extent = {textureSize, textureSize, 1},
                   .layers = layers,
                   .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT};
  diffuseMaps_ = GpuImage(gpu_, "diffuse maps", shape);
  std::vector<uint8_t> texels(size_t(4) * textureSize * textureSize * layers, 255);
  size_t layerBytes = size_t(4) * textureSize * textureSize;
  forRanges(images.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) copyLayer(images[i], textureSize, std::span(texels).subspan(i * layerBytes, layerBytes));
  });
  GpuCommands commands(gpu_);
  commands.layout(diffuseMaps_, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  commands.run();
  uploadImage(gpu_, diffuseMaps_, std::as_bytes(std::span(texels)));

  VkSamplerCreateInfo sampler{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  sampler.magFilter = sampler.minFilter = VK_FILTER_LINEAR;
  sampler.addressModeU = sampler.addressModeV = VK_SAMPLER_ADDRESS_MODE_REPEAT;
  VK_CHECK(vkCreateSampler(gpu_.device(), &sampler, nullptr, &sampler_));
  programs_.bind(kBindDiffuseMaps, diffuseMaps_, sampler_);
}

void GpuStages::setParameters(const FrameParameters& parameters) {
  parameters_ = parameters;
  const GridParameters& grid = parameters.grid;
  programs_.specialize({grid.overlap, grid.insertion, grid.stretchAxis, grid.reserved, parameters.trace.traversal});
  upload(gpu_, buffers_[kBindParameters], std::span<const FrameParameters>(&parameters, 1));
}

void GpuStages::warm(std::span<const std::string> stems) {
  FrameParameters nothing{};
  upload(gpu_, buffers_[kBindParameters], std::span<const FrameParameters>(&nothing, 1));
  GpuCommands commands(gpu_);
  zero(commands, kBindBigDispatch);
  commands.barrier();
  bool cold = false;
  for (const std::string& stem : stems) cold |= programs_.warm(commands, stem);
  if (cold) commands.run();
  upload(gpu_, buffers_[kBindParameters], std::span<const FrameParameters>(&parameters_, 1));
}

void GpuStages::setInstances(std::span<const Instance> instances) { upload(gpu_, buffers_[kBindInstances], instances); }

}  // namespace gridscope
