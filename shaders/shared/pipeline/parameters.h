// Every structure that C++ and the shaders exchange, in scalar layout (GL_EXT_scalar_block_layout), typed once. Settings that a
// person makes are in core/grid/settings.h; what derives from them is computed once in C++ (core/parameters.cpp) and passed as bits.
#ifndef GRIDSCOPE_SHARED_PARAMETERS_H
#define GRIDSCOPE_SHARED_PARAMETERS_H

#include "shaders/shared/base/language.h"

BEGIN_SHARED

// A slot that holds no reference.
const uint kBlank = 0xFFFFFFFFu;

const uint kInsertionSorted = 0u;     // atomicMin chain: slot k ends with the k-th smallest reference
const uint kInsertionFirstCome = 1u;  // compare and swap: the paper's; slot order depends on the race

const uint kOverlapPlane = 0u;  // the triangle's plane meets the cell's enlarged bounding sphere: the paper's
const uint kOverlapExact = 1u;  // the triangle meets the enlarged cube (Akenine-Moeller)

// A ray parameter beyond every scene.
const float kFar = 1e30f;

const uint kTraversalSegment = 0u;  // cell-sized segments: the paper's
const uint kTraversalDda = 1u;      // every pierced cell (Amanatides and Woo)

// The grid's shape, and what the build needs. A cell owns `capacity` slots in a row along the stretched axis and `reserved`
// texels behind them.
struct GridParameters {
  vec3 origin;               // world position of the low corner of cell (0, 0, 0)
  float cellEdge;            // world units
  ivec3 cellCount;           // x, y, z
  float inverseCellEdge;     // 1 / cellEdge, rounded from double
  int capacity;              // slots of a cell
  int reserved;              // 2: static and dynamic refused, counted; 1: a flag, nonzero when saturated; 0: none
  int stride;                // capacity + reserved: texels of a cell along the stretched axis
  int stretchAxis;           // 0 x, 1 y, 2 z
  float planeRadiusSquared;  // (enlargement * half of the cell's diagonal)^2, world units squared
  float boxHalfEdge;         // enlargement * cellEdge / 2: half edge of the enlarged cube, world units
  uint overlap;              // kOverlap...
  uint insertion;            // kInsertion...
  uint staticInstanceCount;  // instances below this number are static
  uint instanceCount;
  uint staticTriangleCount;  // world triangles of the static instances; they come first
  uint triangleCount;        // world triangles of all instances
  uint cellsPerInvocation;   // most cells that one invocation may walk (the device's loop budget)
};

// Settings that branch inside loops. Shaders take them as specialization constants, in this order: drivers then leave the other branch out.
struct SpecializedSettings {
  uint overlap;
  uint insertion;
  int stretchAxis;
  int reserved;
  uint traversal;
};

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

// One instance: a piece of a mesh (at most 65,536 triangles) placed in the world. Its number is the high half of a reference.
struct Instance {
  vec4 row0;  // object to world: world.x = row0.x * x + row0.y * y + row0.z * z + row0.w
  vec4 row1;
  vec4 row2;
  uint firstTriangle;  // of its piece in the object-space triangles
  uint triangleCount;
  uint firstWorldTriangle;  // of its copy in the world triangles
  uint material;
};

// Corners of one triangle. Object space in the `objectTriangles` buffer, world space in `worldTriangles`.
struct Triangle {
  vec3 a;
  vec3 b;
  vec3 c;
};

// What shading and alpha keying need of one corner of an object-space triangle; 3 a triangle.
struct Corner {
  vec3 normal;  // object space, unit
  vec2 uv;
  uint colour;  // linear RGBA, 8 bits each, red lowest
};

const uint kMaterialAlphaKeyed = 1u;
const uint kMaterialUnlit = 2u;
const uint kMaterialDoubleSided = 4u;

const uint kNoLayer = 0xFFFFFFFFu;

struct TraceMaterial {
  vec4 baseColour;  // linear
  float metallic;
  float roughness;
  uint flags;  // kMaterial... bits
  uint layer;  // of the diffuse map in the array image; kNoLayer: none
  uint wrapU;  // 0 repeat, 1 mirror, 2 clamp
  uint wrapV;
  uint alphaFirstByte;  // of its alpha map in the alpha bytes
  uint alphaWidth;      // texels; 0: no map
  uint alphaHeight;
  uint alphaThreshold;  // a hit counts when its byte >= this; 0..256
};

// One pixel of the gather buffer.
struct GatherPixel {
  vec3 position;         // world
  vec3 geometricNormal;  // unit, towards the camera
  vec3 shadingNormal;    // unit, on the same side
  vec2 barycentrics;     // of corners b and c
  float depth;           // distance from the eye, world units
  uint reference;        // instance << 16 | triangle; kBlank: nothing seen
  uint material;
};

struct Ray {
  vec3 origin;        // world
  vec3 direction;     // unit
  vec3 launchNormal;  // geometric normal of the surface it leaves, unit; zero: gaps are never filled
  uint valid;         // 0: no ray for this pixel
};

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
  uint reference;  // kBlank where nothing was hit
  float u;         // barycentrics of corners b and c, clamped to the triangle for a voxel hit
  float v;
};

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
  uint reference;  // of it; kBlank: none yet
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

// What build and update report, one storage buffer of 32-bit words. Sums of each half are modulo 2^32.
struct BuildReport {
  uint tried;          // references that an overlap test let through
  uint stored;         // of those, found a slot
  uint refused;        // of those, did not
  uint outside;        // triangles whose bounding box reaches beyond the grid
  uint degenerate;     // triangles without area, not inserted
  uint cellsExpected;  // cells of all bounding boxes
  uint cellsWalked;    // cells looked at: differs when a loop was cut short
  uint loopsCut;       // slot loops that ended without a reason
};

// Most cells of a bounding box that the invocation which finds a triangle walks itself; more goes to the lists of big triangles.
const uint kSmallCells = 32u;

// The lists of triangles too big for one invocation, by size class: each triangle of class c is walked by 8^c workgroups. 8^5 workgroups
// of 64 take 2^21 invocations: with the last class, even a box of 2^30 texels stays within the loop budget (512 / stride cells each).
const int kBigClassCount = 6;
const uint kBigGroupSize = 64u;  // invocations of a workgroup
const uint kBigCells = 16u;      // most cells of an invocation in all classes but the last

// Sizes of the indirect dispatches over the lists: what vkCmdDispatchIndirect reads comes first.
struct BigDispatch {
  uvec3 groups[kBigClassCount];
  uint counts[kBigClassCount];  // triangles in each list
};

// Which triangles a pass over instances takes.
const uint kTakeAll = 0u;
const uint kTakeMoved = 1u;   // instances whose bit is set in the moved-instances words
const uint kTakeOthers = 2u;  // instances whose bit is not

// Push constants of the passes over instances.
struct PassArguments {
  uint firstInstance;
  uint endInstance;
  uint firstTriangle;  // world triangle of firstInstance
  uint endTriangle;    // world triangle behind the last instance
  uint take;           // kTake...
  uint bigClass;       // list of big triangles
};

// Bits of a cell's mark in the update `moved`.
const uint kCellTouched = 1u;  // a moved instance left or entered it
const uint kCellRebuilt = 2u;  // its dynamic part is rebuilt from all dynamic instances

// Sums over all cells. The histogram of occupancy (capacity + 1 words) lies in a buffer of its own.
struct GridStatistics {
  uint staticStored;
  uint dynamicStored;
  uint staticRefused;  // sums modulo 2^32
  uint dynamicRefused;
  uint occupied;   // cells with a reference
  uint saturated;  // cells that refused one or more
  uint maxDemand;  // stored + refused of the fullest cell
};

#ifdef __cplusplus
static_assert(sizeof(GridParameters) == 84 && sizeof(TraceParameters) == 32 && sizeof(CameraParameters) == 68);
static_assert(sizeof(BounceParameters) == 16 && sizeof(ViewParameters) == 44 && sizeof(FrameParameters) == 244);
static_assert(sizeof(Instance) == 64 && sizeof(Triangle) == 36 && sizeof(Corner) == 24 && sizeof(TraceMaterial) == 56);
static_assert(sizeof(GatherPixel) == 56 && sizeof(Ray) == 40 && sizeof(Hit) == 20 && sizeof(TraceState) == 28);
static_assert(sizeof(BigDispatch) == 96 && sizeof(PassArguments) == 24);
static_assert(sizeof(TraceArguments) == 12 && sizeof(RayRecordHeader) == 56);
static_assert(sizeof(RayCounters) == 8 && sizeof(BuildReport) == 32 && sizeof(GridStatistics) == 28);
#endif

END_SHARED

#endif
