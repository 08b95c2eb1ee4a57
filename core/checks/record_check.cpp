// See record_check.h.
#include "core/checks/record_check.h"
#include "shaders/shared/base/hash.h"

#include <cstring>

namespace gridscope {

RecordComparison compareRecords(Pipeline& pipeline, uint32_t count) {
  const std::vector<Hit> hits = pipeline.hits();
  std::vector<uint32_t> pixels;
  for (uint32_t i = 0; i < hits.size(); ++i)
    if (hits[i].kind != kHitNoRay) pixels.push_back(i);
  RecordComparison comparison;
  if (pixels.empty()) return comparison;
  for (; comparison.compared < count; ++comparison.compared) {
    const uint32_t pixel = pixels[hashOf(comparison.compared) % pixels.size()];
    const Hit recorded = pipeline.record(pixel).hit;
    if (std::memcmp(&recorded, &hits[pixel], sizeof(Hit)) != 0) comparison.different.push_back(pixel);
  }
  return comparison;
}

}  // namespace gridscope
