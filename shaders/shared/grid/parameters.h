// The grid as its stages read it, and what build, update and statistics report. Settings that a person makes are in core/grid/settings.h;
// what derives from them is computed once in C++ (core/grid/derive.cpp) and passed as bits.
// Structures are in scalar layout (GL_EXT_scalar_block_layout), typed once for C++ and the shaders.
#ifndef GRIDSCOPE_SHARED_GRID_PARAMETERS_H
#define GRIDSCOPE_SHARED_GRID_PARAMETERS_H

#include "shaders/shared/scene/scene.h"

BEGIN_SHARED

// A slot that holds no reference.
const uint kBlank = kNoReference;

const uint kInsertionSorted = 0u;     // atomicMin chain: slot k ends with the k-th smallest reference
const uint kInsertionFirstCome = 1u;  // compare and swap: the paper's; slot order depends on the race

const uint kOverlapPlane = 0u;  // the triangle's plane meets the cell's enlarged bounding sphere: the paper's
const uint kOverlapExact = 1u;  // the triangle meets the enlarged cube (Akenine-Moeller)

// Ids of specialization constants: settings that branch inside loops, so that drivers leave the other branch out. kConstantTraversal is the next.
const int kConstantOverlap = 0;
const int kConstantInsertion = 1;
const int kConstantStretchAxis = 2;
const int kConstantReserved = 3;

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
static_assert(sizeof(GridParameters) == 84 && sizeof(BigDispatch) == 96 && sizeof(PassArguments) == 24);
static_assert(sizeof(BuildReport) == 32 && sizeof(GridStatistics) == 28);
#endif

END_SHARED

#endif
