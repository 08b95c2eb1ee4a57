// Gather, fragment stage: the reference seen; alpha keyed by the same bytes as the trace.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/shared/trace/alpha.h"

layout(location = 0) flat in uint inReference;
layout(location = 1) in vec2 inUv;
layout(location = 0) out uint outReference;

void main() {
  TraceMaterial material = materials[instances[referenceInstance(inReference)].material];
  if ((material.flags & kMaterialAlphaKeyed) != 0u && alphaAt(material, inUv) < material.alphaThreshold) discard;
  outReference = inReference;
}
