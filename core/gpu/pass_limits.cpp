// See pass_limits.h.
#include "core/gpu/pass_limits.h"

#include <algorithm>

#include "core/gpu/shader_code.h"

namespace gridscope {

std::string whyPassDoesNotFit(std::string_view stem, const ShaderFacts& facts, const PassLimits& limits) {
  const uint32_t buffers = facts.count(ResourceKind::storageBuffer), images = facts.count(ResourceKind::storageImage),
                 sampled = facts.count(ResourceKind::sampledImage), drawn = facts.stage == ShaderStage::fragment ? 1 : 0;
  const struct {
    const char* what;
    uint32_t wanted, most;
    const char* limit;
  } counts[] = {
      {"storage buffers", buffers, limits.maxPerStageDescriptorStorageBuffers, "maxPerStageDescriptorStorageBuffers"},
      {"storage images", images, limits.maxPerStageDescriptorStorageImages, "maxPerStageDescriptorStorageImages"},
      {"sampled images", sampled, limits.maxPerStageDescriptorSampledImages, "maxPerStageDescriptorSampledImages"},
      {"samplers", sampled, limits.maxPerStageDescriptorSamplers, "maxPerStageDescriptorSamplers"},
      {"resources", buffers + images + sampled + drawn, limits.maxPerStageResources, "maxPerStageResources"},
      {"bytes of push constants", facts.pushConstantBytes, limits.maxPushConstantsSize, "maxPushConstantsSize"},
      {"invocations a workgroup", facts.localSize[0] * facts.localSize[1] * facts.localSize[2], limits.maxComputeWorkGroupInvocations,
       "maxComputeWorkGroupInvocations"},
  };
  for (const auto& [what, wanted, most, limit] : counts)
    if (wanted > most)
      return "the pass " + std::string(stem) + " takes " + std::to_string(wanted) + " " + what + ", it offers " + std::to_string(most) +
             " (" + limit + ")";
  return "";
}

std::string whyPassesDoNotFit(const PassLimits& limits, bool geometryStage) {
  // Read once: the embedded passes never change.
  struct Pass {
    std::string_view stem;
    ShaderFacts facts;
  };
  static const std::vector<Pass> passes = [] {
    std::vector<Pass> read;
    for (const ShaderCode& shader : allShaders()) read.push_back({shader.stem, readFacts(shader.words)});
    return read;
  }();
  for (const Pass& pass : passes) {
    if (pass.facts.stage == ShaderStage::geometry && !geometryStage) continue;
    if (std::string why = whyPassDoesNotFit(pass.stem, pass.facts, limits); !why.empty()) return why;
  }
  return "";
}

}  // namespace gridscope
