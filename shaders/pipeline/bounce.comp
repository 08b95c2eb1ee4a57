// One glossy reflection a pixel: the mirror direction, perturbed within the material's lobe by a hash of pixel, frame and seed.
// Lobe: Trowbridge and Reitz, Average Irregularity Representation of a Rough Surface for Ray Reflection, 1975 (GGX).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/scene/surface.glsl"
layout(scalar, set = 0, binding = kBindGather) readonly buffer GatherBuffer { GatherPixel gatherPixels[]; };
layout(scalar, set = 0, binding = kBindRays) writeonly buffer RaysBuffer { Ray rays[]; };

layout(local_size_x = 8, local_size_y = 8) in;

// Hash of one word. Source: Jarzynski and Olano, Hash Functions for GPU Rendering, 2020 (pcg).
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

float unitFloat(uint bits) { return float(bits >> 8) * (1.0 / 16777216.0); }

// A normal of the lobe around `normal`.
vec3 lobeNormal(vec3 normal, float roughness, vec2 random) {
  float alpha = roughness * roughness;
  float cosine = sqrt((1.0 - random.x) / (1.0 + (alpha * alpha - 1.0) * random.x));
  float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
  float angle = 6.28318531 * random.y;
  vec3 tangent = normalize(abs(normal.y) < 0.9 ? cross(normal, vec3(0.0, 1.0, 0.0)) : cross(normal, vec3(1.0, 0.0, 0.0)));
  vec3 bitangent = cross(normal, tangent);
  return normalize(tangent * (sine * cos(angle)) + bitangent * (sine * sin(angle)) + normal * cosine);
}

void main() {
  uvec2 place = gl_GlobalInvocationID.xy;
  if (place.x >= parameters.camera.width || place.y >= parameters.camera.height) return;
  uint index = place.y * parameters.camera.width + place.x;
  Ray ray = Ray(vec3(0.0), vec3(0.0), vec3(0.0), 0u);
  GatherPixel pixel = gatherPixels[index];
  if (pixel.reference != kNoReference) {
    uint first = hash(index ^ hash(parameters.bounce.frame ^ hash(parameters.bounce.seed)));
    float roughness = min(materials[pixel.material].roughness, parameters.bounce.roughness);
    vec3 facing = lobeNormal(pixel.shadingNormal, roughness, vec2(unitFloat(first), unitFloat(hash(first))));

    // Mirrored; a direction into the surface is mirrored out of it.
    vec3 direction = reflect(safeNormalize(pixel.position - parameters.camera.eye, -pixel.geometricNormal), facing);
    float climb = dot(direction, pixel.geometricNormal);
    if (climb < 0.0) direction -= 2.0 * climb * pixel.geometricNormal;

    ray.origin = pixel.position + pixel.geometricNormal * parameters.bounce.originOffset;
    ray.direction = safeNormalize(direction, pixel.geometricNormal);
    ray.launchNormal = pixel.geometricNormal;
    ray.valid = 1u;
  }
  rays[index] = ray;
}
