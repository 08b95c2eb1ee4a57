// The hall's plan: its measures, the light that is baked into its vertex colours, and its parts, a function each.
// The nave runs along z, its floor is y = 0 and its middle x = 0; aisles lie on both sides. All in metres.
#pragma once

#include "core/scene/mesh_builder.h"

namespace gridscope::hall {

inline constexpr uint32_t kBays = 7;
inline constexpr float kBay = 4.5f;                 // length of a bay along z
inline constexpr float kEnd = 0.5f * kBays * kBay;  // end walls at z = -kEnd (the rose) and +kEnd (the door)
inline constexpr float kNave = 4.0f;                // half the nave's width, to the middle of the arcade
inline constexpr float kArcadeHalf = 0.42f;         // half the thickness of the walls above the columns
inline constexpr float kOuter = 8.2f;               // inner face of the outer walls
inline constexpr float kOuterThickness = 0.5f;
inline constexpr float kCapital = 4.4f;  // top of the columns, where arcade and aisle vaults spring
inline constexpr float kString = 7.7f;   // moulding between arcade and clerestory
inline constexpr float kSpring = 9.6f;   // where the nave's vault springs
inline constexpr float kVaultRise = 4.6f;
inline constexpr float kAisleRise = 2.9f;
inline constexpr float kRoseY = 9.7f;  // middle of the rose window
inline constexpr float kRoseRadius = 2.4f;

// An opening with a pointed arch, in a wall that is measured by (u, y): u along the wall.
struct Opening {
  float middle = 0.0f;
  float halfWidth = 1.0f;
  float bottom = 0.0f;
  float spring = 1.0f;       // where the arch begins
  float rise = 1.0f;         // from there to the point
  float top(float u) const;  // lower edge of the wall above the opening
};

inline constexpr Opening kArcadeArch{.middle = 0.5f * kBay, .halfWidth = 1.78f, .bottom = kCapital, .spring = kCapital, .rise = 2.7f};
inline constexpr Opening kClerestory{.middle = 0.5f * kBay, .halfWidth = 1.0f, .bottom = 8.2f, .spring = 10.6f, .rise = 1.6f};
inline constexpr Opening kAisleWindow{.middle = 0.5f * kBay, .halfWidth = 0.75f, .bottom = 1.5f, .spring = 3.7f, .rise = 1.35f};

// A pointed arch over [0, 1]: 1 at the middle (0), 0 at the springing (1). Two arcs, each about the other's springing.
float pointedArch(float distance);

inline float bayStart(uint32_t bay) { return kEnd - kBay * static_cast<float>(bay); }

// Light that arrives at a point: of windows and sky, of sunbeams through the windows, less in corners and near the floor. In [0, 1].
vec3 bakedLight(const vec3& position, const vec3& normal);

// Materials by their index in the scene.
enum HallMaterial : uint32_t {
  kStone,
  kPlaster,
  kCarved,
  kTiles,
  kInlay,
  kFlags,
  kStainedGlass,
  kPaleGlass,
  kLeaf,
  kGold,
  kIron,
  kWood,
  kClay,
  kWax,
};
void addMaterials(Scene& scene);

// Adds a mesh with a node and a static instance of its name, baked light multiplied in.
void addPart(Scene& scene, Mesh mesh);

void addFloors(Scene& scene);
void addArcades(Scene& scene);
void addOuterWalls(Scene& scene);
void addEndWalls(Scene& scene);
void addVaults(Scene& scene);
void addColumns(Scene& scene);
void addGlass(Scene& scene);
void addFiligree(Scene& scene);
void addIvy(Scene& scene);
void addPlanters(Scene& scene);
void addChandeliers(Scene& scene);

// Where the filigree stands: the middle of its globe.
inline constexpr vec3 kFiligree{1.55f, 1.62f, 6.4f};

}  // namespace gridscope::hall
