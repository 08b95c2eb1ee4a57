// The hall's materials and their textures. All are computed from hashes, so they are the same on every machine.
#include <algorithm>
#include <cmath>

#include "core/scene/hall.h"

namespace gridscope::hall {

namespace {

// Fills an image from a function of (u, v) in the unit square; its colour is what is stored, sRGB, 0 to 1.
template <typename Colour>
int32_t addImage(Scene& scene, const char* name, uint32_t size, const Colour& colour) {
  Image image{.name = name, .width = size, .height = size, .rgba = {}};
  image.rgba.reserve(4 * size * size);
  for (uint32_t y = 0; y < size; ++y) {
    for (uint32_t x = 0; x < size; ++x) {
      const vec2 place = (vec2(x, y) + 0.5f) / static_cast<float>(size);
      const vec4 value = colour(place.x, place.y);
      for (int channel = 0; channel < 4; ++channel) {
        image.rgba.push_back(static_cast<uint8_t>(255.0f * std::clamp(value[channel], 0.0f, 1.0f) + 0.5f));
      }
    }
  }
  scene.images.push_back(std::move(image));
  return static_cast<int32_t>(scene.images.size() - 1);
}

// A wall of blocks in running bond: `rows` courses of `columns` blocks. Returns in x the distance to the nearest joint in
// courses, in y a number of the block.
vec2 blockAt(float u, float v, uint32_t columns, uint32_t rows) {
  const float course = std::floor(v * static_cast<float>(rows));
  const float shift = std::fmod(course, 2.0f) * 0.5f;
  const float along = u * static_cast<float>(columns) + shift;
  const float block = std::fmod(std::floor(along), static_cast<float>(columns));
  const float inCourse = v * static_cast<float>(rows) - course, inBlock = along - std::floor(along);
  const float aspect = static_cast<float>(rows) / static_cast<float>(columns);
  const float joint = std::min({inCourse, 1.0f - inCourse, inBlock * aspect, (1.0f - inBlock) * aspect});
  return {joint, hashUnit(static_cast<uint32_t>(block), static_cast<uint32_t>(course), 17)};
}

vec4 stoneColour(float u, float v) {
  const vec2 block = blockAt(u, v, 4, 8);
  const float clouds = tiledClouds(u, v, 6, 1), grain = tiledClouds(u, v, 64, 2);
  vec3 colour = glm::mix(vec3(0.80f, 0.73f, 0.62f), vec3(0.90f, 0.85f, 0.76f), block.y);
  colour *= 0.84f + 0.22f * clouds + 0.10f * (grain - 0.5f);
  // Joints are darker, with a bright edge where the block is chipped.
  const float joint = glm::smoothstep(0.015f, 0.055f, block.x + 0.03f * (grain - 0.5f));
  return vec4(colour * glm::mix(0.68f, 1.0f, joint), 1.0f);
}

vec4 plasterColour(float u, float v) {
  const vec2 block = blockAt(u, v, 4, 16);
  const float clouds = tiledClouds(u, v, 4, 5), grain = tiledClouds(u, v, 48, 6);
  const vec3 colour = vec3(0.90f, 0.86f, 0.78f) * (0.86f + 0.16f * clouds + 0.05f * block.y + 0.05f * (grain - 0.5f));
  return vec4(colour * glm::mix(0.9f, 1.0f, glm::smoothstep(0.0f, 0.08f, block.x)), 1.0f);
}

vec4 carvedColour(float u, float v) {
  const float clouds = tiledClouds(u, v, 5, 8), grain = tiledClouds(u, v, 40, 9);
  return vec4(vec3(0.88f, 0.82f, 0.71f) * (0.82f + 0.22f * clouds + 0.1f * (grain - 0.5f)), 1.0f);
}

// Marble with veins where a cloud passes its middle; `depth` of the veins.
float marble(float u, float v, uint32_t seed, float depth) {
  const float wave = tiledClouds(u, v, 5, seed), cloud = tiledNoise(9.0f * u, 9.0f * v, 9, seed + 20);
  return 1.0f - depth * std::exp(-60.0f * std::abs(wave - 0.5f)) - 0.4f * depth * cloud;
}

// Four by four tiles, cream and dark green in turn, each of its own shade, with a small diamond where four meet.
vec4 tileColour(float u, float v) {
  const float x = 4.0f * u, y = 4.0f * v;
  const uint32_t column = static_cast<uint32_t>(x), row = static_cast<uint32_t>(y);
  const vec2 inTile(x - std::floor(x), y - std::floor(y));
  const float shade = 0.92f + 0.16f * hashUnit(column, row, 3);
  const vec2 corner = glm::min(inTile, 1.0f - inTile);
  const bool dark = (column + row) % 2 == 1, diamond = corner.x + corner.y < 0.2f;
  vec3 colour = dark ? vec3(0.19f, 0.25f, 0.23f) * (2.0f - marble(u, v, 11, 0.5f)) : vec3(0.88f, 0.83f, 0.73f) * marble(u, v, 12, 0.25f);
  if (diamond) colour = vec3(0.55f, 0.22f, 0.14f) * marble(u, v, 13, 0.3f);
  const float edge = diamond ? 1.0f : std::min(corner.x, corner.y);
  return vec4(colour * shade * glm::mix(0.55f, 1.0f, glm::smoothstep(0.006f, 0.02f, edge)), 1.0f);
}

// The walk down the middle: a large diamond in a frame, red, cream and black.
vec4 inlayColour(float u, float v) {
  const vec2 place = glm::abs(vec2(u, v) - 0.5f) * 2.0f;
  const float diamond = place.x + place.y;
  vec3 colour = vec3(0.62f, 0.27f, 0.17f) * marble(u, v, 21, 0.35f);
  if (diamond < 0.98f) colour = vec3(0.90f, 0.85f, 0.75f) * marble(u, v, 22, 0.22f);
  if (diamond < 0.62f) colour = vec3(0.20f, 0.25f, 0.24f) * (2.0f - marble(u, v, 23, 0.5f));
  if (diamond < 0.26f) colour = vec3(0.80f, 0.58f, 0.25f) * marble(u, v, 24, 0.3f);
  if (place.x > 0.9f) colour = vec3(0.17f, 0.18f, 0.18f) * (2.0f - marble(u, v, 25, 0.6f));
  const float line =
      std::min({std::abs(diamond - 0.98f), std::abs(diamond - 0.62f), std::abs(diamond - 0.26f), std::abs(place.x - 0.9f), 1.0f - place.y});
  return vec4(colour * glm::mix(0.5f, 1.0f, glm::smoothstep(0.004f, 0.018f, line)), 1.0f);
}

vec4 flagColour(float u, float v) {
  const vec2 block = blockAt(u, v, 2, 4);
  const vec3 colour = glm::mix(vec3(0.60f, 0.56f, 0.50f), vec3(0.70f, 0.65f, 0.57f), block.y) * marble(u, v, 31, 0.2f);
  return vec4(colour * glm::mix(0.6f, 1.0f, glm::smoothstep(0.01f, 0.03f, block.x)), 1.0f);
}

// Panes in deep colours between dark leads; u, v in a lattice of diamonds.
vec4 stainedColour(float u, float v) {
  const vec2 lattice(8.0f * (u + v), 8.0f * (u - v) + 8.0f);
  const vec2 cell = glm::floor(lattice), inCell = lattice - cell;
  const uint32_t column = static_cast<uint32_t>(cell.x) % 8, row = static_cast<uint32_t>(cell.y) % 8;
  const vec3 palette[] = {{0.10f, 0.22f, 0.75f}, {0.80f, 0.10f, 0.10f}, {0.98f, 0.74f, 0.16f},
                          {0.08f, 0.48f, 0.40f}, {0.16f, 0.40f, 0.92f}, {0.62f, 0.16f, 0.50f}};
  const vec3 glass = palette[static_cast<uint32_t>(hashUnit(column, row, 51) * 6.0f)] * (0.75f + 0.4f * hashUnit(column, row, 52));
  const vec2 edge = glm::min(inCell, 1.0f - inCell);
  const float pane = glm::smoothstep(0.03f, 0.09f, std::min(edge.x, edge.y));
  return vec4(glm::mix(vec3(0.05f), glass + 0.12f * tiledClouds(u, v, 12, 53), pane), 1.0f);
}

vec4 paleColour(float u, float v) {
  const vec2 lattice(6.0f * (u + v), 6.0f * (u - v) + 6.0f);
  const vec2 cell = glm::floor(lattice), inCell = lattice - cell;
  const float tint = hashUnit(static_cast<uint32_t>(cell.x) % 6, static_cast<uint32_t>(cell.y) % 6, 61);
  const vec3 glass = glm::mix(vec3(0.78f, 0.86f, 0.90f), vec3(0.96f, 0.92f, 0.76f), tint) * (0.92f + 0.08f * tiledClouds(u, v, 10, 62));
  const vec2 edge = glm::min(inCell, 1.0f - inCell);
  return vec4(glm::mix(vec3(0.22f), glass, glm::smoothstep(0.02f, 0.07f, std::min(edge.x, edge.y))), 1.0f);
}

// One ivy leaf with five lobes about a point near its stalk (v = 0); alpha is 1 inside its outline.
vec4 leafColour(float u, float v) {
  const vec2 place(u - 0.5f, v - 0.32f);
  const float distance = glm::length(place), angle = std::atan2(place.x, place.y);
  // Lobes at 0, +-75 and +-145 degrees; deep between them, shorter towards the stalk.
  const float lobes = 0.5f + 0.5f * std::cos(angle * 4.9f);
  const float reach = glm::mix(0.62f, 0.30f, std::abs(angle) / kPi) * glm::mix(0.58f, 1.0f, lobes);
  const bool stalk = std::abs(place.x) < 0.022f && v < 0.34f;
  const float vein = glm::smoothstep(0.0f, 0.12f, std::abs(std::sin(angle * 2.45f)) * distance + 0.02f);
  const vec3 green = glm::mix(vec3(0.62f, 0.74f, 0.42f), vec3(0.30f, 0.50f, 0.18f), vein) * (0.85f + 0.3f * tiledClouds(u, v, 6, 71));
  return vec4(green, distance < reach || stalk ? 1.0f : 0.0f);
}

vec4 woodColour(float u, float v) {
  const float ring = tiledClouds(u, v, 3, 81) * 6.0f + 8.0f * u;
  return vec4(vec3(0.46f, 0.31f, 0.19f) * (0.8f + 0.25f * (ring - std::floor(ring)) + 0.15f * tiledClouds(u, v, 32, 82)), 1.0f);
}

}  // namespace

// In the order of HallMaterial.
void addMaterials(Scene& scene) {
  const auto add = [&](Material material) { scene.materials.push_back(std::move(material)); };
  add({.name = "stone", .roughness = 0.85f, .imageIndex = addImage(scene, "stone", 256, stoneColour)});
  add({.name = "plaster", .roughness = 0.9f, .imageIndex = addImage(scene, "plaster", 256, plasterColour)});
  add({.name = "carved stone", .roughness = 0.7f, .imageIndex = addImage(scene, "carved stone", 128, carvedColour)});
  add({.name = "marble tiles", .metallic = 0.25f, .roughness = 0.06f, .imageIndex = addImage(scene, "marble tiles", 512, tileColour)});
  add({.name = "marble inlay", .metallic = 0.25f, .roughness = 0.06f, .imageIndex = addImage(scene, "marble inlay", 512, inlayColour)});
  add({.name = "flagstones", .roughness = 0.25f, .imageIndex = addImage(scene, "flagstones", 256, flagColour)});
  add({.name = "stained glass",
       .roughness = 0.3f,
       .imageIndex = addImage(scene, "stained glass", 256, stainedColour),
       .doubleSided = true,
       .unlit = true});
  add({.name = "pale glass",
       .roughness = 0.3f,
       .imageIndex = addImage(scene, "pale glass", 256, paleColour),
       .doubleSided = true,
       .unlit = true});
  add({.name = "ivy leaf",
       .roughness = 0.6f,
       .imageIndex = addImage(scene, "ivy leaf", 128, leafColour),
       .wrapU = WrapMode::clamp,
       .wrapV = WrapMode::clamp,
       .alphaMode = AlphaMode::mask,
       .doubleSided = true});
  add({.name = "gold", .baseColour = {1.0f, 0.68f, 0.28f, 1.0f}, .metallic = 1.0f, .roughness = 0.18f});
  add({.name = "iron", .baseColour = {0.09f, 0.085f, 0.08f, 1.0f}, .metallic = 0.3f, .roughness = 0.4f});
  add({.name = "wood", .roughness = 0.55f, .imageIndex = addImage(scene, "wood", 128, woodColour)});
  add({.name = "clay", .baseColour = {0.62f, 0.27f, 0.15f, 1.0f}, .roughness = 0.75f});
  add({.name = "wax", .baseColour = {0.95f, 0.90f, 0.78f, 1.0f}, .roughness = 0.5f});
}

}  // namespace gridscope::hall
