// What can be asked of a scene without drawing it: where its nodes are at a time, how large it is, what moves. See scene.h; the
// starting camera is in default_camera.cpp.
#include "core/scene/scene.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "core/base/error.h"

namespace gridscope {

namespace {

constexpr int kSamplesBetweenKeys = 16;

// sceneBounds stops refining here: samples, and node matrices and vertices that may be computed for the moving part, about half a
// second each.
constexpr uint64_t kSampleLimit = 20'000;
constexpr uint64_t kNodeWork = 10'000'000;
constexpr uint64_t kVertexWork = 50'000'000;

float timeInLoop(const Animation& animation, float timeSeconds) {
  if (!(animation.duration > 0.0f)) return 0.0f;
  const float time = std::fmod(timeSeconds, animation.duration);
  return time < 0.0f ? time + animation.duration : time;
}

quat asQuat(const vec4& xyzw) { return quat(xyzw.w, xyzw.x, xyzw.y, xyzw.z); }

vec4 slerp(const vec4& from, const vec4& to, float share) {
  const quat turned = glm::slerp(asQuat(from), asQuat(to), share);  // the shorter way round
  return vec4(turned.x, turned.y, turned.z, turned.w);
}

// glTF 2.0, appendix C.5: a Hermite spline whose tangents are per second.
vec4 cubicSpline(const Channel& channel, size_t key, float share, float seconds) {
  const vec4* values = &channel.values[3 * key];
  const vec4 begin = values[1], beginTangent = seconds * values[2];
  const vec4 endTangent = seconds * values[3], end = values[4];
  const float t = share, t2 = t * t, t3 = t2 * t;
  return (2.0f * t3 - 3.0f * t2 + 1.0f) * begin + (t3 - 2.0f * t2 + t) * beginTangent + (3.0f * t2 - 2.0f * t3) * end +
         (t3 - t2) * endTangent;
}

vec4 keyValue(const Channel& channel, size_t key) {
  return channel.interpolation == Interpolation::cubicSpline ? channel.values[3 * key + 1] : channel.values[key];
}

vec4 sampleChannel(const Channel& channel, float time) {
  const auto& times = channel.times;
  const size_t after = static_cast<size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  if (after == 0) return keyValue(channel, 0);
  const size_t key = after - 1;
  if (after == times.size() || channel.interpolation == Interpolation::step) return keyValue(channel, key);

  const float seconds = times[after] - times[key];
  const float share = (time - times[key]) / seconds;
  if (channel.interpolation == Interpolation::cubicSpline) return cubicSpline(channel, key, share, seconds);
  const vec4 &from = channel.values[key], &to = channel.values[after];
  return channel.path == ChannelPath::rotation ? slerp(from, to, share) : glm::mix(from, to, share);
}

void applyChannel(Node& node, const Channel& channel, float time) {
  if (channel.times.empty()) return;
  const vec4 value = sampleChannel(channel, time);
  switch (channel.path) {
    case ChannelPath::translation: node.translation = vec3(value); break;
    case ChannelPath::scale: node.scale = vec3(value); break;
    case ChannelPath::rotation: {
      const float length = glm::length(value);  // a spline can pass through zero
      node.rotation = length > 1e-12f ? asQuat(value / length) : quat(1.0f, 0.0f, 0.0f, 0.0f);
      break;
    }
  }
}

mat4 localMatrix(const Node& node) {
  const mat4 placed = glm::translate(mat4(1.0f), node.translation) * glm::mat4_cast(node.rotation);
  return glm::scale(placed, node.scale) * node.matrix;
}

// Exporters like to bake channels that never change their value.
bool changes(const Channel& channel) {
  const size_t keyCount = channel.times.size();
  for (size_t key = 1; key < keyCount; ++key) {
    if (keyValue(channel, key) != keyValue(channel, 0)) return true;
  }
  if (channel.interpolation != Interpolation::cubicSpline || keyCount < 2) return false;
  for (size_t key = 0; key < keyCount; ++key) {
    if (channel.values[3 * key] != vec4(0.0f) || channel.values[3 * key + 2] != vec4(0.0f)) return true;
  }
  return false;
}

// The times at which the moving part is looked at: every key of every animation and 16 between two, as often as the animation
// repeats while the longest runs once. `limit` thins them out evenly.
std::vector<float> sampleTimes(const Scene& scene, size_t limit) {
  float longest = 0.0f;
  for (const Animation& animation : scene.animations) longest = std::max(longest, animation.duration);
  std::vector<float> keys = {0.0f};
  for (const Animation& animation : scene.animations) {
    if (!(animation.duration > 0.0f)) continue;
    for (const Channel& channel : animation.channels) {
      for (float start = 0.0f; start < longest && keys.size() < 4 * limit; start += animation.duration) {
        for (float time : channel.times) keys.push_back(start + time);
        if (start + animation.duration == start) break;
      }
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());

  const size_t wanted = (keys.size() - 1) * (kSamplesBetweenKeys + 1) + 1;
  const size_t step = wanted / limit + 1;
  std::vector<float> times;
  for (size_t i = 0; i < wanted; i += step) {
    const size_t key = i / (kSamplesBetweenKeys + 1);
    const float share = static_cast<float>(i % (kSamplesBetweenKeys + 1)) / (kSamplesBetweenKeys + 1);
    const float next = key + 1 < keys.size() ? keys[key + 1] : keys[key];
    times.push_back(keys[key] + share * (next - keys[key]));
  }
  // The moment before the longest animation begins again; its end itself is its beginning.
  times.push_back(std::nextafter(longest, 0.0f));
  return times;
}

void includeVertices(Bounds& bounds, const std::vector<vec3>& positions, const mat4& matrix) {
  for (const vec3& position : positions) {
    const vec3 world(matrix * vec4(position, 1.0f));
    if (!(std::abs(world.x) <= kCoordinateLimit && std::abs(world.y) <= kCoordinateLimit && std::abs(world.z) <= kCoordinateLimit))
      throw Error("a vertex lies beyond 1,000,000 units from the origin, or nowhere; scale or repair the scene");
    bounds.include(world);
  }
}

std::vector<vec3> cornersOf(const std::vector<vec3>& positions) {
  Bounds bounds;
  for (const vec3& position : positions) bounds.include(position);
  std::vector<vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? bounds.high.x : bounds.low.x, i & 2 ? bounds.high.y : bounds.low.y, i & 4 ? bounds.high.z : bounds.low.z});
  return corners;
}

// The dynamic instances over the whole animation: exactly, or by the corners of their boxes when there is too much to transform.
Bounds dynamicBounds(const Scene& scene) {
  uint64_t vertexCount = 0, instanceCount = 0;
  for (const SceneInstance& instance : scene.instances) {
    if (!instance.dynamic) continue;
    vertexCount += scene.meshes[instance.mesh].positions.size(), ++instanceCount;
  }
  Bounds bounds;
  if (instanceCount == 0) return bounds;
  uint64_t channelCount = 0;
  for (const Animation& animation : scene.animations) channelCount += animation.channels.size();
  const uint64_t affordable = kNodeWork / (scene.nodes.size() + channelCount + 8 * instanceCount);
  const std::vector<float> times = sampleTimes(scene, std::clamp<uint64_t>(affordable, 2, kSampleLimit));
  const bool exact = vertexCount * times.size() <= kVertexWork;

  std::vector<std::vector<vec3>> corners(scene.meshes.size());
  for (float time : times) {
    const std::vector<mat4> transforms = nodeTransforms(scene, time);
    for (const SceneInstance& instance : scene.instances) {
      if (!instance.dynamic) continue;
      const auto& positions = scene.meshes[instance.mesh].positions;
      if (positions.empty()) continue;  // has no box
      auto& box = corners[instance.mesh];
      if (!exact && box.empty()) box = cornersOf(positions);
      includeVertices(bounds, exact ? positions : box, transforms[instance.node] * instance.local);
    }
  }
  return bounds;
}

}  // namespace

std::vector<mat4> nodeTransforms(const Scene& scene, float timeSeconds) {
  std::vector<Node> nodes;
  nodes.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) {
    nodes.push_back({.name = {},
                     .parent = node.parent,
                     .translation = node.translation,
                     .rotation = node.rotation,
                     .scale = node.scale,
                     .matrix = node.matrix});
  }
  for (const Animation& animation : scene.animations) {
    const float time = timeInLoop(animation, timeSeconds);
    for (const Channel& channel : animation.channels) applyChannel(nodes[channel.node], channel, time);
  }
  std::vector<mat4> transforms;
  transforms.reserve(nodes.size());
  for (const Node& node : nodes) {
    const mat4 local = localMatrix(node);
    transforms.push_back(node.parent < 0 ? local : transforms[static_cast<size_t>(node.parent)] * local);
  }
  return transforms;
}

Bounds sceneBounds(const Scene& scene) {
  Bounds bounds;
  const std::vector<mat4> transforms = nodeTransforms(scene, 0.0f);
  for (const SceneInstance& instance : scene.instances) {
    if (!instance.dynamic) includeVertices(bounds, scene.meshes[instance.mesh].positions, transforms[instance.node] * instance.local);
  }
  bounds.include(dynamicBounds(scene));
  if (bounds.empty()) throw Error("the scene holds no triangles; name one with a mesh");
  return bounds;
}

void markAnimatedInstances(Scene& scene) {
  std::vector<bool> moves(scene.nodes.size(), false);
  for (const Animation& animation : scene.animations) {
    for (const Channel& channel : animation.channels) moves[channel.node] = moves[channel.node] || changes(channel);
  }
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    const int32_t parent = scene.nodes[i].parent;
    if (parent >= 0 && moves[static_cast<size_t>(parent)]) moves[i] = true;
  }
  for (SceneInstance& instance : scene.instances) instance.dynamic = moves[instance.node];
}

void makeFlatNormals(Mesh& mesh) {
  mesh.normals.resize(mesh.positions.size(), vec3(0.0f));
  for (size_t corner = 0; corner + 2 < mesh.positions.size(); corner += 3) {
    const glm::dvec3 a = mesh.positions[corner], b = mesh.positions[corner + 1], c = mesh.positions[corner + 2];
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double area = glm::length(cross);
    // Below this the direction is rounding noise of the corners' floats.
    const bool flat = !(area > 1e-12 * glm::length(b - a) * glm::length(c - a));
    const vec3 geometric = flat ? vec3(0.0f, 1.0f, 0.0f) : vec3(cross / area);
    for (size_t i = corner; i < corner + 3; ++i) {
      const float length = glm::length(mesh.normals[i]);
      if (!(length > 0.0f) || !std::isfinite(length)) mesh.normals[i] = geometric;
    }
  }
}

}  // namespace gridscope
