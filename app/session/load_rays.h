// Rays of a person's own, from a .npy file, instead of the bounce's.
#pragma once

#include <string>
#include <vector>

#include "app/session/options.h"
#include "core/base/npy.h"

namespace gridscope {

struct LoadedRays {
  std::vector<Ray> rays;  // empty: the bounce makes them
  FrameSize size{};       // of the frame that they fill
  std::string note;       // what was changed about them; empty: nothing
};

// Reads --rays; nothing when it was not given. Throws Error.
LoadedRays loadRays(const Options& options);

// The same from an array: float32 or float64 of shape (H, W, 6 | 9) or (N, 6 | 9). `size`: what a list of N fills; N x 1 when not given.
LoadedRays raysFrom(const NpyArray& array, std::optional<FrameSize> size);

}  // namespace gridscope
