// The hall's vaults with their ribs, and its columns.
#include <array>
#include <cmath>

#include "core/scene/hall.h"

namespace gridscope::hall {

namespace {

// One bay of a groin vault: two pointed tunnels that cross. `half` is half its extent in x and z.
struct VaultBay {
  vec3 spring{0.0f};  // middle of the bay at the height of the springing
  vec2 half{1.0f};
  float rise = 1.0f;

  // A point by its place along x and z, each -1 to 1; the ceiling is the higher of the two tunnels. Over the diagonals, where
  // both are equal, run the groins.
  vec3 at(float x, float z) const {
    const float height = std::max(pointedArch(std::abs(x)), pointedArch(std::abs(z)));
    return spring + vec3(x * half.x, height * rise, z * half.y);
  }
};

// Steps that are short where the arch is steep, near its springing.
float easedPlace(float place) { return std::sin(0.5f * kPi * place); }

// Four webs between the groins, each a triangle that starts in the bay's middle.
void addWebs(Mesh& mesh, const VaultBay& bay, uint32_t cuts) {
  for (uint32_t web = 0; web < 4; ++web) {
    const size_t first = mesh.positions.size();
    const float sign = web < 2 ? 1.0f : -1.0f;
    const Surface surface = [&](float s, float t) {
      const float out = sign * easedPlace(s), along = easedPlace(s * (2.0f * t - 1.0f));
      return web % 2 == 0 ? bay.at(out, along) : bay.at(along, out);
    };
    addPatch(mesh, surface, {.columns = cuts, .rows = cuts});
    for (size_t i = first; i < mesh.positions.size(); ++i) {
      // Courses of stone run along the web's tunnel.
      const vec3& place = mesh.positions[i];
      mesh.uvs[i] = web % 2 == 0 ? vec2(place.x, 1.3f * place.z + 0.5f * place.y) : vec2(place.z, 1.3f * place.x + 0.5f * place.y);
    }
    faceTowards(mesh, first, bay.spring - vec3(0.0f, 2.0f, 0.0f));
  }
}

void addGroinRibs(Mesh& mesh, const VaultBay& bay, float thickness, uint32_t pieces) {
  for (const float slant : {-1.0f, 1.0f}) {
    const auto rib = [&](float s) {
      const float place = easedPlace(2.0f * s - 1.0f);
      return bay.at(place, slant * place) - vec3(0.0f, 0.5f * thickness, 0.0f);
    };
    addBar(mesh, {.curve = rib, .thickness = thickness, .pieces = pieces, .sections = 5});
  }
}

// The arch between two bays, across the nave or aisle, at place z (-1 or 1) of the bay.
void addTransverseRib(Mesh& mesh, const VaultBay& bay, float z, float thickness, uint32_t pieces) {
  const auto rib = [&](float s) { return bay.at(easedPlace(2.0f * s - 1.0f), z) - vec3(0.0f, 0.4f * thickness, 0.0f); };
  addBar(mesh, {.curve = rib, .thickness = thickness, .pieces = pieces, .sections = 8});
}

void addWallRibs(Mesh& mesh, const VaultBay& bay, float thickness) {
  for (const float x : {-1.0f, 1.0f}) {
    const auto rib = [&](float s) { return bay.at(x, easedPlace(2.0f * s - 1.0f)) - vec3(x * 0.5f * thickness, 0.0f, 0.0f); };
    addBar(mesh, {.curve = rib, .thickness = thickness, .pieces = 20, .sections = 5});
  }
}

VaultBay naveVault(uint32_t bay) {
  return {.spring = {0.0f, kSpring, bayStart(bay) - 0.5f * kBay}, .half = {kNave - kArcadeHalf, 0.5f * kBay}, .rise = kVaultRise};
}

VaultBay aisleVault(uint32_t bay, float side) {
  const float inner = kNave + kArcadeHalf;
  return {.spring = {0.5f * side * (inner + kOuter), kCapital, bayStart(bay) - 0.5f * kBay},
          .half = {0.5f * (kOuter - inner), 0.5f * kBay},
          .rise = kAisleRise};
}

// Foot, shaft and capital, as (radius, height); doubled points are edges.
const std::array<vec2, 34> kColumnProfile = {
    vec2(0.62f, 0.0f), {0.62f, 0.16f}, {0.62f, 0.16f}, {0.58f, 0.18f}, {0.58f, 0.18f}, {0.63f, 0.22f}, {0.65f, 0.27f},
    {0.63f, 0.32f},    {0.57f, 0.36f}, {0.57f, 0.36f}, {0.52f, 0.40f}, {0.50f, 0.44f}, {0.54f, 0.48f}, {0.54f, 0.52f},
    {0.48f, 0.56f},    {0.48f, 0.56f}, {0.44f, 0.58f}, {0.44f, 1.2f},  {0.435f, 1.8f}, {0.43f, 2.4f},  {0.42f, 3.0f},
    {0.41f, 3.5f},     {0.41f, 3.5f},  {0.46f, 3.53f}, {0.46f, 3.58f}, {0.41f, 3.61f}, {0.41f, 3.61f}, {0.42f, 3.8f},
    {0.47f, 3.96f},    {0.56f, 4.08f}, {0.66f, 4.15f}, {0.66f, 4.15f}, {0.66f, 4.2f},  {0.60f, 4.2f},
};

// Leaves that curl out of the capital, in two rows.
void addCapitalLeaves(Mesh& mesh, const vec3& foot) {
  constexpr uint32_t kLeaves = 8;
  for (uint32_t row = 0; row < 2; ++row) {
    for (uint32_t leaf = 0; leaf < kLeaves; ++leaf) {
      const float middle = 2.0f * kPi * (static_cast<float>(leaf) + 0.5f * static_cast<float>(row)) / kLeaves;
      const float lower = 3.62f + 0.2f * static_cast<float>(row), height = 0.34f;
      const size_t first = mesh.positions.size();
      const Surface surface = [&](float s, float t) {
        // Widest at a third of its height, and bent outward and over at the tip.
        const float width = 0.62f * (kPi / kLeaves) * std::sqrt(std::sin(kPi * (0.12f + 0.85f * t)));
        const float angle = middle + (2.0f * s - 1.0f) * width;
        const float bulge = 0.05f + 0.03f * std::cos(kPi * (s - 0.5f)) + 0.17f * t * t;
        const float radius = 0.40f + bulge + 0.09f * static_cast<float>(row);
        return foot + vec3(radius * std::cos(angle), lower + height * (t - 0.35f * t * t * t * t), radius * std::sin(angle));
      };
      addPatch(mesh, surface, {.columns = 4, .rows = 5});
      const vec3 outside = foot + vec3(5.0f * std::cos(middle), lower, 5.0f * std::sin(middle));
      faceTowards(mesh, first, outside);
    }
  }
}

void addColumn(Mesh& shafts, Mesh& capitals, const vec3& foot, float naveward) {
  addLathe(shafts, foot, kColumnProfile, 18);
  addBox(capitals, foot + vec3(-0.68f, 4.18f, -0.68f), foot + vec3(0.68f, kCapital, 0.68f), 0.7f);
  addCapitalLeaves(capitals, foot);

  // Three shafts climb from the capital to the springing of the nave's vault.
  for (int32_t k = -1; k <= 1; ++k) {
    const float radius = k == 0 ? 0.13f : 0.09f;
    const vec3 at = foot + vec3(naveward * (k == 0 ? 0.46f : 0.42f), kCapital, 0.19f * static_cast<float>(k));
    constexpr float kHeight = kSpring - kCapital;
    const std::array<vec2, 12> profile = {vec2(1.7f * radius, 0.0f),
                                          {1.7f * radius, 0.12f},
                                          {radius, 0.22f},
                                          {radius, 0.22f},
                                          {radius, 2.0f},
                                          {radius, 3.3f},
                                          {radius, kHeight - 0.4f},
                                          {radius, kHeight - 0.4f},
                                          {1.25f * radius, kHeight - 0.3f},
                                          {1.9f * radius, kHeight - 0.12f},
                                          {1.9f * radius, kHeight - 0.12f},
                                          {1.9f * radius, kHeight}};
    addLathe(shafts, at, profile, 8);
  }
}

}  // namespace

void addVaults(Scene& scene) {
  Mesh vault = newMesh("nave vault", kPlaster), aisles = newMesh("aisle vaults", kPlaster), ribs = newMesh("ribs", kCarved);
  Mesh aisleRibs = newMesh("aisle ribs", kCarved);
  for (uint32_t bay = 0; bay < kBays; ++bay) {
    const VaultBay nave = naveVault(bay);
    addWebs(vault, nave, 12);
    addGroinRibs(ribs, nave, 0.12f, 28);
    addWallRibs(ribs, nave, 0.08f);
    addTransverseRib(ribs, nave, 1.0f, 0.2f, 28);
    addSphere(ribs, nave.at(0.0f, 0.0f) - vec3(0.0f, 0.1f, 0.0f), 0.28f, 20, 10);
    for (const float side : {-1.0f, 1.0f}) {
      const VaultBay aisle = aisleVault(bay, side);
      addWebs(aisles, aisle, 8);
      addGroinRibs(aisleRibs, aisle, 0.08f, 20);
      addTransverseRib(aisleRibs, aisle, 1.0f, 0.12f, 20);
    }
  }
  addTransverseRib(ribs, naveVault(kBays - 1), -1.0f, 0.2f, 28);
  scaleUvs(vault, 1.0f / 2.4f), scaleUvs(aisles, 1.0f / 2.4f);
  for (Mesh* mesh : {&vault, &aisles, &ribs, &aisleRibs}) addPart(scene, std::move(*mesh));
}

void addColumns(Scene& scene) {
  Mesh shafts = newMesh("columns", kCarved), capitals = newMesh("capitals", kCarved);
  for (uint32_t line = 0; line <= kBays; ++line) {
    for (const float side : {-1.0f, 1.0f}) addColumn(shafts, capitals, {side * kNave, 0.0f, bayStart(line)}, -side);
  }
  scaleUvs(shafts, 0.7f);
  addPart(scene, std::move(shafts)), addPart(scene, std::move(capitals));
}

}  // namespace gridscope::hall
