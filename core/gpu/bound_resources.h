// What stands behind each binding number. The table owns it: a pass can't read what is gone. Passes look here when they run (program.h).
#pragma once

#include <map>
#include <string>

#include "core/gpu/resources.h"

namespace gridscope {

class BoundResources {
 public:
  struct Place {
    GpuBuffer buffer;          // either this
    GpuImage image;            // or this, with
    Owned<VkSampler> sampler;  // where it is sampled
    uint64_t version = 0;      // another number for each content that the place ever had
  };

  explicit BoundResources(const GpuDevice& gpu) : gpu_(gpu) {}

  // Puts a new buffer, or image, at a binding; what was there goes before.
  const GpuBuffer& makeBuffer(int binding, const std::string& name, uint64_t byteCount);
  const GpuImage& makeImage(int binding, const std::string& name, const ImageShape& shape, Owned<VkSampler> sampler = {});
  void drop(int binding);

  const Place* find(int binding) const;  // nullptr: nothing is there
  bool has(int binding) const { return find(binding) != nullptr; }
  const GpuBuffer& buffer(int binding) const;  // there must be one
  const GpuImage& image(int binding) const;
  uint64_t byteCount(int binding) const { return has(binding) ? buffer(binding).byteCount() : 0; }

 private:
  const GpuDevice& gpu_;
  std::map<int, Place> places_;
  uint64_t versions_ = 0;
};

}  // namespace gridscope
