// From the world to the frame's pixels, as the gather buffer was drawn: points, lines clipped at the near plane, boxes, and which parts of a
// line the surfaces hide. What is drawn over the viewport is made of it. No ImGui here.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "shaders/shared/trace/frame.h"

namespace gridscope {

struct ProjectedPoint {
  vec2 pixel{0.0f};    // of the frame; (0, 0) is the upper left corner of the first pixel
  float depth = 0.0f;  // distance from the eye, world units: what GatherPixel::depth holds
};

struct ProjectedLine {
  ProjectedPoint a, b;
  bool hidden = false;  // behind the surfaces that the gather buffer saw
};

// Nothing for a point before the near plane.
std::optional<ProjectedPoint> projectPoint(const CameraParameters& camera, const vec3& world);

// The part of a line behind the near plane and within a frame's width around the frame; nothing where there is none.
struct WorldLine {
  vec3 a{0.0f}, b{0.0f};
};
std::optional<WorldLine> clipToView(const CameraParameters& camera, WorldLine line);
std::optional<WorldLine> clipToBounds(const Bounds& bounds, WorldLine line);

// A line in pieces that are visible or hidden throughout, from a to b. `bias`: how far behind a surface still counts as visible, world units.
// An empty gather hides nothing.
std::vector<ProjectedLine> projectLine(const CameraParameters& camera, std::span<const GatherPixel> gather, const WorldLine& line,
                                       float bias);

// The same in one piece, without looking at the gather buffer.
std::optional<ProjectedLine> projectWhole(const CameraParameters& camera, const WorldLine& line);

// The 12 edges of a box: 4 along x, 4 along y, 4 along z.
std::array<WorldLine, 12> boxEdges(const Bounds& bounds);

Bounds cellBounds(const GridParameters& grid, const ivec3& cell);

// Is any of a box in what the camera sees? May say yes for some that lie just outside.
bool inView(const CameraParameters& camera, const Bounds& bounds);

}  // namespace gridscope
