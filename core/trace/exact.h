// The exact answer to a ray: the nearest hit among all triangles of the scene, without a grid. Embree finds the candidates (robust mode, no
// culling); the trace's own test decides which are hits and at what distance, so that an exact hit and a traced hit of one triangle are
// the same number. Alpha keying and tMin as in the trace.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/trace/trace.h"

namespace gridscope {

class ExactReference {
 public:
  // Of the present world triangles. What `input` refers to must outlive this.
  explicit ExactReference(const TraceInput& input);
  ~ExactReference();
  ExactReference(ExactReference&&) noexcept;

  // kHitTriangle, kHitMiss, or kHitNoRay for a ray that is not valid. Of equal distances the smaller reference.
  Hit trace(const Ray& ray) const;

  // Of all rays, on all cores.
  std::vector<Hit> trace(std::span<const Ray> rays) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace gridscope
