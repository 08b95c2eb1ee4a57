// How many resources a stage of a pass may see on a device, and what a pass asks for.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/gpu/shader_facts.h"

namespace gridscope {

// Most of each kind that one shader stage may see; the names are Vulkan's.
struct PassLimits {
  uint32_t maxPerStageDescriptorStorageBuffers = 0;
  uint32_t maxPerStageDescriptorStorageImages = 0;
  uint32_t maxPerStageDescriptorSampledImages = 0;
  uint32_t maxPerStageDescriptorSamplers = 0;
  uint32_t maxPerStageResources = 0;  // all of them together, and the images that a fragment stage draws to
  uint32_t maxPushConstantsSize = 0;  // bytes
  uint32_t maxComputeWorkGroupInvocations = 0;
};

// Why a device can't run a pass with these facts, with both numbers; empty: it can.
std::string whyPassDoesNotFit(std::string_view stem, const ShaderFacts& facts, const PassLimits& limits);

// The same for all passes that the build embeds, those for a geometry stage only where there is one: the first that does not fit.
std::string whyPassesDoNotFit(const PassLimits& limits, bool geometryStage);

}  // namespace gridscope
