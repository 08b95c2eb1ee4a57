// Shading for views: what a surface's material looks like, how it is lit, and what its glossy bounce adds. Nothing casts a shadow, and
// most scenes are rooms: light comes from a sun that wraps around, a sky above, the floor below and a lamp beside the camera, darkened
// in corners by screen-space ambient occlusion. Nothing here reads the grid: where two frames' hits agree, so do their pictures.
// Sources: Schlick, An Inexpensive BRDF Model, 1994; McGuire et al., The Alchemy Screen-Space Ambient Obscurance Algorithm, 2011;
// Jimenez, Next Generation Post Processing in Call of Duty, 2014 (the noise); Narkowicz, ACES Filmic Tone Mapping Curve, 2015.
#include "shaders/grid/cell.glsl"
#include "shaders/scene/surface.glsl"

// A point to shade, from the camera or from a ray.
struct Surface {
  vec3 position;       // world
  vec3 normal;         // unit, towards the viewer's side
  vec3 toViewer;       // unit
  vec3 albedo;         // linear
  float roughness;     // perceptual, 0..1
  float metallic;
  bool unlit;
};

// --- material

float wrapCoordinate(float x, uint wrap, float halfTexel) {
  if (wrap == 0u) return x;
  float inside = wrap == 2u ? x : 1.0 - abs(x - 2.0 * floor(0.5 * x) - 1.0);
  return clamp(inside, halfTexel, 1.0 - halfTexel);
}

// The diffuse map's colour at a level that it has. The sampler repeats; the other wraps are made here, half a texel away from the far
// border.
vec3 diffuseTexel(TraceMaterial material, vec2 uv, float level) {
  float halfTexel = 0.5 * exp2(level) / float(textureSize(diffuseMaps, 0).x);
  vec2 wrapped = vec2(wrapCoordinate(uv.x, material.wrapU, halfTexel), wrapCoordinate(uv.y, material.wrapV, halfTexel));
  return textureLod(diffuseMaps, vec3(wrapped, float(material.layer)), level).rgb;
}

// The diffuse map's colour over a square of 2^lod texels, linear. Where the map has no such level, four places of a turned square
// stand for it.
vec3 diffuseMap(TraceMaterial material, vec2 uv, float lod) {
  if (material.layer == kNoLayer) return vec3(1.0);
  float level = min(lod, float(textureQueryLevels(diffuseMaps) - 1));
  if (lod - level < 0.5) return diffuseTexel(material, uv, level);
  vec2 reach = vec2(0.375, 0.125) * exp2(min(lod, 5.0)) / float(textureSize(diffuseMaps, 0).x);
  vec2 turned = vec2(-reach.y, reach.x);
  return 0.25 * (diffuseTexel(material, uv + reach, level) + diffuseTexel(material, uv - reach, level) +
                 diffuseTexel(material, uv + turned, level) + diffuseTexel(material, uv - turned, level));
}

// The level of the diffuse map whose texels are as large as `footprint`, world units.
float mapLevel(uint objectTriangle, Triangle world, float footprint) {
  vec2 edgeB = corners[3u * objectTriangle + 1u].uv - corners[3u * objectTriangle].uv;
  vec2 edgeC = corners[3u * objectTriangle + 2u].uv - corners[3u * objectTriangle].uv;
  float uvArea = abs(edgeB.x * edgeC.y - edgeB.y * edgeC.x);
  float worldArea = max(length(triangleNormal(world)), 1e-12);
  float texels = footprint * sqrt(uvArea / worldArea) * float(textureSize(diffuseMaps, 0).x);
  return log2(clamp(texels, 1.0, 4096.0));
}

// Base colour of a triangle at barycentrics of corners b and c, `footprint` world units across.
vec3 albedoAt(uint reference, vec2 weights, float footprint) {
  Instance instance = instances[referenceInstance(reference)];
  TraceMaterial material = materials[instance.material];
  uint triangle = instance.firstTriangle + referenceTriangle(reference);
  Corner a = corners[3u * triangle];
  Corner b = corners[3u * triangle + 1u];
  Corner c = corners[3u * triangle + 2u];
  vec3 vertexColour = unpackBytes(a.colour) * (1.0 - weights.x - weights.y) + unpackBytes(b.colour) * weights.x +
                      unpackBytes(c.colour) * weights.y;
  float lod = mapLevel(triangle, worldTriangles[instance.firstWorldTriangle + referenceTriangle(reference)], footprint);
  return material.baseColour.rgb * vertexColour * diffuseMap(material, interpolateUv(a.uv, b.uv, c.uv, weights), lod);
}

// World size of a pixel at a distance, on a surface that is turned away by `cosine`; between the two sides of its long ellipse.
float pixelFootprint(float distance, float cosine) {
  return 2.0 * parameters.camera.tanHalfHeight / float(parameters.camera.height) * distance * inversesqrt(max(cosine, 0.02));
}

// The roughness that the bounce uses: a rough material mirrors as a glossy one, for glossy rays are what the technique traces.
float surfaceRoughness(TraceMaterial material) {
  return min(material.roughness, parameters.bounce.roughness);
}

// --- surfaces

// Only for pixels that see something.
Surface gatheredSurface(GatherPixel seen) {
  TraceMaterial material = materials[seen.material];
  Surface surface;
  surface.position = seen.position;
  surface.normal = seen.shadingNormal;
  surface.toViewer = normalize(parameters.camera.eye - seen.position);
  surface.albedo = albedoAt(seen.reference, seen.barycentrics,
                            pixelFootprint(seen.depth, abs(dot(seen.geometricNormal, surface.toViewer))));
  surface.roughness = surfaceRoughness(material);
  surface.metallic = material.metallic;
  surface.unlit = (material.flags & kMaterialUnlit) != 0u;
  return surface;
}

// Only for triangle and voxel hits. `distance`: all the way from the eye.
Surface hitSurface(Ray ray, Hit hit, float distance, float roughness) {
  Instance instance = instances[referenceInstance(hit.reference)];
  TraceMaterial material = materials[instance.material];
  vec2 weights = vec2(hit.u, hit.v);
  Surface surface;
  surface.position = rayPoint(ray, hit.t);
  surface.toViewer = -ray.direction;
  Triangle world = worldTriangles[instance.firstWorldTriangle + referenceTriangle(hit.reference)];
  vec3 facing = safeNormalize(triangleNormal(world), surface.toViewer);
  surface.normal = shadingNormal(hit.reference, weights, dot(facing, surface.toViewer) < 0.0 ? -facing : facing);
  surface.albedo = albedoAt(hit.reference, weights, pixelFootprint(distance, 1.0) + 0.1 * roughness * roughness * hit.t);
  surface.roughness = surfaceRoughness(material);
  surface.metallic = material.metallic;
  surface.unlit = (material.flags & kMaterialUnlit) != 0u;
  return surface;
}

// --- light

const vec3 kSunLight = vec3(1.02, 0.90, 0.72);
const vec3 kSkyLight = vec3(0.46, 0.54, 0.68);
const vec3 kFloorLight = vec3(0.40, 0.34, 0.28);
const vec3 kLampLight = vec3(0.52, 0.48, 0.43);

vec3 skyColour(vec3 direction) {
  float height = direction.y;
  vec3 above = mix(vec3(0.72, 0.80, 0.88), vec3(0.19, 0.36, 0.66), pow(clamp(height, 0.0, 1.0), 0.55));
  vec3 below = mix(vec3(0.52, 0.52, 0.50), vec3(0.17, 0.16, 0.15), clamp(-3.0 * height, 0.0, 1.0));
  vec3 sky = mix(below, above, smoothstep(-0.03, 0.03, height));
  float towardsSun = max(dot(direction, parameters.view.sunDirection), 0.0);
  return sky + vec3(1.0, 0.82, 0.55) * (0.25 * pow(towardsSun, 12.0) + 3.0 * pow(towardsSun, 900.0));
}

// Light that a surface scatters to the viewer, without its mirror part. `open`: 1 in the open, 0 in the tightest corner.
vec3 scatteredLight(Surface surface, float open) {
  vec3 normal = surface.normal;
  float sun = max((dot(normal, parameters.view.sunDirection) + 0.3) / 1.3, 0.0);
  float upward = 0.5 + 0.5 * normal.y;
  vec3 offset = parameters.camera.eye - surface.position;
  float reach = 0.25 * parameters.view.farDistance;
  float lamp = max(dot(normal, normalize(offset)), 0.0) / (1.0 + dot(offset, offset) / (reach * reach));
  float shaded = mix(0.5, 1.0, open);
  vec3 light = shaded * (kSunLight * (sun * sun) + kLampLight * lamp) + open * mix(kFloorLight, kSkyLight, upward);
  // White rooms would burn out under a light that suits stone ones: the brightest colours take a third less.
  float brightness = max(surface.albedo.r, max(surface.albedo.g, surface.albedo.b));
  return surface.albedo * (1.0 - 0.38 * brightness * brightness) * (1.0 - surface.metallic) * light;
}

// Share of light that is mirrored: after Schlick, as for a polished surface, less for rough ones. It is more than nature's, because
// what the rays bring back is what this picture is for.
vec3 mirrored(Surface surface, vec3 direction) {
  vec3 low = mix(vec3(0.08 - 0.05 * surface.roughness), surface.albedo, surface.metallic);
  vec3 high = max(vec3(1.0 - 0.75 * surface.roughness), low);
  vec3 middle = surface.toViewer + direction;
  float cosine = dot(middle, middle) > 1e-12 ? clamp(dot(normalize(middle), surface.toViewer), 0.0, 1.0) : 1.0;
  return low + (high - low) * pow(1.0 - cosine, 4.0);
}

// A surface lit on its own: what a ray sees at its end. Metals show the sky's mean instead of a further bounce.
vec3 litSurface(Surface surface, float open) {
  if (surface.unlit) return surface.albedo;
  return scatteredLight(surface, open) + surface.albedo * surface.metallic * mix(kFloorLight, kSkyLight, 0.5 + 0.5 * surface.normal.y);
}

// What a pixel's ray brings back.
vec3 bounceLight(uint pixel, float depth, float roughness) {
  Ray ray = rays[pixel];
  Hit hit = hits[pixel];
  if (hit.kind != kHitTriangle && hit.kind != kHitVoxel) return skyColour(ray.direction);
  return litSurface(hitSurface(ray, hit, depth + hit.t, roughness), 0.75);
}

// --- occlusion

const int kOcclusionSamples = 12;

// How open a surface point is, 0..1, from the neighbouring pixels' positions within 3 % of the scene's diagonal.
float openness(uint pixel, GatherPixel seen) {
  ivec2 size = ivec2(parameters.camera.width, parameters.camera.height);
  ivec2 centre = ivec2(int(pixel) % size.x, int(pixel) / size.x);
  float radius = 0.03 * parameters.view.farDistance;
  float pixelRadius = min(radius / pixelFootprint(seen.depth, 1.0), 0.2 * float(size.y));
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(vec2(centre), vec2(0.06711056, 0.00583715))));

  float closed = 0.0;
  for (int i = 0; i < kOcclusionSamples; ++i) {
    // A spiral of equal areas, turned differently at each pixel.
    float share = (float(i) + 0.5) / float(kOcclusionSamples);
    float angle = turn + 2.3999632 * float(i);
    ivec2 place = centre + ivec2(round(pixelRadius * sqrt(share) * vec2(cos(angle), sin(angle))));
    if (any(lessThan(place, ivec2(0))) || any(greaterThanEqual(place, size))) continue;
    uint other = uint(place.y * size.x + place.x);
    if (gatherPixels[other].reference == kNoReference) continue;

    vec3 offset = gatherPixels[other].position - seen.position;
    float squared = dot(offset, offset);
    float above = dot(offset, seen.shadingNormal) - 0.003 * seen.depth;
    float fade = max(1.0 - squared / (radius * radius), 0.0);
    closed += fade * max(above, 0.0) * radius / (squared + 0.01 * radius * radius);
  }
  return 1.0 / (1.0 + 3.0 * closed / float(kOcclusionSamples));
}

// --- pictures

// Linear light to sRGB through a filmic curve.
vec3 toneMapped(vec3 light) {
  vec3 x = 0.7 * max(light, vec3(0.0));
  return srgbEncode((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14));
}

// What is behind a pixel that sees nothing.
vec3 backgroundLight(uint pixel) {
  CameraParameters camera = parameters.camera;
  vec2 place = (vec2(float(pixel % camera.width), float(pixel / camera.width)) + 0.5) / vec2(float(camera.width), float(camera.height));
  vec3 direction = camera.forward + (2.0 * place.x - 1.0) * camera.tanHalfWidth * camera.right +
                   (1.0 - 2.0 * place.y) * camera.tanHalfHeight * camera.up;
  return skyColour(normalize(direction));
}

// The picture: light at the surface seen, and what its glossy bounce mirrors.
vec3 finalLight(uint pixel) {
  GatherPixel seen = gatherPixels[pixel];
  if (seen.reference == kNoReference) return backgroundLight(pixel);
  Surface surface = gatheredSurface(seen);
  if (surface.unlit) return surface.albedo;
  float open = openness(pixel, seen);
  vec3 light = scatteredLight(surface, open);
  if (hits[pixel].kind == kHitNoRay) return light;
  vec3 share = mirrored(surface, rays[pixel].direction);
  return light * (vec3(1.0) - share) + share * bounceLight(pixel, seen.depth, surface.roughness);
}

// How bright a surface is drawn under a colour that carries the meaning: enough to see the room, too little to be taken for a value.
ViewElement paintedElement(ViewElement element, GatherPixel seen) {
  vec3 toViewer = normalize(parameters.camera.eye - seen.position);
  return litElement(element, 0.62 + 0.38 * abs(dot(seen.shadingNormal, normalize(toViewer + vec3(0.2, 0.5, 0.1)))));
}
