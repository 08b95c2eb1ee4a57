#include "core/scene/built_in_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace gridscope {
namespace {

uint32_t triangleCount(const Scene& scene) {
  uint32_t count = 0;
  for (const SceneInstance& instance : scene.instances) count += scene.meshes[instance.mesh].triangleCount();
  return count;
}

// FNV-1a over the bytes of all geometry and images.
uint64_t hashOf(const Scene& scene) {
  uint64_t hash = 0xCBF29CE484222325u;
  const auto include = [&](const auto& values) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    for (size_t i = 0; i < values.size() * sizeof(values[0]); ++i) hash = (hash ^ bytes[i]) * 0x100000001B3u;
  };
  for (const Mesh& mesh : scene.meshes) {
    include(mesh.positions), include(mesh.normals), include(mesh.uvs), include(mesh.colours);
  }
  for (const Image& image : scene.images) include(image.rgba);
  return hash;
}

TEST(BuiltInScenes, BeginWithTheHall) { EXPECT_EQ(builtInScenes().front().name, "hall"); }

TEST(BuiltInScenes, HaveNamesOfTheirOwnAndALineEach) {
  std::set<std::string_view> names;
  for (const BuiltInScene& scene : builtInScenes()) {
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    EXPECT_FALSE(scene.lesson.empty()) << scene.name;
    EXPECT_EQ(scene.lesson.find('\n'), std::string_view::npos) << scene.name;
    EXPECT_EQ(scene.make().name, scene.name);
  }
}

TEST(BuiltInScenes, AreListedWhenAnUnknownOneIsAskedFor) {
  try {
    makeBuiltInScene("hull");
    FAIL() << "no error";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("'hull'"), std::string::npos) << message;
    for (const BuiltInScene& scene : builtInScenes()) EXPECT_NE(message.find(scene.name), std::string::npos) << message;
    EXPECT_EQ(error.exitCode(), kExitBadInput);
  }
}

TEST(Hall, HasOneHundredToTwoHundredThousandTriangles) {
  const uint32_t count = triangleCount(makeHall());
  EXPECT_GE(count, 100000u);
  EXPECT_LE(count, 200000u);
}

TEST(Hall, HasThreeTeapotsThatMoveAndNothingElseDynamic) {
  const Scene scene = makeHall();
  const auto dynamic = [](const SceneInstance& instance) { return instance.dynamic; };
  EXPECT_EQ(std::count_if(scene.instances.begin(), scene.instances.end(), dynamic), 3);
  EXPECT_EQ(scene.animations.size(), 3u);
}

TEST(Hall, PacksItsFiligreeIntoAFewCells) {
  const Scene scene = makeHall();
  const auto found = std::find_if(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& mesh) { return mesh.name == "filigree"; });
  ASSERT_NE(found, scene.meshes.end());
  EXPECT_GE(found->triangleCount(), 20000u);
  Bounds bounds;
  for (const vec3& position : found->positions) bounds.include(position);
  const vec3 hall = sceneBounds(scene).high - sceneBounds(scene).low;
  const float cellEdge = std::max({hall.x, hall.y, hall.z}) / 128.0f;
  EXPECT_LE(std::max({bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y, bounds.high.z - bounds.low.z}), 4.0f * cellEdge);
}

TEST(Hall, StaysInsideItsWallsWhileTheTeapotsMove) {
  Scene scene = makeHall();
  const Bounds moving = sceneBounds(scene);
  std::erase_if(scene.instances, [](const SceneInstance& instance) { return instance.dynamic; });
  const Bounds still = sceneBounds(scene);
  EXPECT_EQ(moving.low, still.low);
  EXPECT_EQ(moving.high, still.high);
}

class EachBuiltInScene : public testing::TestWithParam<BuiltInScene> {};

TEST_P(EachBuiltInScene, IsTheSameEachTimeItIsMade) { EXPECT_EQ(hashOf(GetParam().make()), hashOf(GetParam().make())); }

TEST_P(EachBuiltInScene, HasACameraThatSeesIntoItsBounds) {
  const Scene scene = GetParam().make();
  const Bounds bounds = sceneBounds(scene);
  ASSERT_FALSE(scene.cameras.empty());
  for (const CameraPose& camera : scene.cameras) {
    EXPECT_FALSE(camera.name.empty());
    const vec3 middle = glm::clamp(camera.target, bounds.low, bounds.high);
    EXPECT_GT(glm::length(camera.target - camera.eye), 0.1f) << camera.name;
    EXPECT_LT(glm::length(camera.target - middle), 1.0f) << camera.name;
    EXPECT_GT(camera.verticalFovDegrees, 10.0f);
  }
}

TEST_P(EachBuiltInScene, HasFiniteGeometryWithUnitNormals) {
  for (const Mesh& mesh : GetParam().make().meshes) {
    ASSERT_EQ(mesh.positions.size() % 3, 0u) << mesh.name;
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size()) << mesh.name;
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size()) << mesh.name;
    ASSERT_EQ(mesh.colours.size(), mesh.positions.size()) << mesh.name;
    EXPECT_LE(mesh.triangleCount(), 65536u) << mesh.name;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      ASSERT_LT(glm::length(mesh.positions[i]), 1000.0f) << mesh.name << ", corner " << i;
      ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-4f) << mesh.name << ", corner " << i;
      ASSERT_LT(glm::length(mesh.uvs[i]), 200.0f) << mesh.name << ", corner " << i;
      ASSERT_TRUE(glm::all(glm::greaterThanEqual(mesh.colours[i], vec4(0.0f)))) << mesh.name << ", corner " << i;
      ASSERT_TRUE(glm::all(glm::lessThanEqual(mesh.colours[i], vec4(1.0f)))) << mesh.name << ", corner " << i;
    }
  }
}

TEST_P(EachBuiltInScene, HasNoTriangleWithoutArea) {
  const Scene scene = GetParam().make();
  const std::vector<mat4> transforms = nodeTransforms(scene, 0.0f);
  for (const SceneInstance& instance : scene.instances) {
    const mat4 world = transforms[instance.node] * instance.local;
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (size_t i = 0; i < mesh.positions.size(); i += 3) {
      const vec3 edge1 = mesh.positions[i + 1] - mesh.positions[i], edge2 = mesh.positions[i + 2] - mesh.positions[i];
      const vec3 normal = glm::cross(vec3(world * vec4(edge1, 0.0f)), vec3(world * vec4(edge2, 0.0f)));
      ASSERT_GT(glm::dot(normal, normal), 1e-20f) << mesh.name << ", triangle " << i / 3;
    }
  }
}

TEST_P(EachBuiltInScene, HasWindingOnTheSideOfItsNormals) {
  for (const Mesh& mesh : GetParam().make().meshes) {
    for (size_t i = 0; i < mesh.positions.size(); i += 3) {
      const vec3 winding = glm::cross(mesh.positions[i + 1] - mesh.positions[i], mesh.positions[i + 2] - mesh.positions[i]);
      const vec3 normals = mesh.normals[i] + mesh.normals[i + 1] + mesh.normals[i + 2];
      ASSERT_GE(glm::dot(winding, normals), 0.0f) << mesh.name << ", triangle " << i / 3;
    }
  }
}

TEST_P(EachBuiltInScene, NamesOnlyWhatItHas) {
  const Scene scene = GetParam().make();
  for (const SceneInstance& instance : scene.instances) {
    ASSERT_LT(instance.mesh, scene.meshes.size());
    ASSERT_LT(instance.node, scene.nodes.size());
    EXPECT_FALSE(instance.name.empty());
  }
  for (const Mesh& mesh : scene.meshes) ASSERT_LT(mesh.materialIndex, scene.materials.size()) << mesh.name;
  for (const Material& material : scene.materials) {
    ASSERT_LT(material.imageIndex, static_cast<int32_t>(scene.images.size())) << material.name;
    EXPECT_EQ(material.alphaMode == AlphaMode::mask && material.imageIndex < 0, false) << material.name;
  }
  for (size_t i = 0; i < scene.nodes.size(); ++i) EXPECT_LT(scene.nodes[i].parent, static_cast<int32_t>(i));
}

TEST_P(EachBuiltInScene, HasHolesAndLeafInEachAlphaMap) {
  const Scene scene = GetParam().make();
  for (const Material& material : scene.materials) {
    if (material.alphaMode != AlphaMode::mask) continue;
    const Image& image = scene.images[static_cast<size_t>(material.imageIndex)];
    ASSERT_EQ(image.rgba.size(), 4u * image.width * image.height);
    size_t solid = 0;
    for (size_t i = 3; i < image.rgba.size(); i += 4) solid += image.rgba[i] >= 128;
    const double share = static_cast<double>(solid) / (image.width * image.height);
    EXPECT_GT(share, 0.15) << material.name;
    EXPECT_LT(share, 0.85) << material.name;
  }
}

TEST_P(EachBuiltInScene, FitsItsSize) {
  if (GetParam().name == "hall") return;
  const uint32_t count = triangleCount(GetParam().make());
  EXPECT_GE(count, 20u);
  EXPECT_LE(count, 8000u);
}

TEST_P(EachBuiltInScene, HasAFloorThatMirrors) {
  const Scene scene = GetParam().make();
  const auto mirrors = [&](const Mesh& mesh) {
    return mesh.name.find("floor") != std::string::npos && scene.materials[mesh.materialIndex].roughness < 0.1f;
  };
  EXPECT_TRUE(std::any_of(scene.meshes.begin(), scene.meshes.end(), mirrors));
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, EachBuiltInScene, testing::ValuesIn(builtInScenes().begin(), builtInScenes().end()),
                         [](const auto& scene) {
                           std::string text(scene.param.name);
                           for (char& letter : text) letter = letter == '-' ? '_' : letter;
                           return text;
                         });

TEST(MovingCrowd, MovesAsManyAsAskedForOfTwelve) {
  for (const uint32_t moving : {0u, 1u, 3u, 11u, 12u}) {
    const Scene scene = makeMovingCrowd(moving);
    EXPECT_EQ(scene.animations.size(), moving);
    EXPECT_EQ(std::count_if(scene.instances.begin(), scene.instances.end(), [](const auto& instance) { return instance.dynamic; }), 12);
  }
}

TEST(MovingCrowd, KeepsApart) {
  Scene scene = makeMovingCrowd(12);
  for (float time = 0.0f; time < 12.0f; time += 0.25f) {
    const std::vector<mat4> transforms = nodeTransforms(scene, time);
    std::vector<vec3> places;
    for (const SceneInstance& instance : scene.instances) {
      if (instance.dynamic) places.push_back(vec3(transforms[instance.node][3]));
    }
    for (size_t i = 0; i < places.size(); ++i) {
      for (size_t k = 0; k < i; ++k) EXPECT_GT(glm::length(places[i] - places[k]), 0.45f) << i << " and " << k << " at " << time << " s";
    }
  }
}

TEST(MirroredInstances, MirrorSomeAndNotOthers) {
  const Scene scene = makeMirroredInstances();
  const std::vector<mat4> transforms = nodeTransforms(scene, 0.0f);
  uint32_t mirrored = 0, letters = 0;
  for (const SceneInstance& instance : scene.instances) {
    const glm::mat3 world(transforms[instance.node] * instance.local);
    const bool letter = scene.meshes[instance.mesh].name == "letter F";
    letters += letter;
    mirrored += letter && glm::determinant(world) < 0.0f;
    // No shear: the axes stay at right angles.
    EXPECT_NEAR(glm::dot(world[0], world[1]), 0.0f, 1e-5f) << instance.name;
    EXPECT_NEAR(glm::dot(world[1], world[2]), 0.0f, 1e-5f) << instance.name;
    EXPECT_NEAR(glm::dot(world[2], world[0]), 0.0f, 1e-5f) << instance.name;
  }
  EXPECT_EQ(letters, 8u);
  EXPECT_EQ(mirrored, 4u);
}

// Each blade lies within one cell in x and z, away from its faces, so that no other cell's box holds it.
void expectBladesInTheirCells(const Scene& scene, const char* name, float edge) {
  const auto found = std::find_if(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) { return mesh.name == name; });
  ASSERT_NE(found, scene.meshes.end()) << name;
  for (size_t i = 0; i < found->positions.size(); i += 3) {
    for (const int axis : {0, 2}) {
      const float middle = (found->positions[i][axis] + found->positions[i + 1][axis] + found->positions[i + 2][axis]) / 3.0f;
      const float low = std::floor(middle / edge) * edge;
      for (size_t corner = i; corner < i + 3; ++corner) {
        EXPECT_GT(found->positions[corner][axis], low + 0.005f * edge) << name << ", triangle " << i / 3;
        EXPECT_LT(found->positions[corner][axis], low + 0.995f * edge) << name << ", triangle " << i / 3;
      }
    }
  }
}

TEST(SteppedCorner, KeepsEachBladeInOneCell) {
  const Scene scene = makeSteppedCorner();
  const float edge = findBuiltInScene("stepped-corner").cellEdge;
  expectBladesInTheirCells(scene, "corner blades", edge);
  expectBladesInTheirCells(scene, "middle blades", edge);
  // The grid's origin lies on a multiple of the edge, where the scene's bounds begin.
  const vec3 low = sceneBounds(scene).low / edge;
  EXPECT_EQ(low, glm::round(low));
}

TEST(Revisit, KeepsEachBladeInOneCell) {
  const Scene scene = makeRevisit();
  const float edge = findBuiltInScene("revisit").cellEdge;
  expectBladesInTheirCells(scene, "far blades", edge);
  expectBladesInTheirCells(scene, "middle blades", edge);
  const vec3 low = sceneBounds(scene).low / edge;
  EXPECT_EQ(low, glm::round(low));
}

TEST(SaturatedCell, HasItsWholeTuftInOneCell) {
  const Scene scene = makeSaturatedCell();
  const float edge = findBuiltInScene("saturated-cell").cellEdge;
  const auto found = std::find_if(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& mesh) { return mesh.name == "tuft"; });
  ASSERT_NE(found, scene.meshes.end());
  for (const vec3& position : found->positions) {
    ASSERT_EQ(glm::floor(position / edge), vec3(-1.0f, 2.0f, 0.0f));
  }
  EXPECT_GT(found->triangleCount(), 10 * findBuiltInScene("saturated-cell").capacity);
}

}  // namespace
}  // namespace gridscope
