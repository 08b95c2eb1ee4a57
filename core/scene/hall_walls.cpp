// The hall's walls with their openings, its floors and its glass.
#include <algorithm>
#include <cmath>

#include "core/scene/hall.h"

namespace gridscope::hall {

namespace {

// Baked light lives in corners, so large faces are cut into quads of about this size.
constexpr float kPiece = 0.5f;

constexpr float kTextureMetres = 2.4f;  // side of the stone textures

uint32_t pieces(float length, float piece = kPiece) { return std::max(1u, static_cast<uint32_t>(std::lround(length / piece))); }

// A stretch of wall with one opening, seen as (u, y): u runs from 0 to `length` along `along` from `origin`, y upwards.
// `inward` points into the room; the wall is `thickness` deep behind its inner face, which holds the origin.
struct WallBay {
  vec3 origin{0.0f};
  vec3 along{1.0f, 0.0f, 0.0f};
  vec3 inward{0.0f, 0.0f, 1.0f};
  float length = kBay;
  float bottom = 0.0f;
  float top = 1.0f;
  float thickness = 0.8f;
  Opening opening;
  uint32_t archPieces = 16;
  float outerPiece = kPiece;  // size of the quads of the outer face; coarse where only the sky sees it

  vec3 at(float u, float y, float depth) const { return origin + u * along + vec3(0.0f, y, 0.0f) - depth * inward; }
};

// One face of the wall between two lines of u, from a lower to an upper edge.
template <typename Lower>
void addStrip(Mesh& mesh, const WallBay& wall, vec2 range, const Lower& lower, float upper, float depth) {
  if (range.y - range.x < 1e-4f) return;
  const float height = upper - lower(range.x);
  if (height < 1e-4f) return;
  const float piece = depth > 0.0f ? wall.outerPiece : kPiece;
  const size_t first = mesh.positions.size();
  const Surface surface = [&](float s, float t) {
    const float u = glm::mix(range.x, range.y, s), low = lower(u);
    return wall.at(u, low + t * (upper - low), depth);
  };
  addPatch(mesh, surface, {.columns = pieces(range.y - range.x, piece), .rows = pieces(height, piece)});
  // Stones keep their size along a curved edge: texture coordinates from the place, not from (s, t).
  for (size_t i = first; i < mesh.positions.size(); ++i) {
    const vec3 offset = mesh.positions[i] - wall.origin;
    mesh.uvs[i] = vec2(glm::dot(offset, wall.along) + wall.origin.x + wall.origin.z, mesh.positions[i].y);
  }
  const float side = depth > 0.0f ? -1.0f : 1.0f;
  faceTowards(mesh, first, wall.at(0.5f * wall.length, 0.5f * (wall.bottom + wall.top), depth) + 100.0f * side * wall.inward);
}

// u across the opening for s in [0, 1]; dense near the springings, where the arch is steep.
float acrossOpening(const Opening& opening, float s) { return opening.middle - opening.halfWidth * std::cos(kPi * s); }

void addFace(Mesh& mesh, const WallBay& wall, float depth) {
  const Opening& opening = wall.opening;
  const float left = opening.middle - opening.halfWidth, right = opening.middle + opening.halfWidth;
  const auto bottom = [&](float) { return wall.bottom; };
  const auto sill = [&](float) { return std::max(wall.bottom, opening.bottom); };
  addStrip(mesh, wall, {0.0f, wall.length}, bottom, opening.bottom, depth);
  addStrip(mesh, wall, {0.0f, left}, sill, wall.top, depth);
  addStrip(mesh, wall, {right, wall.length}, sill, wall.top, depth);

  const size_t first = mesh.positions.size();
  const Surface above = [&](float s, float t) {
    const float u = acrossOpening(opening, s);
    return wall.at(u, glm::mix(opening.top(u), wall.top, t), depth);
  };
  addPatch(mesh, above, {.columns = wall.archPieces, .rows = pieces(wall.top - opening.spring, depth > 0.0f ? wall.outerPiece : kPiece)});
  for (size_t i = first; i < mesh.positions.size(); ++i) {
    mesh.uvs[i] = vec2(glm::dot(mesh.positions[i] - wall.origin, wall.along) + wall.origin.x + wall.origin.z, mesh.positions[i].y);
  }
  const float side = depth > 0.0f ? -1.0f : 1.0f;
  faceTowards(mesh, first, wall.at(opening.middle, opening.spring, depth) + 100.0f * side * wall.inward);
}

// The inside of the opening: arch, jambs and sill.
void addReveal(Mesh& mesh, const WallBay& wall) {
  const Opening& opening = wall.opening;
  const size_t first = mesh.positions.size();
  const Surface arch = [&](float s, float t) {
    const float u = acrossOpening(opening, s);
    return wall.at(u, opening.top(u), t * wall.thickness);
  };
  addPatch(mesh, arch, {.columns = wall.archPieces, .rows = 1, .uvScale = {4.0f * opening.halfWidth, wall.thickness}});

  const float jamb = opening.spring - opening.bottom;
  if (jamb > 0.01f) {
    for (const float u : {opening.middle - opening.halfWidth, opening.middle + opening.halfWidth}) {
      addQuad(mesh, wall.at(u, opening.bottom, 0.0f), -wall.thickness * wall.inward, vec3(0.0f, jamb, 0.0f), 2, pieces(jamb));
    }
    addQuad(mesh, wall.at(opening.middle - opening.halfWidth, opening.bottom, 0.0f), 2.0f * opening.halfWidth * wall.along,
            -wall.thickness * wall.inward, 4, 2);
  }
  faceTowards(mesh, first, wall.at(opening.middle, 0.5f * (opening.bottom + opening.spring) + 0.2f, 0.5f * wall.thickness));
}

void addWallBay(Mesh& mesh, const WallBay& wall) {
  addFace(mesh, wall, 0.0f);
  addFace(mesh, wall, wall.thickness);
  addReveal(mesh, wall);
}

// A moulding round the edge of an opening, and down its jambs.
void addMoulding(Mesh& mesh, const WallBay& wall, float thickness) {
  const Opening& opening = wall.opening;
  const auto curve = [&](float s) {
    const float u = acrossOpening({.middle = opening.middle, .halfWidth = opening.halfWidth + 0.04f}, s);
    const float inner = acrossOpening(opening, s);
    return wall.at(u, opening.top(inner) + 0.04f, -0.3f * thickness);
  };
  addBar(mesh, {.curve = curve, .thickness = thickness, .pieces = wall.archPieces, .sections = 6});
}

// A pane that fills an opening, with texture coordinates that make squares.
void addPane(Mesh& mesh, const WallBay& wall, float textureMetres) {
  const Opening& opening = wall.opening;
  const size_t first = mesh.positions.size();
  const Surface surface = [&](float s, float t) {
    const float u = acrossOpening(opening, s);
    return wall.at(u, glm::mix(opening.bottom, opening.top(u), t), 0.6f * wall.thickness);
  };
  addPatch(mesh, surface, {.columns = wall.archPieces, .rows = 1});
  for (size_t i = first; i < mesh.positions.size(); ++i) {
    mesh.uvs[i] = vec2(glm::dot(mesh.positions[i] - wall.origin, wall.along), mesh.positions[i].y) / textureMetres;
  }
  faceTowards(mesh, first, wall.at(opening.middle, opening.spring, -100.0f));
}

// A mullion with two small arches and a ring above: the stone tracery of a window without glass.
void addTracery(Mesh& mesh, const WallBay& wall) {
  const Opening& opening = wall.opening;
  const float depth = 0.5f * wall.thickness, thickness = 0.045f, head = opening.spring - 0.1f;
  const auto post = [&](float s) { return wall.at(opening.middle, glm::mix(opening.bottom, head, s), depth); };
  addBar(mesh, {.curve = post, .thickness = thickness, .pieces = 3, .sections = 6});
  for (const float side : {-1.0f, 1.0f}) {
    const Opening light{.middle = opening.middle + 0.5f * side * opening.halfWidth,
                        .halfWidth = 0.5f * opening.halfWidth,
                        .bottom = opening.bottom,
                        .spring = head,
                        .rise = 0.55f};
    const auto arch = [&](float s) {
      const float u = acrossOpening(light, s);
      return wall.at(u, light.top(u), depth);
    };
    addBar(mesh, {.curve = arch, .thickness = thickness, .pieces = 10, .sections = 5});
  }
  addRing(mesh, {.centre = wall.at(opening.middle, opening.spring + 0.68f, depth),
                 .axis = wall.inward,
                 .radius = 0.3f,
                 .thickness = thickness,
                 .sides = 20,
                 .sections = 5});
}

// The bay's arcade wall, clerestory or outer wall; side -1 or +1 says on which side of the nave.
WallBay arcadeBay(uint32_t bay, float side) {
  return {.origin = {side * (kNave - kArcadeHalf), 0.0f, bayStart(bay)},
          .along = {0.0f, 0.0f, -1.0f},
          .inward = {-side, 0.0f, 0.0f},
          .bottom = kCapital,
          .top = kString,
          .thickness = 2.0f * kArcadeHalf,
          .opening = kArcadeArch,
          .archPieces = 20};
}

WallBay clerestoryBay(uint32_t bay, float side) {
  WallBay wall = arcadeBay(bay, side);
  wall.bottom = kString, wall.top = kSpring + kVaultRise, wall.opening = kClerestory, wall.archPieces = 14, wall.outerPiece = 4.0f;
  return wall;
}

WallBay outerBay(uint32_t bay, float side) {
  WallBay wall = arcadeBay(bay, side);
  wall.origin.x = side * kOuter;
  wall.bottom = 0.0f, wall.top = kCapital + kAisleRise + 0.1f, wall.thickness = kOuterThickness;
  wall.opening = kAisleWindow, wall.archPieces = 14, wall.outerPiece = 4.0f;
  return wall;
}

template <typename Visit>
void forEachBay(const Visit& visit) {
  for (uint32_t bay = 0; bay < kBays; ++bay) {
    for (const float side : {-1.0f, 1.0f}) visit(bay, side);
  }
}

// Three tall windows below the rose, in a wall of a third of the nave's width each.
WallBay lancetBay(uint32_t index) {
  constexpr float kLength = 2.0f * kNave / 3.0f;
  return {.origin = {-kNave + kLength * static_cast<float>(index), 0.0f, -kEnd},
          .along = {1.0f, 0.0f, 0.0f},
          .inward = {0.0f, 0.0f, 1.0f},
          .length = kLength,
          .bottom = 0.0f,
          .top = 6.6f,
          .thickness = 0.5f,
          .opening = {.middle = 0.5f * kLength, .halfWidth = 0.7f, .bottom = 1.9f, .spring = index == 1 ? 4.7f : 4.3f, .rise = 1.3f}};
}

// The wall about the rose: from its circle to the rectangle above the lancets. The way round the rectangle goes from corner to
// corner in whole steps, so that no corner is cut off.
void addRoseWall(Mesh& mesh) {
  constexpr uint32_t kSide = 20;  // steps a side
  const vec2 low(-kNave, 6.6f), high(kNave, kSpring + kVaultRise), middle(0.0f, kRoseY);
  const vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}, low};
  const Surface surface = [&](float s, float t) {
    const float place = 4.0f * s;
    const uint32_t side = std::min(static_cast<uint32_t>(place), 3u);
    const vec2 outer = glm::mix(corners[side], corners[side + 1], place - static_cast<float>(side));
    const vec2 inner = middle + kRoseRadius * glm::normalize(outer - middle);
    return vec3(glm::mix(inner, outer, t), -kEnd);
  };
  const size_t first = mesh.positions.size();
  addPatch(mesh, surface, {.columns = 4 * kSide, .rows = 5});
  for (size_t i = first; i < mesh.positions.size(); ++i) mesh.uvs[i] = vec2(mesh.positions[i].x, mesh.positions[i].y);
  faceTowards(mesh, first, vec3(0.0f, kRoseY, 100.0f));
}

// Rings, spokes and petals in front of the rose's glass.
void addRoseTracery(Mesh& mesh) {
  const vec3 middle(0.0f, kRoseY, -kEnd), axis(0.0f, 0.0f, 1.0f);
  addRing(mesh, {.centre = middle, .axis = axis, .radius = kRoseRadius, .thickness = 0.17f, .sides = 72, .sections = 10});
  addRing(mesh, {.centre = middle, .axis = axis, .radius = 0.42f * kRoseRadius, .thickness = 0.07f, .sides = 48, .sections = 8});
  addRing(mesh, {.centre = middle, .axis = axis, .radius = 0.15f * kRoseRadius, .thickness = 0.06f, .sides = 32, .sections = 8});
  constexpr uint32_t kSpokes = 12;
  for (uint32_t i = 0; i < kSpokes; ++i) {
    const float angle = 2.0f * kPi * static_cast<float>(i) / kSpokes, between = angle + kPi / kSpokes;
    const vec3 direction(std::cos(angle), std::sin(angle), 0.0f), half(std::cos(between), std::sin(between), 0.0f);
    const auto spoke = [&](float s) { return middle + kRoseRadius * glm::mix(0.15f, 0.78f, s) * direction; };
    addBar(mesh, {.curve = spoke, .thickness = 0.045f, .pieces = 4, .sections = 6});
    addRing(mesh, {.centre = middle + 0.8f * kRoseRadius * half,
                   .axis = axis,
                   .radius = 0.19f * kRoseRadius,
                   .thickness = 0.05f,
                   .sides = 24,
                   .sections = 5});
  }
}

void addDoor(Scene& scene) {
  Mesh door = newMesh("door", kWood);
  for (const float side : {-1.0f, 1.0f}) {
    addBox(door, {side * 0.75f - 0.73f, 0.0f, kEnd - 0.12f}, {side * 0.75f + 0.73f, 3.2f, kEnd}, 0.5f);
    for (uint32_t row = 0; row < 4; ++row) {
      const float y = 0.25f + 0.75f * static_cast<float>(row);
      addBox(door, {side * 0.75f - 0.55f, y, kEnd - 0.18f}, {side * 0.75f + 0.55f, y + 0.55f, kEnd - 0.12f});
    }
  }
  scaleUvs(door, 0.8f);
  addPart(scene, std::move(door));
}

}  // namespace

float Opening::top(float u) const { return spring + rise * pointedArch(std::abs(u - middle) / halfWidth); }

float pointedArch(float distance) {
  const float from = 1.0f + std::min(distance, 1.0f);
  return std::sqrt(std::max(0.0f, 4.0f - from * from) / 3.0f);
}

void addFloors(Scene& scene) {
  // Sunbeams on the floor have edges of a quarter of a metre; in the aisles they are few.
  constexpr float kInlayHalf = 1.2f, kAisleStart = kNave - 0.5f, kCut = 0.25f, kAisleCut = 0.35f;
  const auto addField = [&](Mesh& mesh, float lowX, float highX) {
    const float cut = std::min(std::abs(lowX), std::abs(highX)) >= kAisleStart ? kAisleCut : kCut;
    const uint32_t columns = static_cast<uint32_t>(std::lround((highX - lowX) / cut)), rows = static_cast<uint32_t>(2.0f * kEnd / cut);
    addQuad(mesh, {lowX, 0.0f, kEnd}, {highX - lowX, 0.0f, 0.0f}, {0.0f, 0.0f, -2.0f * kEnd}, columns, rows);
  };
  Mesh tiles = newMesh("floor tiles", kTiles), inlay = newMesh("floor inlay", kInlay), flags = newMesh("aisle floors", kFlags);
  addField(tiles, -kAisleStart, -kInlayHalf), addField(tiles, kInlayHalf, kAisleStart);
  addField(inlay, -kInlayHalf, kInlayHalf);
  addField(flags, -kOuter, -kAisleStart), addField(flags, kAisleStart, kOuter);
  // Tiles of half a yard, 0.46 m: five to the field's width of 2.3 m.
  scaleUvs(tiles, 1.25f / 2.3f);
  scaleUvs(inlay, 1.0f / (2.0f * kInlayHalf));
  scaleUvs(flags, 1.0f / 2.4f);
  addPart(scene, std::move(tiles)), addPart(scene, std::move(inlay)), addPart(scene, std::move(flags));
}

void addArcades(Scene& scene) {
  Mesh arcade = newMesh("arcade", kStone), clerestory = newMesh("clerestory", kStone), mouldings = newMesh("mouldings", kCarved);
  Mesh tracery = newMesh("clerestory tracery", kCarved);
  forEachBay([&](uint32_t bay, float side) {
    addWallBay(arcade, arcadeBay(bay, side));
    addMoulding(mouldings, arcadeBay(bay, side), 0.11f);
    addWallBay(clerestory, clerestoryBay(bay, side));
    addMoulding(mouldings, clerestoryBay(bay, side), 0.07f);
    addTracery(tracery, clerestoryBay(bay, side));
  });
  for (const float side : {-1.0f, 1.0f}) {
    // The string course: three steps along the nave.
    for (uint32_t step = 0; step < 3; ++step) {
      const float out = kNave - kArcadeHalf - 0.05f * static_cast<float>(step + 1), y = kString + 0.09f * static_cast<float>(step);
      const vec3 low(std::min(side * out, side * kNave), y, -kEnd), high(std::max(side * out, side * kNave), y + 0.09f, kEnd);
      addBox(mouldings, low, high, 1.5f);
    }
  }
  for (Mesh* mesh : {&arcade, &clerestory, &mouldings, &tracery}) {
    scaleUvs(*mesh, 1.0f / kTextureMetres);
    addPart(scene, std::move(*mesh));
  }
}

void addOuterWalls(Scene& scene) {
  Mesh walls = newMesh("outer walls", kStone), mouldings = newMesh("window mouldings", kCarved);
  forEachBay([&](uint32_t bay, float side) {
    addWallBay(walls, outerBay(bay, side));
    addMoulding(mouldings, outerBay(bay, side), 0.08f);
  });
  scaleUvs(walls, 1.0f / kTextureMetres), scaleUvs(mouldings, 1.0f / kTextureMetres);
  addPart(scene, std::move(walls)), addPart(scene, std::move(mouldings));
}

void addEndWalls(Scene& scene) {
  Mesh walls = newMesh("end walls", kStone), tracery = newMesh("rose tracery", kCarved);
  for (uint32_t index = 0; index < 3; ++index) {
    addWallBay(walls, lancetBay(index));
    addMoulding(tracery, lancetBay(index), 0.08f);
  }
  addRoseWall(walls);
  addRoseTracery(tracery);

  // The wall with the door, and the ends of the aisles.
  const float aisle = kOuter - kNave, aisleTop = kCapital + kAisleRise;
  addQuad(walls, {kNave, 0.0f, kEnd}, {-2.0f * kNave, 0.0f, 0.0f}, {0.0f, kSpring + kVaultRise, 0.0f}, 16, 28);
  for (const float side : {-1.0f, 1.0f}) {
    for (const float end : {-1.0f, 1.0f}) {
      const size_t first = walls.positions.size();
      addQuad(walls, {side * kNave, 0.0f, end * kEnd}, {side * aisle, 0.0f, 0.0f}, {0.0f, aisleTop, 0.0f}, 8, 13);
      faceTowards(walls, first, {side * kNave, 0.0f, 0.0f});
    }
  }
  scaleUvs(walls, 1.0f / kTextureMetres), scaleUvs(tracery, 1.0f / kTextureMetres);
  addPart(scene, std::move(walls)), addPart(scene, std::move(tracery));
  addDoor(scene);
}

void addGlass(Scene& scene) {
  Mesh stained = newMesh("stained glass", kStainedGlass), pale = newMesh("aisle glass", kPaleGlass);
  for (uint32_t index = 0; index < 3; ++index) addPane(stained, lancetBay(index), 1.4f);
  const Surface rose = [](float s, float t) {
    const float angle = 2.0f * kPi * s, radius = t * kRoseRadius;
    return vec3(radius * std::cos(angle), kRoseY + radius * std::sin(angle), -kEnd - 0.12f);
  };
  const size_t first = stained.positions.size();
  addPatch(stained, rose, {.columns = 48, .rows = 1});
  for (size_t i = first; i < stained.positions.size(); ++i) stained.uvs[i] = vec2(stained.positions[i].x, stained.positions[i].y) / 2.4f;
  faceTowards(stained, first, vec3(0.0f, kRoseY, 0.0f));
  forEachBay([&](uint32_t bay, float side) { addPane(pale, outerBay(bay, side), 1.2f); });
  addPart(scene, std::move(stained)), addPart(scene, std::move(pale));
}

}  // namespace gridscope::hall
