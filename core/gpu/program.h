// Pipelines of the passes, and the one descriptor set that all of them use. A pass, its shader, its pipeline, its label and its timer share
// one stem.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/gpu/commands.h"
#include "shaders/shared/pipeline/bindings.h"
#include "shaders/shared/pipeline/parameters.h"

namespace gridscope {

class GpuPrograms {
 public:
  explicit GpuPrograms(GpuContext& gpu);
  ~GpuPrograms();
  GpuPrograms(const GpuPrograms&) = delete;
  GpuPrograms& operator=(const GpuPrograms&) = delete;

  // Fills one binding. Until then it holds a placeholder: lavapipe looks at every binding of a set, touched by the pass or not.
  void bind(int binding, const GpuBuffer& buffer);
  void bind(int binding, const GpuImage& image, VkSampler sampler = VK_NULL_HANDLE);

  // Constants that pipelines made or found from now on are specialized for.
  void specialize(const SpecializedSettings& settings) { specialized_ = settings; }

  // Makes every pass of the program from its present shader. Throws Error for the first that the device refuses.
  void makeAll(VkFormat colour, VkFormat depth);

  // Records one workgroup of a pass with zeroed push constants: drivers compile at the first dispatch. True when the pass was cold.
  bool warm(GpuCommands& commands, const std::string& stem);

  // Records a dispatch that covers `invocations` along x, y and z. `arguments`: the pass' push constants, as many bytes as it declares.
  void dispatch(GpuCommands& commands, const std::string& stem, ivec3 invocations, std::span<const std::byte> arguments = {});
  // Records a dispatch whose workgroup counts lie in `buffer` at `offset`.
  void dispatchIndirect(GpuCommands& commands, const std::string& stem, const GpuBuffer& buffer, uint64_t offset,
                        std::span<const std::byte> arguments = {});

  // Graphics passes: bind one, then draw. raster: no attachment, nothing is rasterized.
  void bindBuildRaster(GpuCommands& commands);
  void bindGather(GpuCommands& commands, VkFormat colour, VkFormat depth, VkExtent2D extent);

 private:
  struct Program {
    VkPipeline pipeline = VK_NULL_HANDLE;
    uint32_t localSize[3] = {1, 1, 1};
    uint32_t pushConstantBytes = 0;
    bool warm = false;  // dispatched before
  };

  struct GraphicsState;
  struct GraphicsStage {
    VkShaderStageFlagBits stage;
    const char* ending;  // of the shader's stem, behind the pass' own
  };

  void writeDescriptor(int binding, const VkDescriptorBufferInfo* buffer, const VkDescriptorImageInfo* image);
  void bindPlaceholders();
  std::string key(const std::string& stem) const;  // of a pass with the present constants
  VkShaderModule makeModule(const std::string& stem);
  Program& program(const std::string& stem);
  void begin(GpuCommands& commands, const Program& program, const std::string& stem, std::span<const std::byte> arguments);
  VkPipeline graphics(const std::string& stem, std::initializer_list<GraphicsStage> stages, GraphicsState& state);
  VkPipeline buildRaster();
  VkPipeline gather(VkFormat colour, VkFormat depth);
  void bindGraphics(GpuCommands& commands, VkPipeline pipeline);

  GpuContext& gpu_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  GpuBuffer placeholder_;
  GpuImage placeholderImages_[3];  // of the three image bindings
  VkSampler placeholderSampler_ = VK_NULL_HANDLE;
  SpecializedSettings specialized_{};
  std::map<std::string, Program> programs_;     // by key()
  std::map<std::string, VkPipeline> graphics_;  // likewise
};

// The bytes of a structure, for push constants.
template <typename T>
std::span<const std::byte> bytesOf(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

}  // namespace gridscope
