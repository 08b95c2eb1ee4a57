// See bound_resources.h.
#include "core/gpu/bound_resources.h"

namespace gridscope {

const GpuBuffer& BoundResources::makeBuffer(int binding, const std::string& name, uint64_t byteCount) {
  drop(binding);
  Place place{.buffer = GpuBuffer(gpu_, name, byteCount), .version = ++versions_};
  return places_.insert_or_assign(binding, std::move(place)).first->second.buffer;
}

const GpuImage& BoundResources::makeImage(int binding, const std::string& name, const ImageShape& shape, Owned<VkSampler> sampler) {
  drop(binding);
  Place place{.image = GpuImage(gpu_, name, shape), .sampler = std::move(sampler), .version = ++versions_};
  return places_.insert_or_assign(binding, std::move(place)).first->second.image;
}

void BoundResources::drop(int binding) { places_.erase(binding); }

const BoundResources::Place* BoundResources::find(int binding) const {
  auto found = places_.find(binding);
  return found == places_.end() ? nullptr : &found->second;
}

const GpuBuffer& BoundResources::buffer(int binding) const {
  const Place* place = find(binding);
  CHECK(place && place->buffer);
  return place->buffer;
}

const GpuImage& BoundResources::image(int binding) const {
  const Place* place = find(binding);
  CHECK(place && place->image);
  return place->image;
}

}  // namespace gridscope
