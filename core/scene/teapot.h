// The Utah teapot, and animated teapots for any scene, as in the paper's first figure.
#pragma once

#include "core/scene/scene.h"

namespace gridscope {

// 6,320 triangles.
inline constexpr uint32_t kTeapotSubdivisions = 10;

// From the tip of the spout to the end of the handle, in units of the mesh; it stands on y = 0 and is 3.15 high.
inline constexpr float kTeapotLength = 6.525f;

// The teapot with each of its 32 patches cut into subdivisions x subdivisions quads (at least 1); the spout points along +x.
Mesh makeTeapot(uint32_t subdivisions, uint32_t materialIndex);

// A teapot's place: it circles about `centre` and turns once each period while it bobs up and down.
struct TeapotPath {
  vec3 centre{0.0f};           // middle of the circle, at the height of the teapot's foot
  float length = 1.0f;         // of the teapot from spout to handle, metres
  float radius = 1.0f;         // of the circle
  float bob = 0.0f;            // highest deviation from the centre's height
  float periodSeconds = 8.0f;  // 0: at rest
  float startTurn = 0.0f;      // place on the circle at time 0, in turns
  vec4 baseColour{1.0f};
  float metallic = 0.0f;
};

// Adds one dynamic teapot with a material, a mesh, a node and, unless it is at rest, an animation of its own.
void addTeapot(Scene& scene, const TeapotPath& path);

// Adds `count` dynamic teapots in front of the scene's default camera, as large as the room suggests; the first movingCount
// of them move. They stay inside the scene's bounds.
void addTeapots(Scene& scene, uint32_t count, uint32_t movingCount);

}  // namespace gridscope
