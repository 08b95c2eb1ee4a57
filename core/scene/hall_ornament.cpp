// What stands and hangs in the hall: the filigree that saturates its cells, ivy, planters, chandeliers.
#include <array>
#include <cmath>

#include "core/scene/hall.h"

namespace gridscope::hall {

namespace {

// An unsteady unit vector: the same for the same number.
vec3 hashDirection(uint32_t index, uint32_t seed) {
  const float up = 2.0f * hashUnit(index, seed) - 1.0f, angle = 2.0f * kPi * hashUnit(index, seed + 1);
  const float width = std::sqrt(std::max(0.0f, 1.0f - up * up));
  return {width * std::cos(angle), up, width * std::sin(angle)};
}

// A leaf: a quad that hangs from `stalk`, its surface towards `outward`, turned by `roll` about it.
struct Leaf {
  vec3 stalk{0.0f};
  vec3 outward{1.0f, 0.0f, 0.0f};  // unit
  float roll = 0.0f;
  float size = 0.15f;
  vec3 tint{1.0f};
};

void addLeaf(Mesh& mesh, const Leaf& leaf) {
  vec3 first, second;
  makeFrame(leaf.outward, first, second);
  // The tip hangs down: second is upward for an outward that is level.
  const vec3 tip = -std::cos(leaf.roll) * second + std::sin(leaf.roll) * first;
  const vec3 across = glm::cross(tip, leaf.outward);
  const size_t begin = mesh.colours.size();
  addPicture(mesh, leaf.stalk - 0.5f * leaf.size * across, leaf.size * across, leaf.size * tip);
  for (size_t i = begin; i < mesh.colours.size(); ++i) mesh.colours[i] = vec4(leaf.tint, 1.0f);
}

vec3 leafTint(uint32_t index) {
  // From dark to fresh green, a few turning yellow.
  const float fresh = hashUnit(index, 91);
  const vec3 green = glm::mix(vec3(0.45f, 0.62f, 0.42f), vec3(1.0f, 1.0f, 0.75f), fresh);
  return hashUnit(index, 92) > 0.94f ? vec3(1.5f, 1.05f, 0.5f) : green;
}

// Ivy that climbs a column in a few winding strands, denser at its foot.
void addColumnIvy(Mesh& leaves, Mesh& stems, const vec3& foot, float top, uint32_t seed) {
  constexpr uint32_t kStrands = 5;
  for (uint32_t strand = 0; strand < kStrands; ++strand) {
    const float start = 2.0f * kPi * hashUnit(strand, seed, 1), turns = 2.4f * (hashUnit(strand, seed, 2) - 0.4f);
    const float reach = top * (0.45f + 0.55f * hashUnit(strand, seed, 3));
    const auto curve = [&](float s) {
      const float angle = start + turns * s + 0.25f * std::sin(9.0f * s + static_cast<float>(strand));
      return foot + vec3(0.47f * std::cos(angle), 0.4f + (reach - 0.4f) * s, 0.47f * std::sin(angle));
    };
    addBar(stems, {.curve = curve, .thickness = 0.012f, .pieces = 24, .sections = 4});
    const uint32_t count = static_cast<uint32_t>(48.0f * reach);
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t key = i + 1000 * strand;
      // Roots: more leaves below than above.
      const float place = hashUnit(key, seed, 4) * (0.55f + 0.45f * hashUnit(key, seed, 5));
      const vec3 at = curve(place);
      const vec3 away = glm::normalize(vec3(at.x - foot.x, 0.0f, at.z - foot.z));
      const vec3 outward = glm::normalize(away + 0.55f * hashDirection(key, seed + 6) + vec3(0.0f, 0.25f, 0.0f));
      const vec3 spread = 0.13f * hashDirection(key, seed + 8);
      const vec3 off = (0.03f + 0.07f * hashUnit(key, seed, 10) - std::min(0.0f, glm::dot(spread, away))) * away;
      addLeaf(leaves, {.stalk = at + off + spread,
                       .outward = outward,
                       .roll = 1.6f * (hashUnit(key, seed, 11) - 0.5f),
                       .size = 0.10f + 0.10f * hashUnit(key, seed, 12),
                       .tint = leafTint(key + seed)});
    }
  }
}

// Strands that hang from the string course.
void addHangingIvy(Mesh& leaves, Mesh& stems, float side, float middle, uint32_t seed) {
  for (uint32_t strand = 0; strand < 16; ++strand) {
    const float z = middle + 2.6f * (hashUnit(strand, seed, 21) - 0.5f);
    const float length = 0.5f + 1.9f * hashUnit(strand, seed, 22) * hashUnit(strand, seed, 23);
    const float x = side * (kNave - kArcadeHalf - 0.2f);
    const auto curve = [&](float s) { return vec3(x + side * 0.06f * s, kString + 0.3f - length * s, z + 0.1f * std::sin(5.0f * s + z)); };
    addBar(stems, {.curve = curve, .thickness = 0.009f, .pieces = 10, .sections = 4});
    const uint32_t count = static_cast<uint32_t>(34.0f * length) + 6;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t key = i + 500 * strand;
      const float place = static_cast<float>(i) / static_cast<float>(count);
      const vec3 outward = glm::normalize(vec3(-side, 0.3f, 0.0f) + 0.7f * hashDirection(key, seed + 24));
      addLeaf(leaves, {.stalk = curve(place) + 0.09f * hashDirection(key, seed + 26) - vec3(side * 0.08f, 0.0f, 0.0f),
                       .outward = outward,
                       .roll = 1.2f * (hashUnit(key, seed, 28) - 0.5f),
                       .size = 0.10f + 0.08f * hashUnit(key, seed, 29),
                       .tint = leafTint(key + seed)});
    }
  }
}

const std::array<vec2, 13> kPotProfile = {vec2(0.0f, 0.02f), {0.26f, 0.02f}, {0.26f, 0.02f}, {0.28f, 0.06f}, {0.36f, 0.30f},
                                          {0.40f, 0.52f},    {0.40f, 0.52f}, {0.45f, 0.54f}, {0.46f, 0.60f}, {0.45f, 0.64f},
                                          {0.45f, 0.64f},    {0.38f, 0.64f}, {0.36f, 0.54f}};

void addBush(Mesh& leaves, const vec3& foot, uint32_t seed) {
  for (uint32_t i = 0; i < 420; ++i) {
    // A ball that is denser at its surface, flattened, over the pot.
    const vec3 direction = hashDirection(i, seed);
    const float radius = 0.62f * std::sqrt(std::sqrt(hashUnit(i, seed, 31)));
    const vec3 at = foot + vec3(0.0f, 1.12f, 0.0f) + radius * direction * vec3(0.95f, 0.85f, 0.95f);
    addLeaf(leaves, {.stalk = at,
                     .outward = glm::normalize(direction + 0.5f * hashDirection(i, seed + 2) + vec3(0.0f, 0.3f, 0.0f)),
                     .roll = 2.5f * (hashUnit(i, seed, 32) - 0.5f),
                     .size = 0.15f + 0.10f * hashUnit(i, seed, 33),
                     .tint = leafTint(i + seed) * (0.4f + 0.6f * radius / 0.62f)});
  }
}

// A line that winds about a ring, three times around the axis for seven times through the middle.
vec3 knot(float s) {
  const float angle = 2.0f * kPi * s;
  const float width = 0.125f + 0.055f * std::cos(7.0f * angle);
  return {width * std::cos(3.0f * angle), 0.07f * std::sin(7.0f * angle), width * std::sin(3.0f * angle)};
}

}  // namespace

// A globe of thin rings about a knot, a third of a metre in radius: 22,000 triangles in a handful of cells, beside bays of
// 4.5 m. Whatever the capacity, most of its references are refused.
void addFiligree(Scene& scene) {
  Mesh filigree = newMesh("filigree", kGold);
  constexpr uint32_t kMeridians = 12, kParallels = 7;
  for (uint32_t i = 0; i < kMeridians; ++i) {
    const float angle = kPi * static_cast<float>(i) / kMeridians;
    addRing(filigree, {.centre = kFiligree,
                       .axis = {std::cos(angle), 0.0f, std::sin(angle)},
                       .radius = 0.33f,
                       .thickness = 0.006f,
                       .sides = 64,
                       .sections = 6});
  }
  for (uint32_t i = 0; i < kParallels; ++i) {
    const float up = 0.33f * std::sin(0.5f * kPi * (static_cast<float>(i + 1) / (kParallels + 1) * 2.0f - 1.0f));
    addRing(filigree, {.centre = kFiligree + vec3(0.0f, up, 0.0f),
                       .radius = std::sqrt(0.33f * 0.33f - up * up),
                       .thickness = 0.005f,
                       .sides = 64,
                       .sections = 6});
  }
  const auto curve = [](float s) { return kFiligree + knot(s); };
  addBar(filigree, {.curve = curve, .thickness = 0.014f, .pieces = 420, .sections = 8});
  addSphere(filigree, kFiligree, 0.06f, 24, 16);
  const vec3 foot = kFiligree - vec3(0.0f, 0.35f, 0.0f);
  addRing(filigree, {.centre = foot, .radius = 0.1f, .thickness = 0.025f, .sides = 32, .sections = 10});
  addPart(scene, std::move(filigree));

  Mesh plinth = newMesh("plinth", kCarved);
  const std::array<vec2, 14> profile = {vec2(0.48f, 0.0f), {0.48f, 0.12f}, {0.48f, 0.12f}, {0.42f, 0.16f}, {0.36f, 0.22f},
                                        {0.33f, 0.30f},    {0.31f, 0.95f}, {0.31f, 0.95f}, {0.34f, 1.02f}, {0.42f, 1.10f},
                                        {0.42f, 1.10f},    {0.42f, 1.20f}, {0.42f, 1.20f}, {0.0f, 1.24f}};
  addLathe(plinth, {kFiligree.x, 0.0f, kFiligree.z}, profile, 24);
  addPart(scene, std::move(plinth));
}

void addIvy(Scene& scene) {
  Mesh leaves = newMesh("ivy", kLeaf), stems = newMesh("ivy stems", kWood);
  addColumnIvy(leaves, stems, {-kNave, 0.0f, bayStart(2)}, 4.6f, 100);
  addColumnIvy(leaves, stems, {kNave, 0.0f, bayStart(3)}, 3.6f, 200);
  addColumnIvy(leaves, stems, {-kNave, 0.0f, bayStart(5)}, 4.2f, 300);
  addHangingIvy(leaves, stems, -1.0f, bayStart(2) - 0.2f, 400);
  addHangingIvy(leaves, stems, 1.0f, bayStart(3) - 0.5f, 500);
  addHangingIvy(leaves, stems, 1.0f, bayStart(5) + 0.3f, 600);
  addPart(scene, std::move(leaves)), addPart(scene, std::move(stems));
}

void addPlanters(Scene& scene) {
  Mesh pots = newMesh("planters", kClay), bushes = newMesh("bushes", kLeaf);
  const std::array<vec3, 5> places = {vec3(-2.9f, 0.0f, bayStart(1) - 1.5f),
                                      {2.95f, 0.0f, bayStart(2) - 2.1f},
                                      {-2.95f, 0.0f, bayStart(4) - 2.2f},
                                      {2.95f, 0.0f, bayStart(5) - 2.2f},
                                      {-6.9f, 0.0f, bayStart(2)}};
  for (uint32_t i = 0; i < places.size(); ++i) {
    addLathe(pots, places[i], kPotProfile, 24);
    addBush(bushes, places[i], 700 + 40 * i);
  }
  addPart(scene, std::move(pots)), addPart(scene, std::move(bushes));
}

// Two crowns of candles on chains, between the bays of the vault.
void addChandeliers(Scene& scene) {
  Mesh iron = newMesh("chandeliers", kIron), candles = newMesh("candles", kWax);
  for (const uint32_t bay : {2u, 4u}) {
    const vec3 middle(0.0f, 6.6f, bayStart(bay) - 0.5f * kBay);
    addRing(iron, {.centre = middle, .radius = 1.05f, .thickness = 0.045f, .sides = 56, .sections = 8});
    addRing(iron, {.centre = middle + vec3(0.0f, 0.5f, 0.0f), .radius = 0.5f, .thickness = 0.03f, .sides = 36, .sections = 8});
    const vec3 top = middle + vec3(0.0f, 1.7f, 0.0f), ceiling(middle.x, kSpring + kVaultRise, middle.z);
    addBar(iron, {.curve = [&](float s) { return glm::mix(top, ceiling, s); }, .thickness = 0.02f, .pieces = 12, .sections = 6});
    for (uint32_t i = 0; i < 12; ++i) {
      const float angle = 2.0f * kPi * static_cast<float>(i) / 12.0f;
      const vec3 at = middle + 1.05f * vec3(std::cos(angle), 0.0f, std::sin(angle));
      const std::array<vec2, 4> dish = {vec2(0.03f, 0.03f), {0.09f, 0.07f}, {0.09f, 0.07f}, {0.0f, 0.07f}};
      addLathe(iron, at, dish, 12);
      const std::array<vec2, 4> candle = {vec2(0.035f, 0.07f), {0.035f, 0.3f}, {0.035f, 0.3f}, {0.0f, 0.31f}};
      addLathe(candles, at, candle, 10);
      if (i % 3 != 0) continue;
      addBar(iron, {.curve = [&](float s) { return glm::mix(at, top, s); }, .thickness = 0.014f, .pieces = 8, .sections = 5});
    }
  }
  addPart(scene, std::move(iron)), addPart(scene, std::move(candles));
}

}  // namespace gridscope::hall
