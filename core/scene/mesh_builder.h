// Shapes for the scenes made in code: each function adds triangles to a mesh, with normals, texture coordinates and colours.
// Texture coordinates are metres along the surface unless a comment says otherwise. Triangles without area are left out.
#pragma once

#include <functional>
#include <span>

#include "core/scene/scene.h"

namespace gridscope {

inline constexpr float kPi = 3.14159265f;

struct MeshCorner {
  vec3 position{0.0f};
  vec3 normal{0.0f, 1.0f, 0.0f};
  vec2 uv{0.0f};
  vec4 colour{1.0f};
};

// A surface over the unit square; its normals come from differences of nearby points. A caller that turns the square
// inside out (swaps s and t) turns the normals around.
using Surface = std::function<vec3(float s, float t)>;

// How a surface is cut into cells and how far its texture coordinates run.
struct PatchShape {
  uint32_t columns = 1;  // along s
  uint32_t rows = 1;     // along t
  vec2 uvScale{1.0f};    // uv = (s, t) * uvScale
};

Mesh newMesh(std::string name, uint32_t materialIndex);

void addTriangle(Mesh& mesh, const MeshCorner& a, const MeshCorner& b, const MeshCorner& c);

// A flat quad from a corner and its two edges, seen from the side to which cross(edgeS, edgeT) points; cut into columns x rows.
void addQuad(Mesh& mesh, const vec3& corner, const vec3& edgeS, const vec3& edgeT, uint32_t columns = 1, uint32_t rows = 1);

// A quad as addQuad's, but with texture coordinates from (0, 0) to (1, 1).
void addPicture(Mesh& mesh, const vec3& corner, const vec3& edgeS, const vec3& edgeT);

// A curved surface, with smooth normals towards cross(d/ds, d/dt).
void addPatch(Mesh& mesh, const Surface& surface, const PatchShape& shape);

// All six sides, each cut into quads of about maxQuad metres (0: uncut).
void addBox(Mesh& mesh, const vec3& low, const vec3& high, float maxQuad = 0.0f);

// A profile of (radius, height) points, from the bottom up, turned about the vertical axis through foot. Between two equal
// neighbouring points the profile has a crease: the parts before and after are smooth on their own.
void addLathe(Mesh& mesh, const vec3& foot, std::span<const vec2> profile, uint32_t sides);

// A cylinder without caps.
void addCylinder(Mesh& mesh, const vec3& foot, float radius, float height, uint32_t sides);

void addSphere(Mesh& mesh, const vec3& centre, float radius, uint32_t sides, uint32_t rings);

// A ring of circular section about an axis through centre.
struct Ring {
  vec3 centre{0.0f};
  vec3 axis{0.0f, 1.0f, 0.0f};  // unit
  float radius = 1.0f;          // to the middle of the section
  float thickness = 0.1f;       // radius of the section
  uint32_t sides = 24;          // around the axis
  uint32_t sections = 8;        // around the section
};
void addRing(Mesh& mesh, const Ring& ring);

// A round bar along a curve over [0, 1], without caps.
struct Bar {
  std::function<vec3(float)> curve;
  float thickness = 0.1f;  // radius of the section
  uint32_t pieces = 8;     // along the curve
  uint32_t sections = 6;   // around it
};
void addBar(Mesh& mesh, const Bar& bar);

// Two unit vectors that make a right-handed frame with a unit axis: cross(first, second) = axis.
void makeFrame(const vec3& axis, vec3& first, vec3& second);

// Turns the triangles from corner `first` on so that winding and normals face a point: for walls, a point in the room.
void faceTowards(Mesh& mesh, size_t first, const vec3& point);

void scaleUvs(Mesh& mesh, float scale);

// Multiplies each corner's colour by what shade(position, normal) returns (baked light, stains, variation), up to 1.
void shadeMesh(Mesh& mesh, const std::function<vec3(const vec3& position, const vec3& normal)>& shade);

// Scatters integers; the same numbers on every machine.
uint32_t hashInteger(uint32_t value);

// A number in [0, 1) that depends on the three integers alone.
float hashUnit(uint32_t a, uint32_t b = 0, uint32_t c = 0);

// Smooth noise in [0, 1] with a period of `period` cells in x and y, so that textures repeat without a seam; x, y >= 0.
float tiledNoise(float x, float y, uint32_t period, uint32_t seed);

// Several octaves of tiledNoise over the unit square, in [0, 1]; the first has `period` cells.
float tiledClouds(float u, float v, uint32_t period, uint32_t seed);

}  // namespace gridscope
