#include "core/scene/teapot.h"

#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "core/scene/built_in_scenes.h"

namespace gridscope {
namespace {

Bounds boundsOf(const Mesh& mesh) {
  Bounds bounds;
  for (const vec3& position : mesh.positions) bounds.include(position);
  return bounds;
}

// The number of triangles at each edge; corners that are nearer than a hundredth of a percent of the teapot are one.
std::map<std::array<int, 6>, int> countEdges(const Mesh& mesh) {
  const auto place = [](const vec3& position) {
    const vec3 rounded = glm::round(position * 2000.0f);
    return std::array<int, 3>{static_cast<int>(rounded.x), static_cast<int>(rounded.y), static_cast<int>(rounded.z)};
  };
  std::map<std::array<int, 6>, int> edges;
  for (size_t corner = 0; corner < mesh.positions.size(); ++corner) {
    const size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
    std::array<int, 3> a = place(mesh.positions[corner]), b = place(mesh.positions[next]);
    if (b < a) std::swap(a, b);
    ++edges[{a[0], a[1], a[2], b[0], b[1], b[2]}];
  }
  return edges;
}

TEST(Teapot, HasAboutSixThousandTriangles) { EXPECT_EQ(makeTeapot(kTeapotSubdivisions, 0).triangleCount(), 6320u); }

TEST(Teapot, LeavesOutTheTrianglesWithoutAreaAtItsPoles) {
  // 32 patches, of which 8 have a pole with one triangle too few for each cell beside it.
  for (const uint32_t subdivisions : {3u, 7u, 16u}) {
    EXPECT_EQ(makeTeapot(subdivisions, 0).triangleCount(), 64 * subdivisions * subdivisions - 8 * subdivisions) << subdivisions;
  }
}

TEST(Teapot, StandsOnTheGroundInNewellsProportions) {
  const Bounds bounds = boundsOf(makeTeapot(kTeapotSubdivisions, 0));
  EXPECT_NEAR(bounds.low.y, 0.0f, 1e-6f);
  EXPECT_NEAR(bounds.high.y, 3.15f, 1e-5f);
  EXPECT_NEAR(bounds.high.x - bounds.low.x, 6.43f, 0.05f);
  EXPECT_NEAR(bounds.high.z - bounds.low.z, 4.0f, 0.02f);
  EXPECT_NEAR(bounds.high.z, -bounds.low.z, 1e-6f);
  EXPECT_GT(bounds.high.x, -bounds.low.x) << "the spout points along +x";
}

TEST(Teapot, IsClosedButForTheSixRimsOfNewellsParts) {
  const uint32_t n = kTeapotSubdivisions;
  size_t open = 0;
  for (const auto& [edge, count] : countEdges(makeTeapot(n, 0))) {
    EXPECT_LE(count, 2) << "an edge with more than two triangles";
    open += count == 1;
  }
  // Four quarters at the lid and at the body's mouth; two halves at each end of handle and spout.
  EXPECT_EQ(open, (4 + 4 + 2 * 2 + 2 * 2) * n);
}

TEST(Teapot, HasUnitNormalsOnTheSideThatTheWindingTells) {
  const Mesh mesh = makeTeapot(kTeapotSubdivisions, 0);
  for (size_t i = 0; i < mesh.positions.size(); i += 3) {
    const vec3 winding = glm::cross(mesh.positions[i + 1] - mesh.positions[i], mesh.positions[i + 2] - mesh.positions[i]);
    for (size_t corner = i; corner < i + 3; ++corner) {
      ASSERT_NEAR(glm::length(mesh.normals[corner]), 1.0f, 1e-5f);
    }
    EXPECT_GT(glm::dot(winding, mesh.normals[i] + mesh.normals[i + 1] + mesh.normals[i + 2]), 0.0f) << "triangle " << i / 3;
  }
}

TEST(Teapot, HasItsNormalsOutside) {
  // The volume by the divergence theorem: positive when most of the winding is outward.
  const Mesh mesh = makeTeapot(kTeapotSubdivisions, 0);
  double volume = 0.0;
  for (size_t i = 0; i < mesh.positions.size(); i += 3) {
    volume += glm::dot(mesh.positions[i], glm::cross(mesh.positions[i + 1], mesh.positions[i + 2])) / 6.0;
  }
  EXPECT_GT(volume, 20.0);
}

class TeapotsInAScene : public testing::TestWithParam<const char*> {};

TEST_P(TeapotsInAScene, StayInsideItsBoundsOverTheirWholeLoop) {
  Scene scene = makeBuiltInScene(GetParam());
  const Bounds before = sceneBounds(scene);
  const size_t instances = scene.instances.size();
  addTeapots(scene, 5, 3);

  ASSERT_EQ(scene.instances.size(), instances + 5);
  for (float time = 0.0f; time < 20.0f; time += 0.37f) {
    const std::vector<mat4> transforms = nodeTransforms(scene, time);
    for (size_t i = instances; i < scene.instances.size(); ++i) {
      EXPECT_TRUE(scene.instances[i].dynamic);
      const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
      for (size_t corner = 0; corner < mesh.positions.size(); corner += 7) {
        const vec3 place = vec3(transforms[scene.instances[i].node] * vec4(mesh.positions[corner], 1.0f));
        ASSERT_TRUE(glm::all(glm::greaterThanEqual(place, before.low - 1e-3f))) << scene.instances[i].name << " at " << time << " s";
        ASSERT_TRUE(glm::all(glm::lessThanEqual(place, before.high + 1e-3f))) << scene.instances[i].name << " at " << time << " s";
      }
    }
  }
}

TEST_P(TeapotsInAScene, MoveIfTheyAreToMoveAndReturnToTheirStart) {
  Scene scene = makeBuiltInScene(GetParam());
  const size_t animations = scene.animations.size(), instances = scene.instances.size();
  addTeapots(scene, 4, 2);
  ASSERT_EQ(scene.animations.size(), animations + 2);

  const std::vector<mat4> start = nodeTransforms(scene, 0.0f), later = nodeTransforms(scene, 1.0f);
  for (size_t i = 0; i < 4; ++i) {
    const uint32_t node = scene.instances[instances + i].node;
    EXPECT_EQ(start[node] != later[node], i < 2) << scene.instances[instances + i].name;
  }
  for (size_t i = animations; i < scene.animations.size(); ++i) {
    for (const Channel& channel : scene.animations[i].channels) {
      const bool turn = channel.path == ChannelPath::rotation;
      // A rotation and its negative are one.
      const vec4 first = channel.values.front(), last = channel.values.back();
      EXPECT_LT(glm::length(turn && glm::dot(first, last) < 0.0f ? first + last : first - last), 1e-3f);
      EXPECT_EQ(channel.times.back(), scene.animations[i].duration);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, TeapotsInAScene, testing::Values("hall", "empty-walk", "alpha-leaf", "diagonal"), [](const auto& name) {
  std::string text = name.param;
  for (char& letter : text) letter = letter == '-' ? '_' : letter;
  return text;
});

}  // namespace
}  // namespace gridscope
