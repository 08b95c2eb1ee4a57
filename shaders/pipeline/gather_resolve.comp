// Gather: from the reference seen at each pixel to position, normals and material.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/shared/trace/alpha.h"
#include "shaders/scene/surface.glsl"
layout(scalar, set = 0, binding = kBindGather) writeonly buffer GatherBuffer { GatherPixel gatherPixels[]; };

layout(local_size_x = 8, local_size_y = 8) in;

// Unscaled direction through a pixel's centre.
vec3 pixelDirection(CameraParameters camera, uvec2 pixel) {
  vec2 place = (vec2(pixel) + 0.5) / vec2(camera.width, camera.height) * 2.0 - 1.0;
  return camera.forward + camera.right * (place.x * camera.tanHalfWidth) - camera.up * (place.y * camera.tanHalfHeight);
}

void main() {
  CameraParameters camera = parameters.camera;
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= camera.width || pixel.y >= camera.height) return;
  uint reference = imageLoad(visibilityImage, ivec2(pixel)).x;
  GatherPixel result = GatherPixel(vec3(0.0), vec3(0.0), vec3(0.0), vec2(0.0), 0.0, kNoReference, 0u);
  if (reference != kNoReference) {
    Instance instance = instances[referenceInstance(reference)];
    Triangle triangle = worldTriangles[instance.firstWorldTriangle + referenceTriangle(reference)];

    // The pixel's line meets the triangle's plane; kept inside the triangle, where a grazing angle would leave it.
    vec3 direction = pixelDirection(camera, pixel);
    vec3 normal = safeNormalize(triangleNormal(triangle), -normalize(direction));
    float slope = dot(normal, direction);
    float t = abs(slope) > 1e-12 ? dot(normal, triangle.a - camera.eye) / slope : 0.0;
    vec2 weights = clampedBarycentrics(triangle, camera.eye + direction * t);

    result.position = triangle.a * (1.0 - weights.x - weights.y) + triangle.b * weights.x + triangle.c * weights.y;
    result.geometricNormal = slope > 0.0 ? -normal : normal;
    result.shadingNormal = shadingNormal(reference, weights, result.geometricNormal);
    result.barycentrics = weights;
    result.depth = distance(camera.eye, result.position);
    result.reference = reference;
    result.material = instance.material;
  }
  gatherPixels[pixel.y * camera.width + pixel.x] = result;
}
