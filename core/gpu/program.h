// The passes over one table of bindings: each is made when it is first asked for, once for each set of constants that it is specialized by.
// A pass, its shader, its pipeline, its label and its timer share one stem.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/gpu/commands.h"
#include "core/gpu/pass.h"
#include "shaders/shared/base/language.h"

namespace gridscope {

class GpuPrograms {
 public:
  explicit GpuPrograms(const GpuDevice& gpu) : gpu_(gpu), bound_(gpu) {}
  GpuPrograms(const GpuPrograms&) = delete;
  GpuPrograms& operator=(const GpuPrograms&) = delete;

  const GpuDevice& gpu() const { return gpu_; }
  BoundResources& bound() { return bound_; }

  // Constants that passes recorded from now on are specialized for; the others stay.
  void specialize(const ShaderConstants& constants);

  // Makes a pass from its present shader. Throws Error when the device refuses it.
  void make(const PassDescription& description) { variant(description); }

  // Records one workgroup of a compute pass with zeroed push constants: drivers compile at the first dispatch. True when the pass was cold.
  bool warm(GpuCommands& commands, const std::string& stem);

  // Records a dispatch that covers `invocations` along x, y and z. `arguments`: the pass' push constants, as many bytes as it declares.
  void dispatch(GpuCommands& commands, const std::string& stem, ivec3 invocations, std::span<const std::byte> arguments = {});
  // Records a dispatch whose workgroup counts lie in the buffer at `countsBinding`, from `offset` on.
  void dispatchIndirect(GpuCommands& commands, const std::string& stem, int countsBinding, uint64_t offset,
                        std::span<const std::byte> arguments = {});
  // Records that the buffer at a binding is filled with zeros.
  void zero(GpuCommands& commands, int binding);

  // Records the draws of a graphics pass over `extent`, inside a rendering that the caller has begun.
  void draw(GpuCommands& commands, const PassDescription& description, VkExtent2D extent, const std::function<void()>& draws);

  // To and from the buffer at a binding. Counts are the caller's to get right.
  template <typename T>
  std::vector<T> read(int binding, size_t count) const {
    return download<T>(gpu_, bound_.buffer(binding), count);
  }
  template <typename T>
  void write(int binding, std::span<const T> values) {
    upload(gpu_, bound_.buffer(binding), values);
  }

 private:
  struct Variant {
    GpuPass pass;
    bool warm = false;  // dispatched before
    Variant(const GpuDevice& gpu, const PassDescription& description, const ShaderConstants& constants)
        : pass(gpu, description, constants) {}
  };
  struct Variants {
    std::vector<uint32_t> constants;             // ids that the pass is specialized by
    std::map<ShaderConstants, Variant> byValue;  // of those; what is not given keeps the shader's own value
  };

  Variant& variant(const PassDescription& description);

  const GpuDevice& gpu_;
  BoundResources bound_;
  ShaderConstants constants_;
  std::map<std::string, Variants> variants_;  // by stem
};

// The bytes of a structure, for push constants.
template <typename T>
std::span<const std::byte> bytesOf(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

}  // namespace gridscope
