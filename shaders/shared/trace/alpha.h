// Alpha keying of hits: one byte of the diffuse map's alpha, addressed in integers, decides. The includer defines, before including
// this: Instance loadInstance(uint), TraceMaterial loadMaterial(uint), vec2 loadUv(uint objectTriangle, uint corner) and
// uint loadAlpha(uint byteIndex). No include guard: C++ includes it inside a class that has these functions.

// Byte of the alpha map at a texture coordinate; 255 for a material without one.
SHARED uint alphaAt(TraceMaterial material, vec2 uv) {
  if (material.alphaWidth == 0u) return 255u;
  uint x = alphaTexel(uv.x, material.alphaWidth, material.wrapU);
  uint y = alphaTexel(uv.y, material.alphaHeight, material.wrapV);
  return loadAlpha(material.alphaFirstByte + y * material.alphaWidth + x);
}

// Texture coordinate of a triangle at barycentrics of corners b and c.
SHARED vec2 uvAt(uint objectTriangle, vec2 weights) {
  return interpolateUv(loadUv(objectTriangle, 0u), loadUv(objectTriangle, 1u), loadUv(objectTriangle, 2u), weights);
}

// Is the hit at `point` on the triangle of `reference` let through? `byteRead`: what decided; 256 when the material is not keyed.
SHARED bool alphaPasses(uint reference, Triangle world, vec3 point, OUT(uint) byteRead) {
  byteRead = 256u;
  Instance instance = loadInstance(referenceInstance(reference));
  TraceMaterial material = loadMaterial(instance.material);
  if ((material.flags & kMaterialAlphaKeyed) == 0u) return true;
  vec2 uv = uvAt(instance.firstTriangle + referenceTriangle(reference), barycentrics(world, point));
  byteRead = alphaAt(material, uv);
  return byteRead >= material.alphaThreshold;
}
