// What the stages know of a scene: instances, triangles, corners, materials, and the references that name a triangle.
// Structures are in scalar layout (GL_EXT_scalar_block_layout), typed once for C++ and the shaders.
#ifndef GRIDSCOPE_SHARED_SCENE_H
#define GRIDSCOPE_SHARED_SCENE_H

#include "shaders/shared/base/language.h"

BEGIN_SHARED

// A reference: 32 bits that name a triangle. Low 16 bits: triangle within the instance's geometry; high 16 bits: instance.
const uint kNoReference = 0xFFFFFFFFu;  // names none: no instance has this number

SHARED uint makeReference(uint instance, uint triangle) { return (instance << 16) | triangle; }
SHARED uint referenceInstance(uint reference) { return reference >> 16; }
SHARED uint referenceTriangle(uint reference) { return reference & 0xFFFFu; }

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

#ifdef __cplusplus
static_assert(sizeof(Instance) == 64 && sizeof(Triangle) == 36 && sizeof(Corner) == 24 && sizeof(TraceMaterial) == 56);
#endif

END_SHARED

#endif
