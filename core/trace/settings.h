// What a person can set of a frame beside its grid, with its default. Lengths are in cell edges where not said otherwise. derive.h turns
// settings into the parameters that the stages read.
#pragma once

#include <cstdint>

#include "core/grid/settings.h"
#include "shaders/shared/trace/ray.h"

namespace gridscope {

// What its values are called, on the command line and in every table.
constexpr const char* traversalWord(uint32_t traversal) { return traversal == kTraversalDda ? "dda" : "segment"; }

struct TraceSettings {
  uint32_t traversal = kTraversalSegment;  // kTraversal...
  float back = 1.0f;                       // how far a segment's window reaches back
  float ahead = 0.75f;                     // how far it reaches beyond the segment's end
  float tMin = 1e-3f;                      // nearest hit that counts
  bool gapFill = true;
  float gate = 1.75f;        // distance along the launch normal before which gaps are not filled
  uint32_t maxSegments = 0;  // 0: enough to cross the grid
};

struct BounceSettings {
  uint32_t seed = 1;
  float roughness = 0.15f;  // 0..1, the most: rougher materials mirror as if they were this glossy; 1: their own
};

struct FrameSettings {
  GridSettings grid;
  TraceSettings trace;
  BounceSettings bounce;
  uint32_t width = 640;  // pixels of gather, rays and hits
  uint32_t height = 360;
  CameraPose camera;
  uint32_t textureSize = 512;  // texels of a diffuse map's side on the device
};

}  // namespace gridscope
