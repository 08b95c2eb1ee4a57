// What a compiled pass says of itself: what it reads and writes, how large its workgroups are, what it is specialized by.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gridscope {

enum class ShaderStage { vertex, geometry, fragment, compute };

enum class ResourceKind { storageBuffer, storageImage, sampledImage };  // sampledImage: with its sampler

// Something outside that the pass' code touches.
struct ShaderResource {
  uint32_t binding = 0;
  ResourceKind kind = ResourceKind::storageBuffer;
  std::string name;  // of the block or the image, as the source has it
};

struct ShaderFacts {
  ShaderStage stage = ShaderStage::compute;
  uint32_t localSize[3] = {1, 1, 1};
  uint32_t pushConstantBytes = 0;
  std::vector<ShaderResource> resources;  // by rising binding; what is declared and never touched is left out
  std::vector<uint32_t> constants;        // ids of the specialization constants that count, rising

  uint32_t count(ResourceKind kind) const;
};

ShaderFacts readFacts(std::span<const uint32_t> words);

// The same module without the resources that its code never touches: to the device, what is declared is used.
std::vector<uint32_t> withoutUnused(std::span<const uint32_t> words);

// The same module with NoContraction on every float operation, and, where the device has them, rounding to nearest even and preserved
// signed zeros asked for: what C++ does. Without it drivers may fuse a * b + c.
std::vector<uint32_t> makeExact(std::span<const uint32_t> words, bool roundingControl);

}  // namespace gridscope
