// The hall's light, baked into vertex colours: the renderer's sun and sky cast no shadows, so what makes a room of a set of
// walls is here. Three terms, all in closed form: windows as area lights without occlusion, sunbeams through the clerestory
// and the aisle windows, and contact darkening near floor, columns and springings.
#include <algorithm>
#include <cmath>

#include "core/scene/hall.h"

namespace gridscope::hall {

namespace {

// Towards the sun: it stands to the right of the nave, high and a little behind the camera.
const vec3 kSun = glm::normalize(vec3(0.38f, 0.84f, 0.26f));
const vec3 kSunColour(1.0f, 0.84f, 0.60f), kSkyColour(0.72f, 0.80f, 0.92f);

float linearStep(float low, float high, float value) { return std::clamp((value - low) / (high - low), 0.0f, 1.0f); }

// z within its bay, measured as openings are.
float inBay(float z) {
  const float place = (kEnd - z) / kBay;
  return (place - std::floor(place)) * kBay;
}

// 1 well inside an opening, 0 well outside, over a soft edge of about 15 cm.
float insideOpening(const Opening& opening, float u, float y) {
  const float sides = opening.halfWidth - std::abs(u - opening.middle);
  return linearStep(-0.05f, 0.1f, std::min({sides, y - opening.bottom, opening.top(u) - y}));
}

// Light of one window: its area seen from the point, with the cosines at both ends. The window's own size keeps it finite.
float windowLight(const vec3& position, const vec3& normal, const vec3& middle, const vec3& inward, float area) {
  const vec3 way = middle - position;
  const float squared = glm::dot(way, way);
  const float distance = std::sqrt(squared) + 1e-4f;
  // Stone scatters: some light from windows beside and behind counts, too.
  const float here = std::max(0.0f, 0.25f + 0.75f * glm::dot(normal, way) / distance);
  const float there = std::max(0.0f, 0.1f - 0.9f * glm::dot(inward, way) / distance);
  return area * here * there / (kPi * squared + area);
}

vec3 windowsLight(const vec3& position, const vec3& normal) {
  // 1 in the nave or above the arcade, 0 deep in the aisles, and the other way round.
  const float nave = 1.0f - linearStep(kNave - 0.6f, kNave + 1.6f, std::abs(position.x));
  const float aisle = linearStep(kNave - 2.5f, kNave + 0.6f, std::abs(position.x));
  vec3 light(0.0f);
  for (uint32_t bay = 0; bay < kBays; ++bay) {
    const float z = bayStart(bay) - 0.5f * kBay;
    for (const float side : {-1.0f, 1.0f}) {
      const vec3 inward(-side, 0.0f, 0.0f);
      // The sky is brighter on the sun's side.
      const vec3 colour = kSkyColour * (side > 0.0f ? 1.15f : 0.8f);
      light += 4.6f * nave * colour * windowLight(position, normal, {side * kNave, 10.2f, z}, inward, 4.6f);
      if (side * position.x > 0.0f) light += 3.0f * aisle * colour * windowLight(position, normal, {side * kOuter, 3.2f, z}, inward, 4.2f);
    }
  }
  const vec3 rose = windowLight(position, normal, {0.0f, kRoseY, -kEnd}, {0.0f, 0.0f, 1.0f}, 18.0f) * vec3(0.95f, 0.72f, 0.80f);
  return light + 2.4f * nave * rose;
}

// How much of a sunbeam reaches a point: it must pass a clerestory window, or an aisle window and then the arcade.
float sunbeam(const vec3& position, const vec3& normal) {
  const float facing = glm::dot(normal, kSun);
  if (facing <= 0.0f) return 0.0f;
  const auto crossing = [&](float x) { return position + (x - position.x) / kSun.x * kSun; };

  float beam = 0.0f;
  if (position.x < kNave - 0.3f) {
    const vec3 window = crossing(kNave);
    beam = insideOpening(kClerestory, inBay(window.z), window.y);
  }
  if (position.x < kOuter - 0.05f) {
    const vec3 window = crossing(kOuter);
    float low = insideOpening(kAisleWindow, inBay(window.z), window.y);
    if (position.x < kNave) {
      const vec3 arch = crossing(kNave);
      low *= arch.y < kCapital ? 1.0f : insideOpening(kArcadeArch, inBay(arch.z), arch.y);
    }
    beam = std::max(beam, 0.9f * low);
  }
  return beam * facing;
}

// Darkening where surfaces meet: under the walls' feet, about the columns, in the springings of the vaults.
float contact(const vec3& position, const vec3& normal) {
  float open = 1.0f;
  const float toOuter = kOuter - std::abs(position.x), toEnd = kEnd - std::abs(position.z);
  if (normal.y > 0.7f && position.y < 0.3f) {
    // The floor: dark at the walls, and about the foot of each column.
    const float bay = (kEnd - position.z) / kBay, nearest = std::round(bay);
    const float toColumn = glm::length(vec2(std::abs(position.x) - kNave, (bay - nearest) * kBay));
    open *= 0.35f + 0.65f * linearStep(0.45f, 1.8f, toColumn);
    open *= 0.4f + 0.6f * linearStep(0.0f, 1.6f, std::min(toOuter, toEnd));
  } else {
    open *= 0.55f + 0.45f * linearStep(0.0f, 1.5f, position.y);
  }
  // The springings of both vaults, deep between their ribs.
  if (position.y > kCapital && normal.y < 0.3f) {
    const float nave = linearStep(kNave - 0.3f, kNave - 2.2f, std::abs(position.x));
    const float aisle = linearStep(1.9f, 0.6f, std::abs(std::abs(position.x) - 0.5f * (kNave + kOuter)));
    const float aisleHeight = linearStep(kCapital, kCapital + 2.0f, position.y);
    const float naveHeight = position.y < kSpring ? 1.0f : linearStep(kSpring, kSpring + 2.5f, position.y);
    const bool inAisle = std::abs(position.x) > kNave;
    open *= inAisle ? 0.55f + 0.45f * std::max(aisle, aisleHeight) : 0.6f + 0.4f * std::max(nave, naveHeight);
  }
  // Inner corners of the room.
  if (std::abs(normal.z) < 0.5f) open *= 0.6f + 0.4f * linearStep(0.0f, 1.2f, toEnd);
  return open;
}

}  // namespace

vec3 bakedLight(const vec3& position, const vec3& normal) {
  // Light from the floor warms what looks down; the darkest corners keep some light.
  const vec3 ambient = glm::mix(vec3(0.34f, 0.28f, 0.22f), vec3(0.25f, 0.26f, 0.29f), 0.5f + 0.5f * normal.y);
  // What looks up is darker than it would be: the renderer's own sun reaches it through the vault.
  const float shade = glm::mix(0.8f, 0.45f, std::max(normal.y, 0.0f));
  const vec3 scattered = shade * (ambient + windowsLight(position, normal)) * contact(position, normal);
  const vec3 light = scattered + 2.4f * sunbeam(position, normal) * kSunColour;
  // Bends the bright end towards 1, so that nothing is cut off there.
  return glm::min(1.6f * light / (1.0f + 0.75f * light), vec3(1.0f));
}

}  // namespace gridscope::hall
