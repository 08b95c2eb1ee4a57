// Scenes at a time: node transforms, bounds over an animation, what moves, flat normals, and where the first camera stands.
#include "core/scene/scene.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace gridscope {
namespace {

// Adds the two triangles a, b, c and a, c, d.
void addQuad(Mesh& mesh, const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  for (const vec3& corner : {a, b, c, a, c, d}) mesh.positions.push_back(corner);
}

// The six sides of a box, fronts outside, or inside when `inward`.
void addBox(Mesh& mesh, const vec3& low, const vec3& high, bool inward) {
  const size_t begin = mesh.positions.size();
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (bool far : {false, true}) {
      vec3 corner[4];
      for (int i = 0; i < 4; ++i) {
        corner[i][axis] = far ? high[axis] : low[axis];
        corner[i][u] = (i == 1 || i == 2) == far ? high[u] : low[u];
        corner[i][v] = i >= 2 ? high[v] : low[v];
      }
      addQuad(mesh, corner[0], corner[1], corner[2], corner[3]);
    }
  }
  if (!inward) return;
  for (size_t i = begin; i < mesh.positions.size(); i += 3) std::swap(mesh.positions[i], mesh.positions[i + 1]);
}

Scene sceneOf(Mesh mesh) {
  Scene scene;
  makeFlatNormals(mesh);
  scene.materials.resize(1);
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.resize(1);
  scene.instances.push_back({.name = "thing", .node = 0, .mesh = 0});
  return scene;
}

Scene unitTriangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  return sceneOf(std::move(mesh));
}

Channel channel(ChannelPath path, Interpolation interpolation, std::vector<float> times, std::vector<vec4> values) {
  return {.node = 0, .path = path, .interpolation = interpolation, .times = std::move(times), .values = std::move(values)};
}

Scene animated(Channel moved) {
  Scene scene = unitTriangle();
  const float duration = moved.times.back();
  scene.animations.push_back({.name = "move", .duration = duration, .channels = {std::move(moved)}});
  markAnimatedInstances(scene);
  return scene;
}

vec3 placeAt(const Scene& scene, float time) { return vec3(nodeTransforms(scene, time)[0][3]); }

TEST(Scene, TranslationFollowsItsKeysAndLoops) {
  const Scene scene = animated(channel(ChannelPath::translation, Interpolation::linear, {1, 3}, {{0, 0, 0, 0}, {4, 0, 0, 0}}));
  EXPECT_EQ(placeAt(scene, 0.0f).x, 0.0f) << "before the first key";
  EXPECT_EQ(placeAt(scene, 2.0f).x, 2.0f);
  EXPECT_EQ(placeAt(scene, 2.5f).x, 3.0f);
  EXPECT_EQ(placeAt(scene, 3.0f).x, 0.0f) << "begins again";
  EXPECT_EQ(placeAt(scene, 8.0f).x, 2.0f);
  EXPECT_EQ(placeAt(scene, -1.0f).x, 2.0f);
}

TEST(Scene, EachAnimationLoopsWithItsOwnDuration) {
  Scene scene = animated(channel(ChannelPath::translation, Interpolation::linear, {0, 4}, {{0, 0, 0, 0}, {4, 0, 0, 0}}));
  Animation grow{.name = "grow", .duration = 1.0f};
  grow.channels.push_back(channel(ChannelPath::scale, Interpolation::linear, {0, 1}, {{1, 1, 1, 0}, {3, 3, 3, 0}}));
  scene.animations.push_back(grow);
  const mat4 matrix = nodeTransforms(scene, 2.5f)[0];
  EXPECT_EQ(matrix[3].x, 2.5f);
  EXPECT_EQ(matrix[0].x, 2.0f);
}

TEST(Scene, StepsStayUntilTheNextKey) {
  const Scene scene =
      animated(channel(ChannelPath::translation, Interpolation::step, {0, 1, 2}, {{0, 0, 0, 0}, {5, 0, 0, 0}, {9, 0, 0, 0}}));
  EXPECT_EQ(placeAt(scene, 0.99f).x, 0.0f);
  EXPECT_EQ(placeAt(scene, 1.0f).x, 5.0f);
  EXPECT_EQ(placeAt(scene, 1.99f).x, 5.0f);
}

TEST(Scene, RotationsTurnEvenlyTheShorterWay) {
  // From none to 90 degrees about z, the second given as the negative quaternion of the same turn.
  const float half = std::sqrt(0.5f);
  const Scene scene = animated(channel(ChannelPath::rotation, Interpolation::linear, {0, 3}, {{0, 0, 0, 1}, {0, 0, -half, -half}}));
  const mat4 matrix = nodeTransforms(scene, 1.0f)[0];
  EXPECT_NEAR(matrix[0].x, std::cos(glm::radians(30.0f)), 1e-6f);
  EXPECT_NEAR(matrix[0].y, std::sin(glm::radians(30.0f)), 1e-6f);
}

TEST(Scene, CubicSplinesUseTangentsPerSecond) {
  // x = t^3 from 0 to 2 s: values 0 and 8, slopes 0 and 12.
  const Scene scene = animated(channel(ChannelPath::translation, Interpolation::cubicSpline, {0, 2},
                                       {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {12, 0, 0, 0}, {8, 0, 0, 0}, {0, 0, 0, 0}}));
  EXPECT_FLOAT_EQ(placeAt(scene, 0.5f).x, 0.125f);
  EXPECT_FLOAT_EQ(placeAt(scene, 1.5f).x, 3.375f);
}

TEST(Scene, ChildrenFollowTheirParents) {
  Scene scene = unitTriangle();
  scene.nodes[0].translation = vec3(10, 0, 0);
  scene.nodes[0].scale = vec3(2, 2, -2);
  scene.nodes.push_back({.name = "child", .parent = 0, .translation = vec3(0, 0, 3)});
  EXPECT_EQ(nodeTransforms(scene, 0.0f)[1][3], vec4(10, 0, -6, 1));
}

TEST(Scene, OnlyWhatAnAnimationCanMoveIsDynamic) {
  Scene scene = animated(channel(ChannelPath::translation, Interpolation::linear, {0, 1}, {{0, 0, 0, 0}, {1, 0, 0, 0}}));
  scene.nodes.push_back({.name = "child", .parent = 0});
  scene.nodes.push_back({.name = "apart"});
  scene.instances.push_back({.name = "child", .node = 1, .mesh = 0});
  scene.instances.push_back({.name = "apart", .node = 2, .mesh = 0});
  markAnimatedInstances(scene);
  EXPECT_TRUE(scene.instances[0].dynamic);
  EXPECT_TRUE(scene.instances[1].dynamic);
  EXPECT_FALSE(scene.instances[2].dynamic);

  scene.animations[0].channels[0].values[1] = vec4(0.0f);  // keys that are all alike
  markAnimatedInstances(scene);
  EXPECT_FALSE(scene.instances[0].dynamic);
  scene.animations[0].channels[0].values[1].x = 1.0f;
  markAnimatedInstances(scene);
  EXPECT_TRUE(scene.instances[1].dynamic);
}

TEST(Scene, BoundsCoverTheWholeAnimation) {
  const Scene slide = animated(channel(ChannelPath::translation, Interpolation::linear, {0, 2}, {{0, 0, 0, 0}, {-7, 0, 0, 0}}));
  EXPECT_NEAR(sceneBounds(slide).low.x, -7.0f, 1e-5f) << "the end, though the loop begins again there";
  EXPECT_EQ(sceneBounds(slide).high.x, 1.0f);

  // A half turn about z passes through (-1, 1), which neither key shows.
  const Scene turn = animated(channel(ChannelPath::rotation, Interpolation::linear, {0, 1, 2},
                                      {{0, 0, 0, 1}, {0, 0, std::sqrt(0.5f), std::sqrt(0.5f)}, {0, 0, 1, 0}}));
  EXPECT_NEAR(sceneBounds(turn).low.x, -1.0f, 1e-3f);
  EXPECT_NEAR(sceneBounds(turn).low.y, -1.0f, 1e-3f);
}

TEST(Scene, BoundsOfTwoLoopsCoverTheirMeeting) {
  // Two short slides while a long one runs once: the instance reaches 10 + 1 only in the last of them.
  Scene scene = animated(channel(ChannelPath::translation, Interpolation::linear, {0, 10}, {{0, 0, 0, 0}, {10, 0, 0, 0}}));
  scene.nodes.push_back({.name = "child", .parent = 0});
  scene.instances[0].node = 1;
  Animation slide{.name = "slide", .duration = 1.0f};
  slide.channels.push_back(channel(ChannelPath::translation, Interpolation::linear, {0, 1}, {{0, 0, 0, 0}, {1, 0, 0, 0}}));
  slide.channels[0].node = 1;
  scene.animations.push_back(slide);
  markAnimatedInstances(scene);
  EXPECT_NEAR(sceneBounds(scene).high.x, 12.0f, 0.2f);
}

TEST(Scene, BoundsRefuseWhatTheGridCannotHold) {
  EXPECT_THROW(sceneBounds(Scene{}), Error);
  Scene far = unitTriangle();
  far.nodes[0].translation.x = 1.5e6f;
  EXPECT_THROW(sceneBounds(far), Error);
  Scene nowhere = unitTriangle();
  nowhere.nodes[0].scale.y = NAN;
  EXPECT_THROW(sceneBounds(nowhere), Error);
  const Scene leaving = animated(channel(ChannelPath::translation, Interpolation::linear, {0, 1}, {{0, 0, 0, 0}, {0, 2e6, 0, 0}}));
  EXPECT_THROW(sceneBounds(leaving), Error);
}

TEST(Scene, FlatNormalsFillOnlyWhatIsMissing) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {2, 2, 2}, {2, 2, 2}, {2, 2, 2}, {0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 0}};
  mesh.normals = {{1, 0, 0}, {0, 0, 0}, {NAN, 0, 0}};
  makeFlatNormals(mesh);
  ASSERT_EQ(mesh.normals.size(), 9u);
  EXPECT_EQ(mesh.normals[0], vec3(1, 0, 0)) << "the file's";
  EXPECT_EQ(mesh.normals[1], vec3(0, -1, 0));
  EXPECT_EQ(mesh.normals[2], vec3(0, -1, 0));
  EXPECT_EQ(mesh.normals[3], vec3(0, 1, 0)) << "no area";
  EXPECT_EQ(mesh.normals[6], vec3(0, 0, 1)) << "tiny, but with an area";
}

TEST(Scene, TheFirstCameraIsTheDefaultOne) {
  Scene scene = unitTriangle();
  scene.cameras = {{.name = "first"}, {.name = "second"}};
  EXPECT_EQ(defaultCamera(scene).name, "first");
}

TEST(Scene, ARoomIsSeenFromInsideAlongItsLongSide) {
  Mesh mesh;
  addBox(mesh, vec3(0, 0, 0), vec3(5, 4, 20), true);
  addBox(mesh, vec3(1, 0, 6), vec3(2, 4, 7), false);  // a pillar
  const CameraPose camera = defaultCamera(sceneOf(std::move(mesh)));
  const vec3 direction = glm::normalize(camera.target - camera.eye);
  EXPECT_TRUE(glm::all(glm::greaterThan(camera.eye, vec3(0.1f))) && glm::all(glm::lessThan(camera.eye, vec3(4.9f, 3.9f, 19.9f))));
  EXPECT_GT(std::abs(direction.z), 0.9f);
  EXPECT_GT(direction.z * (10.0f - camera.eye.z), 0.0f) << "looks along the longer part";
  EXPECT_NEAR(camera.eye.y, 1.7f, 0.3f);
}

TEST(Scene, AnObjectIsSeenFromOutsideAndFillsThePicture) {
  for (float size : {1e-3f, 1.0f, 1e4f}) {
    Mesh mesh;
    addBox(mesh, vec3(-1, 0, -1) * size, vec3(1, 2, 1) * size, false);
    const CameraPose camera = defaultCamera(sceneOf(std::move(mesh)));
    const float distance = glm::length(camera.eye - vec3(0, size, 0)) / size;
    EXPECT_GT(distance, 2.0f);
    EXPECT_LT(distance, 8.0f);
    EXPECT_GT(camera.eye.y, size);
  }
}

TEST(Scene, FlatAndPointLikeScenesHaveACamera) {
  for (const vec3& third : {vec3(0, 0, 1), vec3(0, 1, 0), vec3(1, 0, 0), vec3(0, 0, 0)}) {
    Mesh mesh;
    mesh.positions = {vec3(0.0f), vec3(1, 0, 0), third};
    if (third == vec3(0.0f)) mesh.positions[1] = vec3(0.0f);
    const CameraPose camera = defaultCamera(sceneOf(std::move(mesh)));
    EXPECT_TRUE(std::isfinite(camera.eye.x) && std::isfinite(camera.eye.y) && std::isfinite(camera.eye.z));
    EXPECT_NE(camera.eye, camera.target);
  }
}

}  // namespace
}  // namespace gridscope
