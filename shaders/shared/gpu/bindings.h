// Binding numbers of the one descriptor set that every pass uses. bindings.glsl declares them; core/gpu_bindings.cpp fills them.
#ifndef GRIDSCOPE_SHARED_BINDINGS_H
#define GRIDSCOPE_SHARED_BINDINGS_H

#include "shaders/shared/base/language.h"

BEGIN_SHARED

const int kBindGrid = 0;             // 3D image, r32ui
const int kBindVisibility = 1;       // 2D image, r32ui: reference seen at each pixel
const int kBindDiffuseMaps = 2;      // array image with sampler
const int kBindParameters = 3;       // FrameParameters, one
const int kBindObjectTriangles = 4;  // Triangle
const int kBindCorners = 5;          // Corner, 3 an object triangle
const int kBindInstances = 6;        // Instance
const int kBindMaterials = 7;        // TraceMaterial
const int kBindAlphaBytes = 8;       // 4 bytes a word
const int kBindWorldTriangles = 9;   // Triangle
const int kBindBuildReport = 10;     // BuildReport, one
const int kBindBigTriangles = 11;    // world triangle numbers, kBigClassCount lists of triangleCount each
const int kBindBigDispatch = 12;     // BigDispatch, one
const int kBindStatistics = 13;      // GridStatistics, one
const int kBindHistogram = 14;       // cells by occupancy: capacity + 1 words
const int kBindGather = 15;          // GatherPixel
const int kBindRays = 16;            // Ray
const int kBindHits = 17;            // Hit
const int kBindCounters = 18;        // RayCounters
const int kBindTraceStates = 19;     // TraceState
const int kBindTraceReport = 20;     // words: rays unfinished, rays cut
const int kBindViewElements = 21;    // ViewElement
const int kBindMovedInstances = 22;  // bits: instance moved
const int kBindCellMarks = 23;       // bits of update `moved`, a word a cell
const int kBindRayRecord = 24;       // words of the recording trace
const int kBindUpdateCounts = 25;    // words: cells touched, cells rebuilt (update `moved`)
const int kBindTruths = 26;          // RayTruth
const int kBindTriangleCosts = 27;   // uint: rays lost to each world triangle
const int kBindCellRays = 28;        // CellRays, a cell (x fastest)
const int kBindStableCells = 29;     // uint: kStable... of each cell, first-come builds
const int kBindStableRays = 30;      // uint: 1: the ray's result changes among the builds
const int kBindCellUpdates = 31;     // CellUpdate, a cell

END_SHARED

#endif
