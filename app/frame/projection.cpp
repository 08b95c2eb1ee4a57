// See projection.h.
#include "app/frame/projection.h"
#include "shaders/shared/grid/grid.h"

#include <algorithm>
#include <cmath>

namespace gridscope {

namespace {

// Right, up and forward distances from the eye.
vec3 viewSpace(const CameraParameters& camera, const vec3& world) {
  const vec3 offset = world - camera.eye;
  return vec3(glm::dot(offset, camera.right), glm::dot(offset, camera.up), glm::dot(offset, camera.forward));
}

ProjectedPoint projectView(const CameraParameters& camera, const vec3& view) {
  const vec2 place(view.x / (view.z * camera.tanHalfWidth), -view.y / (view.z * camera.tanHalfHeight));
  return {.pixel = (place * 0.5f + 0.5f) * vec2(camera.width, camera.height), .depth = glm::length(view)};
}

// Narrows [low, high] of a line's parameter to where start + t * way >= 0; false when nothing is left.
bool keepPositive(float start, float end, vec2& range) {
  const float way = end - start;
  if (start < 0.0f && end < 0.0f) return false;
  if (start < 0.0f) range.x = std::max(range.x, -start / way);
  if (end < 0.0f) range.y = std::min(range.y, start / -way);
  return range.x < range.y;
}

WorldLine part(const WorldLine& line, const vec2& range) {
  return {line.a + (line.b - line.a) * range.x, line.a + (line.b - line.a) * range.y};
}

bool hiddenAt(const CameraParameters& camera, std::span<const GatherPixel> gather, const ProjectedPoint& point, float bias) {
  if (!(point.pixel.x >= 0.0f && point.pixel.y >= 0.0f)) return false;
  const auto x = static_cast<uint32_t>(point.pixel.x), y = static_cast<uint32_t>(point.pixel.y);
  if (x >= camera.width || y >= camera.height) return false;
  const GatherPixel& seen = gather[size_t(y) * camera.width + x];
  return seen.reference != kNoReference && point.depth > seen.depth + bias;
}

// Pixels between two looks at the gather buffer, and the most looks of one line.
constexpr float kLookPixels = 3.0f;
constexpr int kMostLooks = 200;

// How far beside the frame lines are kept, in frame sizes: enough for what is zoomed out, few enough for exact pixels.
constexpr float kBeside = 4.0f;

}  // namespace

std::optional<ProjectedPoint> projectPoint(const CameraParameters& camera, const vec3& world) {
  const vec3 view = viewSpace(camera, world);
  if (view.z < camera.nearPlane) return std::nullopt;
  return projectView(camera, view);
}

std::optional<WorldLine> clipToView(const CameraParameters& camera, WorldLine line) {
  const vec3 a = viewSpace(camera, line.a), b = viewSpace(camera, line.b);
  const float halfWidth = camera.tanHalfWidth * kBeside, halfHeight = camera.tanHalfHeight * kBeside;
  vec2 range(0.0f, 1.0f);
  const bool left = keepPositive(a.z - camera.nearPlane, b.z - camera.nearPlane, range) &&
                    keepPositive(a.z * halfWidth - a.x, b.z * halfWidth - b.x, range) &&
                    keepPositive(a.z * halfWidth + a.x, b.z * halfWidth + b.x, range) &&
                    keepPositive(a.z * halfHeight - a.y, b.z * halfHeight - b.y, range) &&
                    keepPositive(a.z * halfHeight + a.y, b.z * halfHeight + b.y, range);
  if (!left) return std::nullopt;
  return part(line, range);
}

std::optional<WorldLine> clipToBounds(const Bounds& bounds, WorldLine line) {
  vec2 range(0.0f, 1.0f);
  for (int axis = 0; axis < 3; ++axis) {
    if (!keepPositive(line.a[axis] - bounds.low[axis], line.b[axis] - bounds.low[axis], range)) return std::nullopt;
    if (!keepPositive(bounds.high[axis] - line.a[axis], bounds.high[axis] - line.b[axis], range)) return std::nullopt;
  }
  return part(line, range);
}

std::optional<ProjectedLine> projectWhole(const CameraParameters& camera, const WorldLine& line) {
  const std::optional<WorldLine> kept = clipToView(camera, line);
  if (!kept) return std::nullopt;
  return ProjectedLine{projectView(camera, viewSpace(camera, kept->a)), projectView(camera, viewSpace(camera, kept->b))};
}

std::vector<ProjectedLine> projectLine(const CameraParameters& camera, std::span<const GatherPixel> gather, const WorldLine& line,
                                       float bias) {
  std::vector<ProjectedLine> pieces;
  const std::optional<ProjectedLine> whole = projectWhole(camera, line);
  if (!whole) return pieces;
  if (gather.size() < size_t(camera.width) * camera.height) return {*whole};

  // Even steps on the picture; in between, one over the forward distance is linear.
  const WorldLine kept = *clipToView(camera, line);
  const vec3 a = viewSpace(camera, kept.a), b = viewSpace(camera, kept.b);
  const int looks = std::clamp(static_cast<int>(glm::length(whole->b.pixel - whole->a.pixel) / kLookPixels), 1, kMostLooks);
  ProjectedPoint last = whole->a;
  for (int look = 0; look < looks; ++look) {
    const float middle = (float(look) + 0.5f) / float(looks), end = float(look + 1) / float(looks);
    const auto at = [&](float share) {
      const float t = share * a.z / (b.z + (a.z - b.z) * share);
      return projectView(camera, a + (b - a) * t);
    };
    const bool hidden = hiddenAt(camera, gather, at(middle), bias);
    const ProjectedPoint next = look + 1 == looks ? whole->b : at(end);
    if (!pieces.empty() && pieces.back().hidden == hidden)
      pieces.back().b = next;
    else
      pieces.push_back({last, next, hidden});
    last = next;
  }
  return pieces;
}

std::array<WorldLine, 12> boxEdges(const Bounds& bounds) {
  std::array<WorldLine, 12> edges;
  size_t count = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 4; ++side) {
      vec3 low = bounds.low;
      const int second = (axis + 1) % 3, third = (axis + 2) % 3;
      if (side & 1) low[second] = bounds.high[second];
      if (side & 2) low[third] = bounds.high[third];
      vec3 high = low;
      high[axis] = bounds.high[axis];
      edges[count++] = {low, high};
    }
  return edges;
}

Bounds cellBounds(const GridParameters& grid, const ivec3& cell) {
  Bounds bounds;
  for (int axis = 0; axis < 3; ++axis) {
    bounds.low[axis] = gridFace(grid, axis, cell[axis]);
    bounds.high[axis] = gridFace(grid, axis, cell[axis] + 1);
  }
  return bounds;
}

bool inView(const CameraParameters& camera, const Bounds& bounds) {
  const vec3 centre = viewSpace(camera, 0.5f * (bounds.low + bounds.high));
  const float radius = 0.5f * glm::length(bounds.high - bounds.low);
  if (centre.z + radius < camera.nearPlane) return false;
  const float slackX = radius * std::sqrt(1.0f + camera.tanHalfWidth * camera.tanHalfWidth);
  const float slackY = radius * std::sqrt(1.0f + camera.tanHalfHeight * camera.tanHalfHeight);
  return std::abs(centre.x) <= centre.z * camera.tanHalfWidth + slackX && std::abs(centre.y) <= centre.z * camera.tanHalfHeight + slackY;
}

}  // namespace gridscope
