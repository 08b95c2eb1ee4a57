// The patches are those that Martin Newell drew up at the University of Utah in 1975, in the proportions in common use since
// Blinn flattened them (Frank Crow, "The Origins of the Teapot", 1987). Lid, body and bottom are made of quarters about the
// vertical axis, handle and spout of halves: ten patches and their mirror images give the 32.
#include "core/scene/teapot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/scene/mesh_builder.h"

namespace gridscope {

namespace {

// Control points of Newell's own frame: z up, the spout along +x.
constexpr std::array<std::array<float, 3>, 127> kPoints = {{
    {0.2f, 0, 2.7f},
    {0.2f, -0.112f, 2.7f},
    {0.112f, -0.2f, 2.7f},
    {0, -0.2f, 2.7f},
    {1.3375f, 0, 2.53125f},
    {1.3375f, -0.749f, 2.53125f},
    {0.749f, -1.3375f, 2.53125f},
    {0, -1.3375f, 2.53125f},
    {1.4375f, 0, 2.53125f},
    {1.4375f, -0.805f, 2.53125f},
    {0.805f, -1.4375f, 2.53125f},
    {0, -1.4375f, 2.53125f},
    {1.5f, 0, 2.4f},
    {1.5f, -0.84f, 2.4f},
    {0.84f, -1.5f, 2.4f},
    {0, -1.5f, 2.4f},
    {1.75f, 0, 1.875f},
    {1.75f, -0.98f, 1.875f},
    {0.98f, -1.75f, 1.875f},
    {0, -1.75f, 1.875f},
    {2, 0, 1.35f},
    {2, -1.12f, 1.35f},
    {1.12f, -2, 1.35f},
    {0, -2, 1.35f},
    {2, 0, 0.9f},
    {2, -1.12f, 0.9f},
    {1.12f, -2, 0.9f},
    {0, -2, 0.9f},
    {-2, 0, 0.9f},
    {2, 0, 0.45f},
    {2, -1.12f, 0.45f},
    {1.12f, -2, 0.45f},
    {0, -2, 0.45f},
    {1.5f, 0, 0.225f},
    {1.5f, -0.84f, 0.225f},
    {0.84f, -1.5f, 0.225f},
    {0, -1.5f, 0.225f},
    {1.5f, 0, 0.15f},
    {1.5f, -0.84f, 0.15f},
    {0.84f, -1.5f, 0.15f},
    {0, -1.5f, 0.15f},
    {-1.6f, 0, 2.025f},
    {-1.6f, -0.3f, 2.025f},
    {-1.5f, -0.3f, 2.25f},
    {-1.5f, 0, 2.25f},
    {-2.3f, 0, 2.025f},
    {-2.3f, -0.3f, 2.025f},
    {-2.5f, -0.3f, 2.25f},
    {-2.5f, 0, 2.25f},
    {-2.7f, 0, 2.025f},
    {-2.7f, -0.3f, 2.025f},
    {-3, -0.3f, 2.25f},
    {-3, 0, 2.25f},
    {-2.7f, 0, 1.8f},
    {-2.7f, -0.3f, 1.8f},
    {-3, -0.3f, 1.8f},
    {-3, 0, 1.8f},
    {-2.7f, 0, 1.575f},
    {-2.7f, -0.3f, 1.575f},
    {-3, -0.3f, 1.35f},
    {-3, 0, 1.35f},
    {-2.5f, 0, 1.125f},
    {-2.5f, -0.3f, 1.125f},
    {-2.65f, -0.3f, 0.9375f},
    {-2.65f, 0, 0.9375f},
    {-2, -0.3f, 0.9f},
    {-1.9f, -0.3f, 0.6f},
    {-1.9f, 0, 0.6f},
    {1.7f, 0, 1.425f},
    {1.7f, -0.66f, 1.425f},
    {1.7f, -0.66f, 0.6f},
    {1.7f, 0, 0.6f},
    {2.6f, 0, 1.425f},
    {2.6f, -0.66f, 1.425f},
    {3.1f, -0.66f, 0.825f},
    {3.1f, 0, 0.825f},
    {2.3f, 0, 2.1f},
    {2.3f, -0.25f, 2.1f},
    {2.4f, -0.25f, 2.025f},
    {2.4f, 0, 2.025f},
    {2.7f, 0, 2.4f},
    {2.7f, -0.25f, 2.4f},
    {3.3f, -0.25f, 2.4f},
    {3.3f, 0, 2.4f},
    {2.8f, 0, 2.475f},
    {2.8f, -0.25f, 2.475f},
    {3.525f, -0.25f, 2.49375f},
    {3.525f, 0, 2.49375f},
    {2.9f, 0, 2.475f},
    {2.9f, -0.15f, 2.475f},
    {3.45f, -0.15f, 2.5125f},
    {3.45f, 0, 2.5125f},
    {2.8f, 0, 2.4f},
    {2.8f, -0.15f, 2.4f},
    {3.2f, -0.15f, 2.4f},
    {3.2f, 0, 2.4f},
    {0, 0, 3.15f},
    {0.8f, 0, 3.15f},
    {0.8f, -0.45f, 3.15f},
    {0.45f, -0.8f, 3.15f},
    {0, -0.8f, 3.15f},
    {0, 0, 2.85f},
    {1.4f, 0, 2.4f},
    {1.4f, -0.784f, 2.4f},
    {0.784f, -1.4f, 2.4f},
    {0, -1.4f, 2.4f},
    {0.4f, 0, 2.55f},
    {0.4f, -0.224f, 2.55f},
    {0.224f, -0.4f, 2.55f},
    {0, -0.4f, 2.55f},
    {1.3f, 0, 2.55f},
    {1.3f, -0.728f, 2.55f},
    {0.728f, -1.3f, 2.55f},
    {0, -1.3f, 2.55f},
    {1.3f, 0, 2.4f},
    {1.3f, -0.728f, 2.4f},
    {0.728f, -1.3f, 2.4f},
    {0, -1.3f, 2.4f},
    {0, 0, 0},
    {1.425f, -0.798f, 0},
    {1.5f, 0, 0.075f},
    {1.425f, 0, 0},
    {0.798f, -1.425f, 0},
    {0, -1.5f, 0.075f},
    {0, -1.425f, 0},
    {1.5f, -0.84f, 0.075f},
    {0.84f, -1.5f, 0.075f},
}};

// Sixteen control points, four rows of four. All are right-handed: cross(d/du, d/dv) points outward, u along a row.
struct TeapotPatch {
  bool quarters = false;  // mirrored in x and in y: four patches; otherwise in y alone: two
  std::array<uint8_t, 16> points;
};

constexpr std::array<TeapotPatch, 10> kPatches = {{
    {true, {102, 103, 104, 105, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}},                // rim
    {true, {12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27}},              // upper body
    {true, {24, 25, 26, 27, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40}},              // lower body
    {true, {96, 96, 96, 96, 97, 98, 99, 100, 101, 101, 101, 101, 0, 1, 2, 3}},             // knob
    {true, {0, 1, 2, 3, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117}},      // lid
    {true, {118, 118, 118, 118, 124, 122, 119, 121, 123, 126, 125, 120, 40, 39, 38, 37}},  // bottom
    {false, {41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56}},             // handle, upper half
    {false, {53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 28, 65, 66, 67}},             // handle, lower half
    {false, {68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83}},             // spout
    {false, {80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95}},             // spout, tip
}};

std::array<float, 4> bernstein(float t) {
  const float rest = 1.0f - t;
  return {rest * rest * rest, 3.0f * t * rest * rest, 3.0f * t * t * rest, t * t * t};
}

std::array<float, 4> bernsteinSlope(float t) {
  const float rest = 1.0f - t;
  return {-3.0f * rest * rest, 3.0f * rest * rest - 6.0f * t * rest, 6.0f * t * rest - 3.0f * t * t, 3.0f * t * t};
}

vec3 weightedSum(const TeapotPatch& patch, const std::array<float, 4>& row, const std::array<float, 4>& column) {
  vec3 sum(0.0f);
  for (uint32_t i = 0; i < 16; ++i) {
    const std::array<float, 3>& point = kPoints[patch.points[i]];
    sum += row[i % 4] * column[i / 4] * vec3(point[0], point[1], point[2]);
  }
  return sum;
}

// Position and unit normal, in Newell's frame. At the top of the knob and the middle of the bottom a whole row of control
// points is one point, and the slope along it vanishes.
MeshCorner evaluate(const TeapotPatch& patch, float u, float v) {
  const auto normalAt = [&](float s, float t) {
    return glm::cross(weightedSum(patch, bernsteinSlope(s), bernstein(t)), weightedSum(patch, bernstein(s), bernsteinSlope(t)));
  };
  // Rounding must not spread the one point of such a row: its triangles would be slivers instead of nothing.
  const bool pole = v == 0.0f && patch.points[0] == patch.points[3];
  if (pole) {
    const float up = patch.points[0] == 96 ? 1.0f : -1.0f;
    return {.position = weightedSum(patch, bernstein(0.0f), bernstein(0.0f)), .normal = {0.0f, 0.0f, up}, .uv = {u, v}};
  }

  vec3 normal = normalAt(u, v);
  if (glm::dot(normal, normal) < 1e-8f) normal = normalAt(u, v < 0.5f ? v + 0.01f : v - 0.01f);
  return {.position = weightedSum(patch, bernstein(u), bernstein(v)), .normal = glm::normalize(normal), .uv = {u, v}};
}

// From Newell's frame to ours (y up), mirrored in the planes of the handle (y) and across it (x).
vec3 placed(const vec3& point, bool mirrorX, bool mirrorY) { return {mirrorX ? -point.x : point.x, point.z, mirrorY ? point.y : -point.y}; }

void addTeapotPatch(Mesh& mesh, const TeapotPatch& patch, uint32_t subdivisions, bool mirrorX, bool mirrorY) {
  std::vector<MeshCorner> corners;
  for (uint32_t row = 0; row <= subdivisions; ++row) {
    for (uint32_t column = 0; column <= subdivisions; ++column) {
      const float steps = static_cast<float>(subdivisions);
      MeshCorner corner = evaluate(patch, static_cast<float>(column) / steps, static_cast<float>(row) / steps);
      corner.position = placed(corner.position, mirrorX, mirrorY);
      corner.normal = placed(corner.normal, mirrorX, mirrorY);
      corners.push_back(corner);
    }
  }

  // Each mirror turns the winding around.
  const bool turned = mirrorX != mirrorY;
  for (uint32_t row = 0; row < subdivisions; ++row) {
    for (uint32_t column = 0; column < subdivisions; ++column) {
      const MeshCorner* near = &corners[row * (subdivisions + 1) + column];
      const MeshCorner* far = near + subdivisions + 1;
      addTriangle(mesh, near[0], turned ? far[1] : near[1], turned ? near[1] : far[1]);
      addTriangle(mesh, near[0], turned ? far[0] : far[1], turned ? far[1] : far[0]);
    }
  }
}

// A point and its turn on the circle, a share of the period after the start.
vec3 pathPoint(const TeapotPath& path, float share) {
  const float angle = 2.0f * kPi * (path.startTurn + share);
  // Two bobs a round, so that the path closes.
  const float height = path.bob * std::sin(4.0f * kPi * share);
  return path.centre + vec3(path.radius * std::cos(angle), height, path.radius * std::sin(angle));
}

quat pathTurn(const TeapotPath& path, float share) {
  const float angle = -2.0f * kPi * (path.startTurn + share) - 0.5f * kPi;
  return {std::cos(0.5f * angle), 0.0f, std::sin(0.5f * angle), 0.0f};
}

Animation makeRound(const TeapotPath& path, uint32_t node, const std::string& name) {
  // Linear between the keys: a chord of 1/32 of a circle leaves it by half a percent of the radius.
  constexpr uint32_t kKeys = 32;
  Channel place, turn;
  place.node = turn.node = node;
  turn.path = ChannelPath::rotation;
  for (uint32_t key = 0; key <= kKeys; ++key) {
    const float share = static_cast<float>(key) / static_cast<float>(kKeys);
    const quat rotation = pathTurn(path, share);
    place.times.push_back(share * path.periodSeconds);
    place.values.push_back(vec4(pathPoint(path, share), 0.0f));
    turn.times.push_back(share * path.periodSeconds);
    turn.values.push_back(vec4(rotation.x, rotation.y, rotation.z, rotation.w));
  }
  return {.name = name, .duration = path.periodSeconds, .channels = {std::move(place), std::move(turn)}};
}

// The triangles of a scene at time 0 in world space, for a few rays.
class Room {
 public:
  explicit Room(const Scene& scene) {
    const std::vector<mat4> transforms = nodeTransforms(scene, 0.0f);
    for (const SceneInstance& instance : scene.instances) {
      const mat4 world = transforms[instance.node] * instance.local;
      for (const vec3& position : scene.meshes[instance.mesh].positions) {
        corners_.push_back(vec3(world * vec4(position, 1.0f)));
      }
    }
  }

  // How far one can go from a point in a unit direction before a surface, at most `limit`.
  float freeDistance(const vec3& origin, const vec3& direction, float limit) const {
    for (size_t i = 0; i + 2 < corners_.size(); i += 3) {
      const vec3 edge1 = corners_[i + 1] - corners_[i], edge2 = corners_[i + 2] - corners_[i];
      const vec3 p = glm::cross(direction, edge2), offset = origin - corners_[i];
      const float determinant = glm::dot(edge1, p);
      if (determinant == 0.0f) continue;
      const vec3 q = glm::cross(offset, edge1);
      const float u = glm::dot(offset, p) / determinant, v = glm::dot(direction, q) / determinant;
      const float t = glm::dot(edge2, q) / determinant;
      if (u >= 0.0f && v >= 0.0f && u + v <= 1.0f && t > 0.0f) limit = std::min(limit, t);
    }
    return limit;
  }

 private:
  std::vector<vec3> corners_;
};

// The share of a teapot's length that it reaches from its axis (the spout's tip: 3.525 of 6.525), and its height.
constexpr float kReach = 0.55f, kHeight = 3.15f / kTeapotLength;

// The length of a teapot for a room: a ninth of its shortest side; flat scenes are taken as at least a quarter as high as long.
float fittingLength(const vec3& size) {
  const float shortest = std::min({size.x, size.y, size.z}), longest = std::max({size.x, size.y, size.z});
  return std::max(shortest, 0.25f * longest) / 9.0f;
}

// A unit direction through a place of the picture, from (-1, -1) at the lower left to (1, 1), for a picture as high as wide.
vec3 viewDirection(const CameraPose& camera, float x, float y) {
  const vec3 forward = glm::normalize(camera.target - camera.eye);
  const vec3 right = glm::normalize(glm::cross(forward, camera.up));
  const float slope = std::tan(0.5f * glm::radians(camera.verticalFovDegrees));
  return glm::normalize(forward + slope * (x * right + y * glm::cross(right, forward)));
}

// Where the k-th of `count` teapots goes: one after the other into the depth of the picture, left, right and middle in turn.
TeapotPath placeTeapot(const Room& room, const CameraPose& camera, const Bounds& bounds, float length, float depthShare, uint32_t index) {
  constexpr std::array kSides = {-0.55f, 0.6f, 0.05f};
  const vec3 direction = viewDirection(camera, kSides[index % 3], -0.12f - 0.1f * hashUnit(index, 3));

  // As deep as wanted, or as the room allows.
  const float roomLength = glm::length(bounds.high - bounds.low);
  const float free = room.freeDistance(camera.eye, direction, roomLength);
  const float depth = std::min(length * glm::mix(3.0f, 9.0f, depthShare), std::max(0.6f * free, free - 1.5f * length));
  vec3 centre = camera.eye + depth * direction;

  // Down towards the floor, so that a glossy floor mirrors it, but not out of the picture.
  const float drop = room.freeDistance(centre, vec3(0.0f, -1.0f, 0.0f), depth);
  centre.y -= std::clamp(drop - 0.45f * length, 0.0f, 0.12f * depth);

  // A circle that the walls leave room for.
  float clear = 2.0f * length;
  for (uint32_t side = 0; side < 8; ++side) {
    const float angle = 0.25f * kPi * static_cast<float>(side);
    clear = room.freeDistance(centre, vec3(std::cos(angle), 0.0f, std::sin(angle)), clear);
  }
  const float radius = std::clamp(clear - kReach * length, 0.1f * length, 0.7f * length), bob = 0.15f * length;

  const float margin = radius + kReach * length;
  const vec3 low = bounds.low + vec3(margin, bob, margin), high = bounds.high - vec3(margin, bob + kHeight * length, margin);
  centre = glm::min(glm::max(centre, glm::min(low, high)), glm::max(low, high));
  return {.centre = centre, .length = length, .radius = radius, .bob = bob};
}

}  // namespace

void addTeapot(Scene& scene, const TeapotPath& path) {
  const uint32_t node = static_cast<uint32_t>(scene.nodes.size());
  const std::string name = "teapot " + std::to_string(scene.instances.size());
  scene.materials.push_back({.name = name, .baseColour = path.baseColour, .metallic = path.metallic, .roughness = 0.12f});
  scene.meshes.push_back(makeTeapot(kTeapotSubdivisions, static_cast<uint32_t>(scene.materials.size() - 1)));
  scene.meshes.back().name = name;
  scene.nodes.push_back(
      {.name = name, .translation = pathPoint(path, 0.0f), .rotation = pathTurn(path, 0.0f), .scale = vec3(path.length / kTeapotLength)});
  scene.instances.push_back({.name = name, .node = node, .mesh = static_cast<uint32_t>(scene.meshes.size() - 1), .dynamic = true});
  if (path.periodSeconds > 0.0f) scene.animations.push_back(makeRound(path, node, name));
}

void addTeapots(Scene& scene, uint32_t count, uint32_t movingCount) {
  // Enamel and brass; colours far apart, so that each teapot is known by its colour.
  constexpr std::array kColours = {vec4(0.72f, 0.06f, 0.04f, 1.0f), vec4(0.03f, 0.22f, 0.55f, 1.0f), vec4(0.95f, 0.62f, 0.18f, 1.0f),
                                   vec4(0.05f, 0.38f, 0.16f, 1.0f), vec4(0.80f, 0.78f, 0.72f, 1.0f), vec4(0.36f, 0.08f, 0.40f, 1.0f)};
  const CameraPose camera = defaultCamera(scene);
  const Bounds bounds = sceneBounds(scene);
  const Room room(scene);
  const float length = fittingLength(bounds.high - bounds.low);

  for (uint32_t index = 0; index < count; ++index) {
    const float depthShare = (static_cast<float>(index) + 0.5f) / static_cast<float>(count);
    TeapotPath path = placeTeapot(room, camera, bounds, length, depthShare, index);
    // Periods without a common divisor: the picture does not repeat soon.
    path.periodSeconds = index < movingCount ? 7.0f + 1.3f * static_cast<float>(index % 7) : 0.0f;
    path.startTurn = hashUnit(index, 7);
    path.baseColour = kColours[index % kColours.size()];
    path.metallic = index % kColours.size() == 2 ? 1.0f : 0.0f;
    addTeapot(scene, path);
  }
}

Mesh makeTeapot(uint32_t subdivisions, uint32_t materialIndex) {
  Mesh mesh = newMesh("teapot", materialIndex);
  subdivisions = std::max(1u, subdivisions);
  for (const TeapotPatch& patch : kPatches) {
    for (const bool mirrorX : {false, true}) {
      if (mirrorX && !patch.quarters) continue;
      for (const bool mirrorY : {false, true}) addTeapotPatch(mesh, patch, subdivisions, mirrorX, mirrorY);
    }
  }
  return mesh;
}

}  // namespace gridscope
