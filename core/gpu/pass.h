// One pass made for a device: its pipeline, and a descriptor set of its own that holds what its code touches and nothing else.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/gpu/bound_resources.h"
#include "core/gpu/shader_facts.h"

namespace gridscope {

using ShaderConstants = std::map<uint32_t, uint32_t>;  // values of specialization constants by their ids

// What a graphics pass draws to: triangles without vertex buffers, no culling, no blending.
struct DrawTargets {
  VkFormat colour = VK_FORMAT_UNDEFINED;  // undefined: nothing is rasterized
  VkFormat depth = VK_FORMAT_UNDEFINED;   // reversed: near is 1
};

struct PassDescription {
  std::string stem;                  // of the pass, its label and its timer
  std::vector<std::string> shaders;  // stems of its stages
  std::optional<DrawTargets> draws;  // a graphics pass
};

// A compute pass, whose one shader has its stem.
PassDescription computePass(const std::string& stem);

class GpuPass {
 public:
  // Throws Error when the device has too few bindings for it, or refuses it.
  GpuPass(const GpuDevice& gpu, const PassDescription& description, const ShaderConstants& constants);

  const uint32_t* localSize() const { return localSize_; }
  uint32_t pushConstantBytes() const { return pushConstantBytes_; }

  // Records the pass' pipeline, resources and push constants (as many bytes as it declares). What was put at a binding since the last time is
  // written to the set first: no commands that use the set may be under way, or recorded and not yet run, when that happens. Throws Error when
  // nothing is at a binding that the pass touches.
  void begin(VkCommandBuffer commands, const BoundResources& bound, std::span<const std::byte> arguments);

 private:
  struct Use {
    VkDescriptorSetLayoutBinding layout{};
    std::string name;             // in the shader
    uint64_t versionWritten = 0;  // BoundResources::Place::version; 0: none yet
  };

  void readShaders(const PassDescription& description);
  void makeLayout();
  void makePipeline(const PassDescription& description, const ShaderConstants& constants);
  void write(Use& use, const BoundResources& bound);

  const GpuDevice& gpu_;
  std::string stem_;
  VkPipelineBindPoint bindPoint_;
  VkShaderStageFlags stages_ = 0;
  std::map<uint32_t, Use> uses_;  // by binding
  uint32_t localSize_[3] = {1, 1, 1};
  uint32_t pushConstantBytes_ = 0;
  Owned<VkDescriptorSetLayout> setLayout_;
  Owned<VkPipelineLayout> layout_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;  // the pool's
  Owned<VkPipeline> pipeline_;
};

}  // namespace gridscope
