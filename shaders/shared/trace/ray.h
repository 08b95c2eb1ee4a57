// Rays, how they are traced, and how they end.
// Structures are in scalar layout (GL_EXT_scalar_block_layout), typed once for C++ and the shaders.
#ifndef GRIDSCOPE_SHARED_RAY_H
#define GRIDSCOPE_SHARED_RAY_H

#include "shaders/shared/scene/scene.h"

BEGIN_SHARED

// A ray parameter beyond every scene.
const float kFar = 1e30f;

const uint kTraversalSegment = 0u;  // cell-sized segments: the paper's
const uint kTraversalDda = 1u;      // every pierced cell (Amanatides and Woo)

// Id of its specialization constant, after the grid's.
const int kConstantTraversal = 4;

// What the trace needs. Lengths in world units where not said otherwise.
struct TraceParameters {
  float tMin;            // hits nearer than this along the ray are not seen
  float back;            // how far a segment's window reaches back behind its start
  float ahead;           // how far it reaches ahead of its start: the segment itself and its elongation
  float gate;            // distance along the launch normal before which gaps are not filled
  uint gapFill;          // 1: report voxel hits
  uint traversal;        // kTraversal...
  uint maxSegments;      // segments (or cells, for dda) after which a ray ends with kHitLimit
  uint segmentsPerPass;  // segments one dispatch may take of each ray (the device's loop budget)
};

struct Ray {
  vec3 origin;        // world
  vec3 direction;     // unit
  vec3 launchNormal;  // geometric normal of the surface it leaves, unit; zero: gaps are never filled
  uint valid;         // 0: no ray for this pixel
};

SHARED vec3 rayPoint(Ray ray, float t) {
  return vec3(ray.origin.x + ray.direction.x * t, ray.origin.y + ray.direction.y * t, ray.origin.z + ray.direction.z * t);
}

// Why a ray ended. Every ray gets one; kHitUnfinished after the last pass, or kHitCut, fails the frame.
const uint kHitNoRay = 0u;
const uint kHitTriangle = 1u;
const uint kHitVoxel = 2u;       // gap-filled
const uint kHitMiss = 3u;        // left the grid, or never met it
const uint kHitLimit = 4u;       // maxSegments taken; counts as a miss
const uint kHitUnfinished = 5u;  // between two passes
const uint kHitCut = 6u;         // the driver cut a loop short: fails the frame

struct Hit {
  uint kind;       // kHit...
  float t;         // along the ray, world units; 0 where nothing was hit
  uint reference;  // kNoReference where nothing was hit
  float u;         // barycentrics of corners b and c, clamped to the triangle for a voxel hit
  float v;
};

SHARED Hit makeHit(uint kind, float t, uint reference) {
  Hit hit;
  hit.kind = kind;
  hit.t = t;
  hit.reference = reference;
  hit.u = 0.0f;
  hit.v = 0.0f;
  return hit;
}

SHARED Hit missedHit(uint kind) { return makeHit(kind, 0.0f, kNoReference); }

// What became of one segment of a ray (for dda: of one cell it pierces).
const uint kStepOutside = 0u;  // starts outside the grid
const uint kStepRevisit = 1u;  // starts in the cell visited last: skipped
const uint kStepEmpty = 2u;    // the cell's first slot is blank
const uint kStepRead = 3u;     // the cell's references are tested

// Where a ray goes on in the next pass.
struct TraceState {
  int segment;     // next segment (or cell, for dda) to take
  ivec3 cell;      // last visited cell (next cell, for dda)
  float enter;     // where the ray enters that cell (dda)
  float t;         // nearest hit so far (dda)
  uint reference;  // of it; kNoReference: none yet
};

// Push constants of the trace.
struct TraceArguments {
  uint firstRay;
  uint endRay;
  uint continues;  // 0: the first pass; 1: goes on where the states say
};

// What a recorded ray's words begin with, and the three kinds of entries, each with its number of words.
const uint kRecordSegment = 1u;  // kind, segment, start, cell x, y, z, outcome: 7 words
const uint kRecordTest = 2u;     // kind, slot, reference, verdict, t, alpha byte: 6 words
const uint kRecordCell = 3u;     // kind, references read, saturated, travel: 4 words

struct RayRecordHeader {
  uint wordCount;  // written, or wanted when larger than the capacity
  uint wordCapacity;
  Hit hit;
  TraceState state;
};

struct RayCounters {
  uint visits;  // cells whose first slot was read
  uint tests;   // triangle tests begun
};

// How often a cell was asked for its references in a frame.
struct CellRays {
  uint read;   // rays that tested its references
  uint empty;  // rays that found its first slot blank
};

#ifdef __cplusplus
static_assert(sizeof(TraceParameters) == 32 && sizeof(Ray) == 40 && sizeof(Hit) == 20 && sizeof(TraceState) == 28);
static_assert(sizeof(TraceArguments) == 12 && sizeof(RayRecordHeader) == 56 && sizeof(RayCounters) == 8 && sizeof(CellRays) == 8);
#endif

END_SHARED

#endif
