// A trace without some of its events: the same traversal, in which a cell shows a reference that it refused, a gap is not filled, a cell is
// asked once more. The exact hit is no input of it.
#pragma once

#include <span>

#include "core/truth/cause.h"

namespace gridscope {

// The record of a ray without the events `removed`.
RayRecord recordWithout(const TraceInput& input, const Ray& ray, std::span<const TruthEvent> removed);

}  // namespace gridscope
