// Where a triangle is hit: its normals in the world.

// Normal of a direction's transform: by cofactors, so that mirrored and unevenly scaled instances come out right.
vec3 transformNormal(Instance instance, vec3 normal) {
  vec3 x = instance.row0.xyz;
  vec3 y = instance.row1.xyz;
  vec3 z = instance.row2.xyz;
  return vec3(dot(cross(y, z), normal), dot(cross(z, x), normal), dot(cross(x, y), normal));
}

vec3 safeNormalize(vec3 vector, vec3 otherwise) {
  float squared = dot(vector, vector);
  return squared > 1e-30 ? vector * inversesqrt(squared) : otherwise;
}

// Interpolated normal at barycentrics of corners b and c, unit, on the side of `facing` (a unit normal).
vec3 shadingNormal(uint reference, vec2 weights, vec3 facing) {
  Instance instance = instances[referenceInstance(reference)];
  uint corner = 3u * (instance.firstTriangle + referenceTriangle(reference));
  vec3 normal = corners[corner].normal * (1.0 - weights.x - weights.y) + corners[corner + 1u].normal * weights.x +
                corners[corner + 2u].normal * weights.y;
  normal = safeNormalize(transformNormal(instance, normal), facing);
  return dot(normal, facing) < 0.0 ? -normal : normal;
}
