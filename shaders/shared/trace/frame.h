// One frame: the parameters of all its stages, and the gather buffer that rays are launched from.
// Structures are in scalar layout (GL_EXT_scalar_block_layout), typed once for C++ and the shaders.
#ifndef GRIDSCOPE_SHARED_FRAME_H
#define GRIDSCOPE_SHARED_FRAME_H

#include "shaders/shared/grid/parameters.h"
#include "shaders/shared/trace/ray.h"

BEGIN_SHARED

struct CameraParameters {
  vec3 eye;
  float nearPlane;      // distance, world units
  vec3 right;           // unit
  float tanHalfWidth;   // tangent of half the horizontal field of view
  vec3 up;              // unit
  float tanHalfHeight;  // tangent of half the vertical field of view
  vec3 forward;         // unit
  uint width;           // pixels
  uint height;          // pixels
};

struct BounceParameters {
  uint frame;
  uint seed;
  float roughness;     // 0..1: the most that a material's roughness counts
  float originOffset;  // along the geometric normal, world units
};

// What a view reads beside the products (views/view.h).
struct ViewParameters {
  float rangeLow;   // value at the low end of the colour map
  float rangeHigh;  // value at the high end
  uint colourMap;   // kColourMap... (palette.h)
  uint width;       // of the view's own image: pixels, or cells of a slice
  uint height;
  int sliceAxis;      // 0 x, 1 y, 2 z
  int sliceIndex;     // layer of cells
  float farDistance;  // world units: length of the scene's diagonal
  vec3 sunDirection;  // unit, towards the sun
};

// Everything of one frame, one storage buffer.
struct FrameParameters {
  GridParameters grid;
  TraceParameters trace;
  CameraParameters camera;
  BounceParameters bounce;
  ViewParameters view;
};

// One pixel of the gather buffer.
struct GatherPixel {
  vec3 position;         // world
  vec3 geometricNormal;  // unit, towards the camera
  vec3 shadingNormal;    // unit, on the same side
  vec2 barycentrics;     // of corners b and c
  float depth;           // distance from the eye, world units
  uint reference;        // instance << 16 | triangle; kNoReference: nothing seen
  uint material;
};

// Settings that branch inside loops. Shaders take them as specialization constants, in this order: drivers then leave the other branch out.
struct SpecializedSettings {
  uint overlap;
  uint insertion;
  int stretchAxis;
  int reserved;
  uint traversal;
};

#ifdef __cplusplus
static_assert(sizeof(CameraParameters) == 68 && sizeof(BounceParameters) == 16 && sizeof(ViewParameters) == 44);
static_assert(sizeof(FrameParameters) == 244 && sizeof(GatherPixel) == 56);
#endif

END_SHARED

#endif
