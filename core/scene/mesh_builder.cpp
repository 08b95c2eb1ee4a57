#include "core/scene/mesh_builder.h"

#include <algorithm>
#include <cmath>

namespace gridscope {

namespace {

// Part of the unit square's side: small beside any bend of our surfaces, large beside rounding.
constexpr float kDifference = 1.0f / 512.0f;

vec3 differenceS(const Surface& surface, float s, float t) {
  return surface(std::min(s + kDifference, 1.0f), t) - surface(std::max(s - kDifference, 0.0f), t);
}

vec3 differenceT(const Surface& surface, float s, float t) {
  return surface(s, std::min(t + kDifference, 1.0f)) - surface(s, std::max(t - kDifference, 0.0f));
}

vec3 surfaceNormal(const Surface& surface, float s, float t) {
  vec3 normal = glm::cross(differenceS(surface, s, t), differenceT(surface, s, t));
  if (glm::dot(normal, normal) < 1e-24f) {
    // At a pole one of the two differences vanishes; a little inside the square both are there.
    const float inner = 0.002f;
    s = std::clamp(s, inner, 1.0f - inner), t = std::clamp(t, inner, 1.0f - inner);
    normal = glm::cross(differenceS(surface, s, t), differenceT(surface, s, t));
  }
  const float length = glm::length(normal);
  return length > 0.0f ? normal / length : vec3(0.0f, 1.0f, 0.0f);
}

void addCorner(Mesh& mesh, const MeshCorner& corner) {
  mesh.positions.push_back(corner.position);
  mesh.normals.push_back(corner.normal);
  mesh.uvs.push_back(corner.uv);
  mesh.colours.push_back(corner.colour);
}

// Two triangles for each cell of a lattice of (columns + 1) x (rows + 1) corners.
void addCells(Mesh& mesh, std::span<const MeshCorner> corners, uint32_t columns, uint32_t rows) {
  for (uint32_t row = 0; row < rows; ++row) {
    for (uint32_t column = 0; column < columns; ++column) {
      const MeshCorner* near = &corners[row * (columns + 1) + column];
      const MeshCorner* far = near + columns + 1;
      addTriangle(mesh, near[0], near[1], far[1]);
      addTriangle(mesh, near[0], far[1], far[0]);
    }
  }
}

uint32_t piecesOf(float length, float maxPiece) {
  return maxPiece > 0.0f ? std::max(1u, static_cast<uint32_t>(std::ceil(length / maxPiece))) : 1u;
}

}  // namespace

Mesh newMesh(std::string name, uint32_t materialIndex) {
  Mesh mesh;
  mesh.name = std::move(name);
  mesh.materialIndex = materialIndex;
  return mesh;
}

void addTriangle(Mesh& mesh, const MeshCorner& a, const MeshCorner& b, const MeshCorner& c) {
  const vec3 normal = glm::cross(b.position - a.position, c.position - a.position);
  // Slivers that rounding leaves at poles: far below a triangle of a tenth of a millimetre, above the build's own limit.
  if (glm::dot(normal, normal) < 1e-18f) return;
  addCorner(mesh, a), addCorner(mesh, b), addCorner(mesh, c);
}

void addQuad(Mesh& mesh, const vec3& corner, const vec3& edgeS, const vec3& edgeT, uint32_t columns, uint32_t rows) {
  const PatchShape shape{.columns = columns, .rows = rows, .uvScale = {glm::length(edgeS), glm::length(edgeT)}};
  addPatch(
      mesh, [&](float s, float t) { return corner + s * edgeS + t * edgeT; }, shape);
}

void addPicture(Mesh& mesh, const vec3& corner, const vec3& edgeS, const vec3& edgeT) {
  addPatch(mesh, [&](float s, float t) { return corner + s * edgeS + t * edgeT; }, {});
}

void addPatch(Mesh& mesh, const Surface& surface, const PatchShape& shape) {
  std::vector<MeshCorner> corners;
  corners.reserve((shape.columns + 1) * (shape.rows + 1));
  for (uint32_t row = 0; row <= shape.rows; ++row) {
    for (uint32_t column = 0; column <= shape.columns; ++column) {
      const float s = static_cast<float>(column) / static_cast<float>(shape.columns);
      const float t = static_cast<float>(row) / static_cast<float>(shape.rows);
      corners.push_back({.position = surface(s, t), .normal = surfaceNormal(surface, s, t), .uv = vec2(s, t) * shape.uvScale});
    }
  }
  addCells(mesh, corners, shape.columns, shape.rows);
}

void addBox(Mesh& mesh, const vec3& low, const vec3& high, float maxQuad) {
  const vec3 size = high - low;
  const vec3 x(size.x, 0.0f, 0.0f), y(0.0f, size.y, 0.0f), z(0.0f, 0.0f, size.z);
  const uint32_t nx = piecesOf(size.x, maxQuad), ny = piecesOf(size.y, maxQuad), nz = piecesOf(size.z, maxQuad);
  addQuad(mesh, vec3(low.x, low.y, high.z), x, y, nx, ny);
  addQuad(mesh, vec3(high.x, low.y, low.z), -x, y, nx, ny);
  addQuad(mesh, high - y, -z, y, nz, ny);
  addQuad(mesh, low, z, y, nz, ny);
  addQuad(mesh, vec3(low.x, high.y, high.z), x, -z, nx, nz);
  addQuad(mesh, low, x, z, nx, nz);
}

void addLathe(Mesh& mesh, const vec3& foot, std::span<const vec2> profile, uint32_t sides) {
  size_t begin = 0;
  while (begin + 1 < profile.size()) {
    // One smooth part: up to the next doubled point.
    size_t end = begin + 1;
    while (end + 1 < profile.size() && profile[end] != profile[end + 1]) ++end;
    const std::span<const vec2> part = profile.subspan(begin, end - begin + 1);

    const uint32_t rows = static_cast<uint32_t>(part.size() - 1);
    float widest = 0.0f;
    for (const vec2& point : part) widest = std::max(widest, point.x);
    const Surface surface = [&](float s, float t) {
      const float place = t * static_cast<float>(rows);
      const uint32_t row = std::min(static_cast<uint32_t>(place), rows - 1);
      const vec2 point = glm::mix(part[row], part[row + 1], place - static_cast<float>(row));
      const float angle = -2.0f * kPi * s;
      return foot + vec3(point.x * std::cos(angle), point.y, point.x * std::sin(angle));
    };
    const float height = std::abs(part.back().y - part.front().y) + std::abs(part.back().x - part.front().x);
    addPatch(mesh, surface, {.columns = sides, .rows = rows, .uvScale = {2.0f * kPi * widest, height}});
    begin = end + 1 < profile.size() ? end + 1 : profile.size();
  }
}

void addCylinder(Mesh& mesh, const vec3& foot, float radius, float height, uint32_t sides) {
  const vec2 profile[] = {{radius, 0.0f}, {radius, height}};
  addLathe(mesh, foot, profile, sides);
}

void addSphere(Mesh& mesh, const vec3& centre, float radius, uint32_t sides, uint32_t rings) {
  const Surface surface = [&](float s, float t) {
    const float around = -2.0f * kPi * s, up = kPi * (t - 0.5f);
    // Exactly zero at the poles, so that their triangles without area are recognised.
    const float width = t <= 0.0f || t >= 1.0f ? 0.0f : std::cos(up);
    return centre + radius * vec3(width * std::cos(around), std::sin(up), width * std::sin(around));
  };
  addPatch(mesh, surface, {.columns = sides, .rows = rings, .uvScale = {2.0f * kPi * radius, kPi * radius}});
}

void addRing(Mesh& mesh, const Ring& ring) {
  vec3 first, second;
  makeFrame(ring.axis, first, second);
  const Surface surface = [&](float s, float t) {
    const float around = 2.0f * kPi * s, section = 2.0f * kPi * t;
    const vec3 outward = std::cos(around) * first + std::sin(around) * second;
    return ring.centre + ring.radius * outward + ring.thickness * (std::cos(section) * outward + std::sin(section) * ring.axis);
  };
  addPatch(mesh, surface, {.columns = ring.sides, .rows = ring.sections, .uvScale = 2.0f * kPi * vec2(ring.radius, ring.thickness)});
}

void addBar(Mesh& mesh, const Bar& bar) {
  std::vector<vec3> points;
  for (uint32_t i = 0; i <= bar.pieces; ++i) points.push_back(bar.curve(static_cast<float>(i) / static_cast<float>(bar.pieces)));

  // Rings of corners; the frame is carried along the curve, so that the bar does not twist where its direction turns.
  std::vector<MeshCorner> corners;
  vec3 first, second;
  for (uint32_t i = 0; i <= bar.pieces; ++i) {
    const vec3 along = glm::normalize(points[std::min(i + 1, bar.pieces)] - points[i == 0 ? 0 : i - 1]);
    if (i == 0) makeFrame(along, first, second);
    first = glm::normalize(first - glm::dot(first, along) * along);
    second = glm::cross(along, first);
    for (uint32_t k = 0; k <= bar.sections; ++k) {
      const float share = static_cast<float>(k) / static_cast<float>(bar.sections);
      const vec3 outward = std::cos(2.0f * kPi * share) * first + std::sin(2.0f * kPi * share) * second;
      const vec2 uv(2.0f * kPi * bar.thickness * share, glm::length(points[i] - points[0]));
      corners.push_back({.position = points[i] + bar.thickness * outward, .normal = outward, .uv = uv});
    }
  }
  addCells(mesh, corners, bar.sections, bar.pieces);
}

void makeFrame(const vec3& axis, vec3& first, vec3& second) {
  // The helper is far from the axis, and is the same for all axes near the vertical or near the horizontal.
  const vec3 helper = std::abs(axis.y) < 0.8f ? vec3(0.0f, 1.0f, 0.0f) : vec3(1.0f, 0.0f, 0.0f);
  first = glm::normalize(glm::cross(helper, axis));
  second = glm::cross(axis, first);
}

void shadeMesh(Mesh& mesh, const std::function<vec3(const vec3& position, const vec3& normal)>& shade) {
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const vec4 shaded = mesh.colours[i] * vec4(shade(mesh.positions[i], mesh.normals[i]), 1.0f);
    mesh.colours[i] = glm::min(shaded, vec4(1.0f));
  }
}

void faceTowards(Mesh& mesh, size_t first, const vec3& point) {
  for (size_t i = first; i < mesh.positions.size(); i += 3) {
    const vec3& a = mesh.positions[i];
    const vec3 normal = glm::cross(mesh.positions[i + 1] - a, mesh.positions[i + 2] - a);
    if (glm::dot(normal, point - a) >= 0.0f) continue;
    std::swap(mesh.positions[i + 1], mesh.positions[i + 2]);
    std::swap(mesh.uvs[i + 1], mesh.uvs[i + 2]);
    std::swap(mesh.colours[i + 1], mesh.colours[i + 2]);
    std::swap(mesh.normals[i + 1], mesh.normals[i + 2]);
    for (size_t corner = i; corner < i + 3; ++corner) mesh.normals[corner] = -mesh.normals[corner];
  }
}

void scaleUvs(Mesh& mesh, float scale) {
  for (vec2& uv : mesh.uvs) uv *= scale;
}

uint32_t hashInteger(uint32_t value) {
  // Two rounds of multiply and shift; the constants are odd numbers with well spread bits, chosen by hand.
  value = (value ^ (value >> 16)) * 0x9E3779B1u;
  value = (value ^ (value >> 15)) * 0x85EBCA77u;
  return value ^ (value >> 16);
}

float hashUnit(uint32_t a, uint32_t b, uint32_t c) {
  // Odd factors, so that neighbours in a, b and c land far apart before the mixing.
  const uint32_t bits = hashInteger(a * 0x8DA6B343u + b * 0xD8163841u + (c + 1u) * 0xCB1AB31Fu);
  return static_cast<float>(bits >> 8) / 16777216.0f;
}

float tiledNoise(float x, float y, uint32_t period, uint32_t seed) {
  const uint32_t cellX = static_cast<uint32_t>(x), cellY = static_cast<uint32_t>(y);
  const uint32_t x0 = cellX % period, y0 = cellY % period;
  const uint32_t x1 = x0 + 1 == period ? 0 : x0 + 1, y1 = y0 + 1 == period ? 0 : y0 + 1;
  const vec2 part(x - static_cast<float>(cellX), y - static_cast<float>(cellY));
  const vec2 weight = part * part * (3.0f - 2.0f * part);
  return glm::mix(glm::mix(hashUnit(x0, y0, seed), hashUnit(x1, y0, seed), weight.x),
                  glm::mix(hashUnit(x0, y1, seed), hashUnit(x1, y1, seed), weight.x), weight.y);
}

float tiledClouds(float u, float v, uint32_t period, uint32_t seed) {
  float sum = 0.0f, weight = 0.5f, total = 0.0f;
  for (uint32_t octave = 0; octave < 4; ++octave) {
    sum += weight * tiledNoise(u * static_cast<float>(period), v * static_cast<float>(period), period, seed + octave);
    total += weight;
    weight *= 0.5f, period *= 2;
  }
  return sum / total;
}

}  // namespace gridscope
