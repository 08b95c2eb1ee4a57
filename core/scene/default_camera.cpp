// The camera to start with when a scene has none: the first picture that a user sees. Surfaces become cells of a coarse occupancy
// grid; inside a room some hundred candidate views are judged by rays through it, a single object is seen from outside.
#include "core/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/gtc/type_precision.hpp>

namespace gridscope {

namespace {

constexpr int kCellsAlongLongest = 128;
constexpr uint64_t kTriangleSamples = 400'000;  // more triangles than this are thinned out
constexpr double kPointSamples = 1'500'000;     // more points than this on all triangles are spread wider

struct SampleTriangle {
  vec3 a, b, c;  // world space
};

// The scene's triangles at time 0, thinned out to about kTriangleSamples.
std::vector<SampleTriangle> worldTriangles(const Scene& scene) {
  uint64_t count = 0;
  for (const SceneInstance& instance : scene.instances) count += scene.meshes[instance.mesh].triangleCount();
  const size_t stride = 3 * (count / kTriangleSamples + 1);
  const std::vector<mat4> transforms = nodeTransforms(scene, 0.0f);
  std::vector<SampleTriangle> triangles;
  triangles.reserve(3 * count / stride + scene.instances.size());
  for (const SceneInstance& instance : scene.instances) {
    const mat4 matrix = transforms[instance.node] * instance.local;
    const auto world = [&](const vec3& position) { return vec3(matrix * vec4(position, 1.0f)); };
    const auto& positions = scene.meshes[instance.mesh].positions;
    for (size_t i = 0; i + 2 < positions.size(); i += stride)
      triangles.push_back({world(positions[i]), world(positions[i + 1]), world(positions[i + 2])});
  }
  return triangles;
}

// What a ray meets in the coarse grid.
struct Meeting {
  float distance = 0.0f;
  bool surface = false;  // false: it left the grid
  bool front = false;    // the surface's front, by its winding
};

// Which cells of a coarse grid over the bounds hold a surface, and which way one of its triangles faces.
class Occupancy {
 public:
  Occupancy(std::span<const SampleTriangle> triangles, const Bounds& bounds) : low_(bounds.low) {
    const vec3 extent = bounds.high - bounds.low;
    edge_ = std::max({extent.x, extent.y, extent.z, 1e-30f}) / kCellsAlongLongest;
    for (int a = 0; a < 3; ++a) cells_[static_cast<size_t>(a)] = static_cast<int>(extent[a] / edge_) + 1;
    filled_.assign(static_cast<size_t>(cells_[0]) * static_cast<size_t>(cells_[1]) * static_cast<size_t>(cells_[2]), 0);
    normals_.resize(filled_.size());
    addTriangles(triangles);
  }

  bool filled(const vec3& point) const {
    const int64_t cell = cellOf(point);
    return cell >= 0 && filled_[static_cast<size_t>(cell)];
  }

  // Along a unit direction, in steps that may pass the corner of a cell: walls are more than a cell thick here.
  Meeting meet(const vec3& origin, const vec3& direction) const {
    constexpr int kStepLimit = 4 * kCellsAlongLongest;
    float t = 0.0f;
    for (int step = 1; step < kStepLimit; ++step) {
      t = 0.75f * edge_ * static_cast<float>(step);
      const int64_t cell = cellOf(origin + t * direction);
      if (cell < 0) break;
      if (!filled_[static_cast<size_t>(cell)]) continue;
      return {.distance = t, .surface = true, .front = glm::dot(vec3(normals_[static_cast<size_t>(cell)]), direction) < 0.0f};
    }
    return {.distance = t};
  }

 private:
  int64_t cellOf(const vec3& point) const {
    int64_t cell = 0;
    for (int a = 2; a >= 0; --a) {
      const float place = (point[a] - low_[a]) / edge_;
      const int count = cells_[static_cast<size_t>(a)];
      if (!(place >= 0.0f && place < static_cast<float>(count))) return -1;
      cell = cell * count + static_cast<int>(place);
    }
    return cell;
  }

  void addTriangles(std::span<const SampleTriangle> triangles) {
    double area = 0.0;
    for (const auto& [a, b, c] : triangles) area += 0.5 * static_cast<double>(glm::length(glm::cross(b - a, c - a)));
    // Closer than a cell, unless the points would be too many.
    const double spacing = std::max(0.7 * static_cast<double>(edge_), std::sqrt(area / kPointSamples));
    for (const SampleTriangle& triangle : triangles) addTriangle(triangle, static_cast<float>(spacing));
  }

  // Points in rows between the corners: rows along the sides that meet in a.
  void addTriangle(const SampleTriangle& triangle, float spacing) {
    const auto& [a, b, c] = triangle;
    const vec3 cross = glm::cross(b - a, c - a);
    const float length = glm::length(cross);
    const glm::i8vec3 normal = length > 1e-30f ? glm::i8vec3(cross * (127.0f / length)) : glm::i8vec3(0);
    const float rowCount = std::min(std::ceil(glm::length(b - a) / spacing), 4096.0f);
    for (float row = 0.0f; row <= rowCount; ++row) {
      const float share = rowCount > 0.0f ? row / rowCount : 0.0f;
      const vec3 begin = glm::mix(a, b, share), end = glm::mix(a, c, share);
      const float pointCount = std::min(std::ceil(glm::length(end - begin) / spacing), 4096.0f);
      for (float i = 0.0f; i <= pointCount; ++i) add(glm::mix(begin, end, pointCount > 0.0f ? i / pointCount : 0.0f), normal);
    }
    add(c, normal);
  }

  void add(const vec3& point, const glm::i8vec3& normal) {
    const int64_t cell = cellOf(point);
    if (cell < 0) return;
    filled_[static_cast<size_t>(cell)] = 1;
    normals_[static_cast<size_t>(cell)] = normal;
  }

  vec3 low_;
  float edge_ = 1.0f;
  std::array<int, 3> cells_{};
  std::vector<char> filled_;
  std::vector<glm::i8vec3> normals_;
};

// The horizontal axes, the longer one first; y is up.
struct Axes {
  int along, across;
};
Axes axesOf(const Bounds& bounds) {
  const vec3 extent = bounds.high - bounds.low;
  return extent.x >= extent.z ? Axes{0, 2} : Axes{2, 0};
}

// Whether one looks at this scene from inside: level rays from all over the bounds nearly all meet a surface, and not its back as in
// a closed box. Around an object about a half of them leave; a flat scene has no inside.
bool isRoom(const Occupancy& occupancy, const Bounds& bounds) {
  const vec3 extent = bounds.high - bounds.low;
  if (std::min({extent.x, extent.y, extent.z}) <= 0.08f * std::max({extent.x, extent.y, extent.z})) return false;
  int rayCount = 0, surfaceCount = 0, frontCount = 0;
  for (int i = 0; i < 4 * 3 * 4; ++i) {
    const vec3 share((static_cast<float>(i % 4) + 0.5f) / 4.0f, (static_cast<float>(i / 4 % 3) + 0.6f) / 5.0f,
                     (static_cast<float>(i / 12) + 0.5f) / 4.0f);
    const vec3 origin = glm::mix(bounds.low, bounds.high, share);
    for (int k = 0; k < 16; ++k, ++rayCount) {
      const float angle = 0.3926991f * (static_cast<float>(k) + 0.5f);
      const Meeting meeting = occupancy.meet(origin, vec3(std::cos(angle), 0.0f, std::sin(angle)));
      surfaceCount += meeting.surface, frontCount += meeting.front;
    }
  }
  return 10 * surfaceCount > 8 * rayCount && 5 * frontCount > surfaceCount;
}

CameraPose lookFrom(const vec3& eye, const vec3& direction, float fovDegrees) {
  return {.name = "default", .eye = eye, .target = eye + direction, .up = vec3(0.0f, 1.0f, 0.0f), .verticalFovDegrees = fovDegrees};
}

constexpr float kRoomFov = 65.0f;
constexpr int kFanColumns = 14, kFanRows = 8;

// How good a picture from here would be: deep and wide views with many edges are good; a surface close before the eye and a look out
// of the scene are bad. Distances are in lengths of the scene.
float score(const Occupancy& occupancy, const CameraPose& camera, float length) {
  constexpr float kNear = 0.07f;
  if (occupancy.filled(camera.eye)) return -1e9f;
  const vec3 forward = glm::normalize(camera.target - camera.eye);
  const vec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
  const float tall = std::tan(glm::radians(0.5f * camera.verticalFovDegrees)), wide = tall * 16.0f / 9.0f;
  float total = 0.0f;
  std::array<float, kFanColumns> above{};
  for (int row = kFanRows - 1; row >= 0; --row) {
    float left = 0.0f;
    for (int column = 0; column < kFanColumns; ++column) {
      const float x = (static_cast<float>(column) + 0.5f) / (0.5f * kFanColumns) - 1.0f;
      const float y = (static_cast<float>(row) + 0.5f) / (0.5f * kFanRows) - 1.0f;
      const Meeting meeting = occupancy.meet(camera.eye, glm::normalize(forward + wide * x * right + tall * y * up));
      const float distance = std::min(meeting.distance / length, 1.0f);
      float value = distance - 1.5f * std::max(1.0f - distance / kNear, 0.0f);
      if (!meeting.surface) value = y > 0.0f ? 0.1f : -0.5f;  // sky through an open roof is no fault
      float& higher = above[static_cast<size_t>(column)];
      if (column > 0) value += 0.5f * std::min(std::abs(distance - left), 0.3f);
      if (row < kFanRows - 1) value += 0.5f * std::min(std::abs(distance - higher), 0.3f);
      total += value * std::exp(-2.0f * (x * x + y * y));
      left = higher = distance;
    }
  }
  return total;
}

// The floor under a point, or the bottom of the bounds.
float floorBelow(const Occupancy& occupancy, const Bounds& bounds, const vec3& point) {
  const Meeting floor = occupancy.meet(point, vec3(0.0f, -1.0f, 0.0f));
  return floor.surface ? point.y - floor.distance : bounds.low.y;
}

CameraPose insideView(const Occupancy& occupancy, const Bounds& bounds) {
  const Axes axes = axesOf(bounds);
  const vec3 extent = bounds.high - bounds.low;
  const float eyeHeight = std::clamp(1.7f, 0.12f * extent.y, 0.5f * extent.y);
  CameraPose best;
  float bestScore = -1e30f;
  for (float along : {0.06f, 0.1f, 0.15f, 0.2f, 0.25f}) {
    for (float across : {0.5f, 0.4f, 0.6f, 0.27f, 0.73f}) {
      for (float end : {1.0f, -1.0f}) {
        vec3 share(0.25f);
        share[axes.along] = end > 0.0f ? along : 1.0f - along;
        share[axes.across] = across;
        vec3 eye = bounds.low + share * extent;
        eye.y = floorBelow(occupancy, bounds, eye) + eyeHeight;
        for (float turn : {0.0f, 0.25f, -0.25f}) {
          vec3 direction(0.0f, -0.03f, 0.0f);
          direction[axes.along] = end * std::cos(turn);
          direction[axes.across] = std::sin(turn);
          const CameraPose camera = lookFrom(eye, extent[axes.along] * glm::normalize(direction), kRoomFov);
          const float value = score(occupancy, camera, extent[axes.along]) - 2.0f * std::abs(turn);
          if (value > bestScore) best = camera, bestScore = value;
        }
      }
    }
  }
  return best;
}

// From the front, a little from the side and from above, as near as all corners allow in a 16:9 picture.
CameraPose outsideView(std::span<const SampleTriangle> triangles, const Bounds& bounds) {
  constexpr float kFov = 40.0f, kFill = 0.9f;
  const vec3 middle = 0.5f * (bounds.low + bounds.high);
  const vec3 back = glm::normalize(vec3(0.45f, 0.4f, 1.0f));
  const vec3 right = glm::normalize(glm::cross(vec3(0.0f, 1.0f, 0.0f), back)), up = glm::cross(back, right);
  const float tall = kFill * std::tan(glm::radians(0.5f * kFov)), wide = tall * 16.0f / 9.0f;
  float distance = 1e-6f;
  for (const SampleTriangle& triangle : triangles) {
    for (const vec3& corner : {triangle.a - middle, triangle.b - middle, triangle.c - middle}) {
      const float needed = std::max(std::abs(glm::dot(corner, right)) / wide, std::abs(glm::dot(corner, up)) / tall);
      distance = std::max(distance, glm::dot(corner, back) + needed);
    }
  }
  return lookFrom(middle + distance * back, -distance * back, kFov);
}

}  // namespace

CameraPose defaultCamera(const Scene& scene) {
  if (!scene.cameras.empty()) return scene.cameras.front();
  const Bounds bounds = sceneBounds(scene);
  const std::vector<SampleTriangle> triangles = worldTriangles(scene);
  const Occupancy occupancy(triangles, bounds);
  return isRoom(occupancy, bounds) ? insideView(occupancy, bounds) : outsideView(triangles, bounds);
}

}  // namespace gridscope
