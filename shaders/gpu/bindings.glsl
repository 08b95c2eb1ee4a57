// The one descriptor set that every pass uses, and the plain loads that the shared files ask for.
#include "shaders/shared/gpu/bindings.h"
#include "shaders/shared/scene/triangle.h"
#include "shaders/shared/trace/frame.h"

layout(set = 0, binding = kBindVisibility, r32ui) uniform readonly uimage2D visibilityImage;
layout(set = 0, binding = kBindDiffuseMaps) uniform sampler2DArray diffuseMaps;
layout(scalar, set = 0, binding = kBindParameters) readonly buffer ParametersBuffer { FrameParameters parameters; };
layout(scalar, set = 0, binding = kBindObjectTriangles) readonly buffer ObjectTrianglesBuffer { Triangle objectTriangles[]; };
layout(scalar, set = 0, binding = kBindCorners) readonly buffer CornersBuffer { Corner corners[]; };
layout(scalar, set = 0, binding = kBindInstances) readonly buffer InstancesBuffer { Instance instances[]; };
layout(scalar, set = 0, binding = kBindMaterials) readonly buffer MaterialsBuffer { TraceMaterial materials[]; };
layout(scalar, set = 0, binding = kBindAlphaBytes) readonly buffer AlphaBytesBuffer { uint alphaBytes[]; };
#ifndef WRITES_WORLD_TRIANGLES
#define WRITES_WORLD_TRIANGLES readonly
#endif
layout(scalar, set = 0, binding = kBindWorldTriangles) WRITES_WORLD_TRIANGLES buffer WorldTrianglesBuffer { Triangle worldTriangles[]; };

layout(constant_id = kConstantTraversal) const uint kSpecializedTraversal = 0u;

TraceParameters traceParameters() {
  TraceParameters trace = parameters.trace;
  trace.traversal = kSpecializedTraversal;
  return trace;
}

Instance loadInstance(uint instance) { return instances[instance]; }
TraceMaterial loadMaterial(uint material) { return materials[material]; }
vec2 loadUv(uint objectTriangle, uint corner) { return corners[3u * objectTriangle + corner].uv; }
uint loadAlpha(uint byteIndex) { return (alphaBytes[byteIndex >> 2] >> (8u * (byteIndex & 3u))) & 255u; }
Triangle loadWorldTriangle(uint index) { return worldTriangles[index]; }
