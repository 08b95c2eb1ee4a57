// Which case of its cause a ray's event is: alpha keying that turned a hit down or let one through, a triangle without an area or one that
// the overlap test kept out. Told from the frame and the evidence of the ray.
#pragma once

#include <string_view>

#include "core/truth/truth.h"

namespace gridscope {

// `key` in JSON ("letThrough"), `about` one sentence. Both empty for causes that have one case only.
struct TruthReason {
  std::string_view key;
  std::string_view about;
};

// `truth`: of this ray.
TruthReason reasonOf(const TruthInput& input, const Ray& ray, const RayTruth& truth);

}  // namespace gridscope
