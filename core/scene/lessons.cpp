// The lessons: small scenes that each show one behaviour of a fixed-capacity grid in the reflection of a floor. The gather
// buffer sees the things themselves, exactly; the one glossy bounce per pixel sees them through the grid. So every lesson
// stands in the same studio, a mirror-like floor before a plain wall, and what the grid does wrong is seen in the mirror,
// right below what it should be.
#include <array>
#include <cmath>
#include <string>

#include "core/scene/built_in_scenes.h"
#include "core/scene/mesh_builder.h"

namespace gridscope {

namespace {

// Cell edge of the lessons whose geometry must know where the cell faces are: a grid over bounds whose low corner is a
// multiple of it has its faces at multiples too.
constexpr float kLessonEdge = 0.25f;

const vec3 kRed(0.70f, 0.10f, 0.06f), kBlue(0.05f, 0.23f, 0.55f), kYellow(0.90f, 0.55f, 0.07f), kGreen(0.10f, 0.42f, 0.16f),
    kGrey(0.55f, 0.55f, 0.55f);

uint32_t addMaterial(Scene& scene, std::string name, const vec3& colour, float roughness = 0.6f, float metallic = 0.0f) {
  scene.materials.push_back(
      {.name = std::move(name), .baseColour = vec4(colour, 1.0f), .metallic = metallic, .roughness = roughness, .doubleSided = true});
  return static_cast<uint32_t>(scene.materials.size() - 1);
}

uint32_t addNode(Scene& scene, Node node) {
  scene.nodes.push_back(std::move(node));
  return static_cast<uint32_t>(scene.nodes.size() - 1);
}

// Places a mesh where it was made; returns the mesh's index.
uint32_t addStill(Scene& scene, Mesh mesh) {
  const uint32_t node = addNode(scene, {.name = mesh.name});
  const uint32_t index = static_cast<uint32_t>(scene.meshes.size());
  scene.instances.push_back({.name = mesh.name, .node = node, .mesh = index});
  scene.meshes.push_back(std::move(mesh));
  return index;
}

// A floor from low to high at y = 0 and a wall at its far side (low z), `height` high. The wall is one quad, so that both its
// triangles are in every cell along it and rays find it however they step; between smaller ones there would be holes.
struct Studio {
  vec2 low{-2.0f, -2.0f};  // x, z
  vec2 high{2.0f, 2.0f};
  float height = 2.0f;
  uint32_t pieces = 8;  // of the floor, along x and z
  vec3 wall{0.62f, 0.64f, 0.68f};
};

void addStudio(Scene& scene, const Studio& studio) {
  const vec3 x(studio.high.x - studio.low.x, 0.0f, 0.0f), y(0.0f, studio.height, 0.0f), z(0.0f, 0.0f, studio.high.y - studio.low.y);
  Mesh floor = newMesh("floor", addMaterial(scene, "mirror floor", vec3(0.55f, 0.57f, 0.60f), 0.02f, 0.9f));
  addQuad(floor, vec3(studio.low.x, 0.0f, studio.high.y), x, -z, studio.pieces, studio.pieces);
  addStill(scene, std::move(floor));

  // The wall grows darker upwards, so that its reflection shows where in the wall a ray arrived.
  Mesh wall = newMesh("wall", addMaterial(scene, "wall", studio.wall));
  addQuad(wall, vec3(studio.low.x, 0.0f, studio.low.y), x, y);
  shadeMesh(wall, [&](const vec3& position, const vec3&) { return vec3(1.0f - 0.55f * position.y / studio.height); });
  addStill(scene, std::move(wall));
}

Scene newScene(std::string name, const Studio& studio, const CameraPose& camera) {
  Scene scene;
  scene.name = std::move(name);
  addStudio(scene, studio);
  scene.cameras.push_back(camera);
  return scene;
}

// An upright strip: `foot` is the middle of its lower edge, `across` half of that edge.
void addBlade(Mesh& mesh, const vec3& foot, const vec3& across, float height) {
  addQuad(mesh, foot - across, 2.0f * across, vec3(0.0f, height, 0.0f));
}

}  // namespace

// A long floor with little on it: a ray that leaves the floor at a low angle crosses up to a hundred cells before it meets
// the wall, and reads one blank slot in each. `visits` grows with the distance, `tests` stays near zero.
Scene makeEmptyWalk() {
  Scene scene = newScene("empty-walk", {.low = {-6.0f, -18.0f}, .high = {6.0f, 6.0f}, .height = 6.0f},
                         {.name = "along the floor", .eye = {0.0f, 1.3f, 5.8f}, .target = {0.0f, 0.7f, -6.0f}, .verticalFovDegrees = 40});
  Mesh markers = newMesh("markers", addMaterial(scene, "marker", kRed));
  for (uint32_t i = 0; i < 3; ++i) {
    const float x = 2.4f * (static_cast<float>(i) - 1.0f), z = -15.0f + 5.0f * static_cast<float>(i);
    addBox(markers, {x - 0.3f, 0.0f, z - 0.3f}, {x + 0.3f, 2.4f, z + 0.3f});
  }
  addStill(scene, std::move(markers));
  scene.cameras.push_back({.name = "from the side", .eye = {2.7f, 1.4f, 2.0f}, .target = {-1.5f, 0.4f, -6.0f}});
  return scene;
}

// Six hundred blades of grass grow inside one cell of 0.25 m with 16 slots, on a pedestal, and a red panel passes through the
// same cell. `sorted` insertion keeps the smallest references: the first sixteen blades. The later blades and the panel,
// numbered last, are refused there. In the mirror the panel lacks a square: rays that meet none of the stored blades in it
// end with a voxel hit, or without gap-filling show what is behind. The pedestal lifts the cell above the gate of 1.75 edges,
// below which gap-filling is held back. The blue panel stands free and loses nothing.
Scene makeSaturatedCell() {
  Scene scene = newScene("saturated-cell", {.low = {-2.0f, -1.0f}, .high = {2.0f, 2.0f}, .height = 1.75f},
                         {.name = "tuft", .eye = {0.55f, 0.95f, 1.95f}, .target = {0.15f, 0.12f, 0.0f}, .verticalFovDegrees = 48.0f});
  Mesh pedestal = newMesh("pedestal", addMaterial(scene, "pedestal", vec3(0.45f, 0.40f, 0.34f)));
  addBox(pedestal, {-0.24f, 0.0f, 0.01f}, {-0.01f, 0.49f, 0.24f});
  addStill(scene, std::move(pedestal));

  Mesh tuft = newMesh("tuft", addMaterial(scene, "grass", vec3(0.20f, 0.58f, 0.08f), 0.7f));
  for (uint32_t i = 0; i < 600; ++i) {
    // The cell is [-0.25, 0] x [0.5, 0.75] x [0, 0.25]; no blade leaves it.
    const vec3 foot(-0.23f + 0.21f * hashUnit(i, 1), 0.502f, 0.02f + 0.21f * hashUnit(i, 2));
    const vec3 tip(-0.24f + 0.23f * hashUnit(i, 3), 0.62f + 0.12f * hashUnit(i, 4), 0.01f + 0.23f * hashUnit(i, 5));
    const float angle = 2.0f * kPi * hashUnit(i, 6);
    const vec3 across = 0.008f * vec3(std::cos(angle), 0.0f, std::sin(angle));
    const vec3 normal = glm::normalize(glm::cross(across, tip - foot));
    const vec4 dark(0.3f, 0.35f, 0.25f, 1.0f), bright(vec3(0.6f + 0.4f * hashUnit(i, 7)), 1.0f);
    addTriangle(tuft, {foot - across, normal, {0.0f, 0.0f}, dark}, {foot + across, normal, {1.0f, 0.0f}, dark},
                {tip, normal, {0.5f, 1.0f}, bright});
  }
  addStill(scene, std::move(tuft));

  Mesh panel = newMesh("panel", addMaterial(scene, "panel", kRed));
  addQuad(panel, {-0.55f, 0.51f, 0.11f}, {0.9f, 0.0f, 0.0f}, {0.0f, 0.4f, 0.0f});
  addStill(scene, std::move(panel));
  Mesh free = newMesh("free panel", addMaterial(scene, "free panel", kBlue));
  addQuad(free, {0.5f, 0.51f, 0.11f}, {0.35f, 0.0f, 0.0f}, {0.0f, 0.4f, 0.0f});
  addStill(scene, std::move(free));
  scene.cameras.push_back({.name = "close", .eye = {0.1f, 0.95f, 1.3f}, .target = {-0.1f, 0.05f, 0.1f}, .verticalFovDegrees = 60.0f});
  return scene;
}

namespace {

// A pointed leaf with lobes and a stalk; alpha is 255 inside, 0 outside.
Image makeLeafImage() {
  constexpr uint32_t kSize = 128;
  Image image{.name = "leaf", .width = kSize, .height = kSize, .rgba = std::vector<uint8_t>(kSize * kSize * 4)};
  for (uint32_t y = 0; y < kSize; ++y) {
    for (uint32_t x = 0; x < kSize; ++x) {
      const float across = (static_cast<float>(x) + 0.5f) / kSize * 2.0f - 1.0f;
      const float up = (static_cast<float>(y) + 0.5f) / kSize;
      // Half the width rises quickly from the stalk and runs out in a point; five lobes are cut into it.
      const float body = std::max(0.0f, (up - 0.12f) / 0.88f);
      const float outline = 2.6f * std::sqrt(body) * (1.0f - body) * (0.78f + 0.22f * std::cos(10.0f * kPi * body));
      const bool stalk = up <= 0.2f && std::abs(across) < 0.03f;
      const bool hole = glm::length(vec2(across - 0.3f, up - 0.45f) * vec2(1.0f, 2.0f)) < 0.16f;
      const bool inside = stalk || (std::abs(across) < outline && !hole);
      const bool vein = std::abs(across) < 0.025f || std::fmod(up * 7.0f + 100.0f - 2.0f * std::abs(across), 1.0f) < 0.08f;
      uint8_t* pixel = &image.rgba[4 * (y * kSize + x)];
      pixel[0] = vein ? 150 : 84, pixel[1] = vein ? 188 : 142, pixel[2] = vein ? 96 : 46;
      pixel[3] = inside ? 255 : 0;
    }
  }
  return image;
}

}  // namespace

// Two large leaves, each a quad of two triangles, stand before a striped ball and a box. The grid holds whole quads; only the
// byte of the alpha map at a hit says whether there is leaf. In the mirror the ball must show through the leaf's holes and
// beside its outline: a trace that forgets to turn a hit down shows rectangles.
Scene makeAlphaLeaf() {
  Scene scene = newScene("alpha-leaf", {.low = {-2.0f, -1.5f}, .high = {2.0f, 2.0f}, .height = 1.8f},
                         {.name = "leaves", .eye = {0.25f, 0.85f, 2.4f}, .target = {0.0f, 0.28f, 0.0f}, .verticalFovDegrees = 42.0f});
  Mesh ball = newMesh("ball", addMaterial(scene, "ball", vec3(1.0f), 0.4f));
  addSphere(ball, {-0.42f, 0.4f, -0.3f}, 0.4f, 24, 12);
  shadeMesh(ball, [](const vec3& position, const vec3&) { return std::fmod(position.y * 6.0f, 1.0f) < 0.5f ? kRed : vec3(0.85f); });
  addStill(scene, std::move(ball));
  Mesh box = newMesh("box", addMaterial(scene, "box", kBlue));
  addBox(box, {0.3f, 0.0f, -0.6f}, {1.0f, 0.7f, -0.1f});
  addStill(scene, std::move(box));

  scene.images.push_back(makeLeafImage());
  scene.materials.push_back({.name = "leaf",
                             .roughness = 0.6f,
                             .imageIndex = 0,
                             .wrapU = WrapMode::clamp,
                             .wrapV = WrapMode::clamp,
                             .alphaMode = AlphaMode::mask,
                             .doubleSided = true});
  const uint32_t leafMaterial = static_cast<uint32_t>(scene.materials.size() - 1);
  Mesh left = newMesh("left leaf", leafMaterial), right = newMesh("right leaf", leafMaterial);
  addPicture(left, {-0.85f, 0.0f, 0.35f}, {0.8f, 0.0f, 0.1f}, {0.0f, 0.85f, -0.15f});
  addPicture(right, {0.2f, 0.0f, 0.5f}, {0.8f, 0.0f, -0.15f}, {0.05f, 0.85f, -0.1f});
  addStill(scene, std::move(left)), addStill(scene, std::move(right));
  scene.cameras.push_back({.name = "close", .eye = {-0.3f, 0.45f, 1.5f}, .target = {-0.4f, 0.15f, 0.0f}, .verticalFovDegrees = 45.0f});
  return scene;
}

namespace {

// The two lessons about stepping look along the diagonal of the cells: direction (1, 0, -1). Within a cell [0, 1] x [0, 1]
// (x, z in edges) such a ray stays for sqrt(2) * c edges when it enters at (0, c): next to nothing near the corner (0, 0),
// sqrt(2) through the corner (0, 1), where it enters, to the corner (1, 0), where it leaves.
const vec3 kDiagonalEye(-1.75f, 0.85f, 1.75f), kDiagonalTarget(0.1f, 0.06f, -0.1f);

// A rank of upright blades across the view, one in each cell of a diagonal row. The cells (column, row) of a rank have the
// same column - row, its depth; neighbours differ by (1, 1).
struct BladeRank {
  int32_t depth = 0;  // in half diagonals from the middle; even ranks have blades between those of odd ones
  vec2 place{0.5f};   // of the blade's middle in its cell, in edges
};

void addBladeRank(Mesh& mesh, const BladeRank& rank) {
  // A tenth of an edge to either side: a blade whose middle is 0.085 edges from two faces keeps clear of both.
  const vec3 half = 0.1f * kLessonEdge * glm::normalize(vec3(1.0f, 0.0f, 1.0f));
  for (int32_t column = -3; column <= 3; ++column) {
    const vec2 cell(static_cast<float>(column), static_cast<float>(column - rank.depth));
    const vec2 middle = (cell + rank.place) * kLessonEdge;
    addBlade(mesh, {middle.x, 0.0f, middle.y}, half, 0.62f);
  }
}

Scene newDiagonalScene(std::string name) {
  Scene scene = newScene(std::move(name), {.low = {-2.5f, -2.5f}, .high = {2.5f, 2.5f}, .height = 1.5f},
                         {.name = "along the diagonal", .eye = kDiagonalEye, .target = kDiagonalTarget, .verticalFovDegrees = 40.0f});
  // A second wall closes the view of the diagonal.
  Mesh side = newMesh("side wall", 1);
  addQuad(side, {2.5f, 0.0f, -2.5f}, {0.0f, 0.0f, 5.0f}, {0.0f, 1.5f, 0.0f});
  faceTowards(side, 0, vec3(0.0f));
  shadeMesh(side, [](const vec3& position, const vec3&) { return vec3(0.85f - 0.45f * position.y / 1.5f); });
  addStill(scene, std::move(side));
  return scene;
}

}  // namespace

// Segment k starts k edges along the ray, and queries the cell that holds its start. A cell that the ray cuts at a corner, on
// a way shorter than an edge, holds a start only by luck: of rays that stay in it for 0.2 edges one in five looks inside. Red
// blades stand within the near corners of cells and are inserted there alone, so their reflections are full of holes. Yellow
// blades stand in the middles, where each ray stays longer than an edge: their reflections are whole.
Scene makeSteppedCorner() {
  Scene scene = newDiagonalScene("stepped-corner");
  Mesh corners = newMesh("corner blades", addMaterial(scene, "corner blade", kRed));
  addBladeRank(corners, {.depth = -1, .place = vec2(0.085f)});
  addStill(scene, std::move(corners));
  Mesh middles = newMesh("middle blades", addMaterial(scene, "middle blade", kYellow));
  addBladeRank(middles, {.depth = 2, .place = vec2(0.5f)});
  addStill(scene, std::move(middles));
  scene.cameras.push_back({.name = "along x", .eye = {-2.3f, 1.0f, 0.0f}, .target = {0.0f, 0.2f, 0.0f}, .verticalFovDegrees = 40.0f});
  return scene;
}

// A ray that stays in a cell for more than an edge can start two segments there; the second is skipped, because its cell was
// visited last. With the default elongation of 0.75 edges that costs nothing: the first segment reaches 1.75 edges ahead, and
// no way through a cell is longer than sqrt(3). Here the elongation is 0.05, and the blue blades stand where the diagonal
// leaves its cell, up to 1.4 edges behind where it entered: if a segment starts in the first third, its successor is skipped,
// and the blade, beyond the first one's end, is lost. The green blades in the middles are always within reach.
Scene makeRevisit() {
  Scene scene = newDiagonalScene("revisit");
  Mesh ends = newMesh("far blades", addMaterial(scene, "far blade", kBlue));
  addBladeRank(ends, {.depth = -1, .place = vec2(0.9f, 0.1f)});
  addStill(scene, std::move(ends));
  Mesh middles = newMesh("middle blades", addMaterial(scene, "middle blade", kGreen));
  addBladeRank(middles, {.depth = 2, .place = vec2(0.5f)});
  addStill(scene, std::move(middles));
  return scene;
}

namespace {

// A letter F of three bars: the simplest thing whose mirror image differs from it however it is turned.
Mesh makeLetterF(uint32_t materialIndex) {
  Mesh mesh = newMesh("letter F", materialIndex);
  addBox(mesh, {-0.22f, 0.0f, -0.08f}, {-0.06f, 0.8f, 0.08f});
  addBox(mesh, {-0.06f, 0.64f, -0.08f}, {0.3f, 0.8f, 0.08f});
  addBox(mesh, {-0.06f, 0.34f, -0.08f}, {0.18f, 0.5f, 0.08f});
  return mesh;
}

quat aboutY(float degrees) {
  const float half = 0.5f * glm::radians(degrees);
  return {std::cos(half), 0.0f, std::sin(half), 0.0f};
}

quat aboutX(float degrees) {
  const float half = 0.5f * glm::radians(degrees);
  return {std::cos(half), std::sin(half), 0.0f, 0.0f};
}

}  // namespace

// One mesh, eight instances. Front row: as it is, turned, mirrored by its own node, mirrored twice (which is a half turn).
// Back row: below a mirrored parent, as it is and mirrored again; mirrored by the matrix of an instance; and upside down by a
// negative height. Position, geometric normal (it turns around with each mirror) and shading must be right for all; parents
// scale alike in all directions before children turn, so nothing is sheared.
Scene makeMirroredInstances() {
  Scene scene = newScene("mirrored-instances", {.low = {-2.5f, -1.75f}, .high = {2.5f, 2.25f}, .height = 2.0f},
                         {.name = "letters", .eye = {0.0f, 1.75f, 3.6f}, .target = {0.0f, 0.35f, -0.1f}, .verticalFovDegrees = 42.0f});
  const uint32_t mesh = static_cast<uint32_t>(scene.meshes.size());
  scene.meshes.push_back(makeLetterF(addMaterial(scene, "letter", vec3(0.85f, 0.36f, 0.05f), 0.35f)));
  const auto addLetter = [&](const Node& node, const mat4& local = mat4(1.0f)) {
    scene.instances.push_back({.name = node.name, .node = addNode(scene, node), .mesh = mesh, .local = local});
  };
  const vec3 mirrorX(-1.0f, 1.0f, 1.0f);

  addLetter({.name = "as it is", .translation = {-1.5f, 0.0f, 0.7f}});
  addLetter({.name = "turned", .translation = {-0.5f, 0.0f, 0.7f}, .rotation = aboutY(40.0f)});
  addLetter({.name = "mirrored", .translation = {0.5f, 0.0f, 0.7f}, .scale = mirrorX});
  addLetter({.name = "mirrored twice", .translation = {1.5f, 0.0f, 0.7f}, .scale = {-1.0f, 1.0f, -1.0f}});

  const uint32_t parent = addNode(scene, {.name = "mirrored parent", .scale = {-1.25f, 1.25f, 1.25f}});
  const int32_t parentIndex = static_cast<int32_t>(parent);
  addLetter({.name = "below a mirrored parent", .parent = parentIndex, .translation = {1.2f, 0.0f, -0.5f}, .rotation = aboutY(25.0f)});
  addLetter({.name = "mirrored below a mirrored parent", .parent = parentIndex, .translation = {0.4f, 0.0f, -0.5f}, .scale = mirrorX});
  mat4 mirror(1.0f);
  mirror[0][0] = -1.0f;
  addLetter({.name = "mirrored by the instance", .translation = {0.5f, 0.0f, -0.6f}, .rotation = aboutX(-20.0f)}, mirror);
  addLetter({.name = "upside down", .translation = {1.5f, 1.0f, -0.6f}, .scale = {1.25f, -1.25f, 1.25f}});
  return scene;
}

namespace {

// A double cone with a waist: 48 triangles, spread so that no cell of the default grid is near its capacity.
Mesh makeTop(uint32_t materialIndex) {
  Mesh mesh = newMesh("top", materialIndex);
  const std::array<vec2, 6> profile = {vec2(0.0f, 0.0f), {0.2f, 0.22f}, {0.2f, 0.22f}, {0.07f, 0.4f}, {0.07f, 0.4f}, {0.0f, 0.52f}};
  addLathe(mesh, vec3(0.0f), profile, 12);
  return mesh;
}

Animation makeHops(uint32_t node, const vec3& home, uint32_t index) {
  // A square of four hops about the home place, one second each, and a quarter turn a hop.
  Channel place, turn;
  place.node = turn.node = node;
  turn.path = ChannelPath::rotation;
  for (uint32_t key = 0; key <= 8; ++key) {
    const float time = 0.5f * static_cast<float>(key) * (1.0f + 0.15f * static_cast<float>(index % 4));
    const float angle = 0.25f * kPi * static_cast<float>(key);
    const vec3 offset(0.3f * std::cos(angle) - 0.3f, key % 2 == 1 ? 0.3f : 0.0f, 0.3f * std::sin(angle));
    const quat rotation = aboutY(glm::degrees(angle));
    place.times.push_back(time), place.values.push_back(vec4(home + offset, 0.0f));
    turn.times.push_back(time), turn.values.push_back(vec4(rotation.x, rotation.y, rotation.z, rotation.w));
  }
  const float duration = place.times.back();
  return {.name = "hops " + std::to_string(index), .duration = duration, .channels = {std::move(place), std::move(turn)}};
}

}  // namespace

// Twelve dynamic tops on a mirror, of which the first few hop. `update = all` clears and adds all twelve; `moved` touches only
// the cells that the hopping ones left or entered, and must end with the same bits. Each top has room of its own.
Scene makeMovingCrowd(uint32_t movingCount) {
  Scene scene = newScene("moving-crowd", {.low = {-3.0f, -2.5f}, .high = {3.0f, 2.5f}, .height = 2.0f},
                         {.name = "crowd", .eye = {0.6f, 1.7f, 4.2f}, .target = {0.0f, 0.25f, -0.1f}, .verticalFovDegrees = 42.0f});
  const std::array kColours = {kRed, kBlue, kYellow, kGreen};
  std::array<uint32_t, 4> meshes;
  for (uint32_t i = 0; i < 4; ++i) {
    meshes[i] = static_cast<uint32_t>(scene.meshes.size());
    scene.meshes.push_back(makeTop(addMaterial(scene, "top " + std::to_string(i), kColours[i], 0.3f)));
  }

  for (uint32_t i = 0; i < kCrowdCount; ++i) {
    // The moving ones come first: spread over the crowd, not in one row.
    const uint32_t place = (i * 5) % kCrowdCount, column = place % 4, row = place / 4;
    const vec3 home(-1.95f + 1.3f * static_cast<float>(column), 0.02f, -1.3f + 1.3f * static_cast<float>(row));
    const std::string name = "top " + std::to_string(i);
    const uint32_t node = addNode(scene, {.name = name, .translation = home});
    scene.instances.push_back({.name = name, .node = node, .mesh = meshes[(column + row) % 4], .dynamic = true});
    if (i < movingCount) scene.animations.push_back(makeHops(node, home, i));
  }
  return scene;
}

// Triangles whose bounding boxes hold the whole grid: a kite from one corner of the room to the opposite one, two needles along
// the other diagonals, and a sail. Each wants a reference in thousands of cells; the plane test keeps a layer of cells for
// each, the exact test only those it really meets (compare with `overlap`). They are few, so nothing saturates.
Scene makeDiagonal() {
  Scene scene = newScene("diagonal", {.low = {-2.0f, -2.0f}, .high = {2.0f, 2.0f}, .height = 4.0f, .pieces = 4},
                         {.name = "across", .eye = {0.9f, 1.3f, 5.2f}, .target = {-0.1f, 1.35f, 0.0f}, .verticalFovDegrees = 50.0f});
  const auto addSheet = [&](std::string name, const vec3& colour, const std::array<vec3, 3>& corners) {
    Mesh mesh = newMesh(name, addMaterial(scene, name, colour, 0.4f));
    const vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    addTriangle(mesh, {corners[0], normal, {0.0f, 0.0f}}, {corners[1], normal, {1.0f, 0.0f}}, {corners[2], normal, {0.0f, 1.0f}});
    addStill(scene, std::move(mesh));
  };
  addSheet("kite", kBlue, {vec3(-2.0f, 0.0f, 2.0f), {-1.75f, 0.0f, 2.0f}, {2.0f, 4.0f, -2.0f}});
  addSheet("needle", kRed, {vec3(2.0f, 0.0f, 2.0f), {1.97f, 0.0f, 2.0f}, {-2.0f, 4.0f, -2.0f}});
  addSheet("second needle", kYellow, {vec3(-2.0f, 0.0f, -2.0f), {-2.0f, 0.0f, -1.97f}, {2.0f, 4.0f, 2.0f}});
  addSheet("sail", kGreen, {vec3(-1.9f, 0.4f, -1.9f), {1.9f, 0.1f, -1.0f}, {0.0f, 3.9f, -1.9f}});
  scene.cameras.push_back({.name = "from above", .eye = {2.6f, 3.2f, 4.2f}, .target = {0.0f, 0.8f, 0.0f}});
  return scene;
}

}  // namespace gridscope
