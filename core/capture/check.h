// Whether a capture's arrays and parameters agree: what a stage would follow blindly leads somewhere.
#pragma once

#include "core/capture/capture.h"
#include "core/capture/columns.h"

namespace gridscope {

// World triangles of all instances, numbering.cpp's limit.
inline constexpr uint64_t kMostWorldTriangles = uint64_t{1} << 26;
inline constexpr uint64_t kMostPixels = uint64_t{1} << 26;

// Both throw Error that begins with the entry's name.
void checkCaptureInputs(const Capture& capture);
void checkCaptureProduct(const Capture& capture, Part part);  // one of grid, gather, rays, hits, counters

}  // namespace gridscope
