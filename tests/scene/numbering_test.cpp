// Numbering: which instance and triangle a reference names, and what the trace reads of materials.
#include "core/scene/numbering.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "shaders/shared/scene/scene.h"
#include "tests/small_scene.h"

namespace gridscope {
namespace {

Triangle triangleOfSize(float size, float x = 0.0f) { return {vec3(x, 0, 0), vec3(x + size, 0, 0), vec3(x, size, 0)}; }

double area(const Triangle& triangle) {
  return 0.5 * glm::length(glm::cross(glm::dvec3(triangle.b - triangle.a), glm::dvec3(triangle.c - triangle.a)));
}

// A scene with one material over a 2x1 image.
Scene keyedScene(AlphaMode mode, float opacity, float cutoff, bool withImage = true) {
  Scene scene = sceneOf({triangleOfSize(1.0f)});
  scene.images.push_back({"leaf", 2, 1, {1, 2, 3, 10, 4, 5, 6, 200}});
  Material& material = scene.materials[0];
  material.alphaMode = mode;
  material.alphaCutoff = cutoff;
  material.baseColour.a = opacity;
  material.imageIndex = withImage ? 0 : -1;
  return scene;
}

// A mesh whose node moves 1 along x in the first second.
Scene movingScene() {
  Scene scene = emptyScene();
  const uint32_t mesh = addMesh(scene, meshOf({triangleOfSize(1.0f), triangleOfSize(2.0f)}));
  placeMesh(scene, mesh, vec3(0.0f), true);
  placeMesh(scene, mesh);
  placeMesh(scene, mesh, vec3(5.0f, 0.0f, 0.0f), true);
  Channel channel{0, ChannelPath::translation, Interpolation::linear, {0.0f, 1.0f}, {vec4(0.0f), vec4(1.0f, 0.0f, 0.0f, 0.0f)}};
  scene.animations.push_back({"walk", 2.0f, {channel}});
  return scene;
}

TEST(Numbering, StaticInstancesComeBeforeDynamicOnesAndKeepTheFilesOrder) {
  const NumberedScene numbered = numberScene(movingScene(), NumberBy::file);
  ASSERT_EQ(numbered.instanceCount(), 3u);
  EXPECT_EQ(numbered.staticInstanceCount, 1u);
  EXPECT_EQ(numbered.staticTriangleCount, 2u);
  EXPECT_EQ(numbered.triangleCount, 6u);
  EXPECT_EQ(numbered.sources[0].sceneInstance, 1u);
  EXPECT_EQ(numbered.sources[1].sceneInstance, 0u);
  EXPECT_EQ(numbered.sources[2].sceneInstance, 2u);
  for (uint32_t i = 0; i < 3; ++i) EXPECT_EQ(numbered.instances[i].firstWorldTriangle, 2 * i);
}

TEST(Numbering, AMeshUsedTwiceHasItsObjectTrianglesOnce) {
  const NumberedScene numbered = numberScene(movingScene(), NumberBy::file);
  EXPECT_EQ(numbered.objectTriangles.size(), 2u);
  EXPECT_EQ(numbered.corners.size(), 6u);
  EXPECT_EQ(numbered.instances[0].firstTriangle, numbered.instances[2].firstTriangle);
}

TEST(Numbering, ALargeMeshIsCutAndEveryReferenceLeadsBackToTheFilesTriangle) {
  for (NumberBy order : {NumberBy::file, NumberBy::area}) {
    Scene scene = emptyScene();
    const uint32_t mesh = addMesh(scene, meshOf(randomTriangles(70000, 10.0f, 0.5f, 1)));
    placeMesh(scene, mesh);
    placeMesh(scene, mesh, vec3(30.0f, 0.0f, 0.0f));
    const NumberedScene numbered = numberScene(scene, order);
    if (order == NumberBy::file) {
      EXPECT_EQ(numbered.instanceCount(), 4u);
    }
    EXPECT_EQ(numbered.triangleCount, 140000u);

    std::vector<int> named(140000);
    for (uint32_t i = 0; i < numbered.instanceCount(); ++i)
      for (uint32_t k = 0; k < numbered.instances[i].triangleCount; ++k) {
        ASSERT_LE(k, 65535u);
        const TriangleName name = nameTriangle(numbered, makeReference(i, k));
        ASSERT_LT(name.sceneInstance, 2u);
        named[name.sceneInstance * 70000 + name.triangle] += 1;
        const Triangle& triangle = numbered.objectTriangles[numbered.instances[i].firstTriangle + k];
        ASSERT_EQ(triangle.b, scene.meshes[0].positions[3 * name.triangle + 1]);
      }
    EXPECT_EQ(std::count(named.begin(), named.end(), 1), 140000);
  }
}

TEST(Numbering, ByAreaLargeTrianglesGetSmallReferencesAcrossMeshes) {
  Scene scene = emptyScene();
  const uint32_t small = addMesh(scene, meshOf({triangleOfSize(0.01f), triangleOfSize(1.0f), triangleOfSize(0.011f)}));
  const uint32_t large = addMesh(scene, meshOf({triangleOfSize(0.5f), triangleOfSize(0.6f), triangleOfSize(0.55f), triangleOfSize(10.0f)}));
  placeMesh(scene, small);
  placeMesh(scene, large);
  const NumberedScene numbered = numberScene(scene, NumberBy::area);
  std::vector<double> areas;
  for (const Instance& instance : numbered.instances)
    for (uint32_t k = 0; k < instance.triangleCount; ++k) areas.push_back(area(numbered.objectTriangles[instance.firstTriangle + k]));
  ASSERT_EQ(areas.size(), 7u);
  EXPECT_TRUE(std::is_sorted(areas.rbegin(), areas.rend()));
  EXPECT_EQ(nameTriangle(numbered, 0).mesh, large);
  EXPECT_EQ(nameTriangle(numbered, 0).triangle, 3u);
}

TEST(Numbering, ByAreaAnInstancesScaleCounts) {
  Scene scene = emptyScene();
  const uint32_t mesh = addMesh(scene, meshOf({triangleOfSize(1.0f)}));
  placeMesh(scene, mesh);
  placeMesh(scene, mesh);
  scene.nodes[1].scale = vec3(3.0f);
  const NumberedScene numbered = numberScene(scene, NumberBy::area);
  EXPECT_EQ(numbered.sources[0].sceneInstance, 1u);
  EXPECT_EQ(numbered.sources[1].sceneInstance, 0u);
}

TEST(Numbering, ByAreaEqualTrianglesKeepTheFilesOrder) {
  Scene scene = sceneOf(std::vector<Triangle>(100, triangleOfSize(0.7f)));
  placeMesh(scene, 0);
  const NumberedScene numbered = numberScene(scene, NumberBy::area);
  ASSERT_EQ(numbered.instanceCount(), 2u);
  EXPECT_EQ(numbered.sources[0].sceneInstance, 0u);
  for (uint32_t k = 0; k < 100; ++k) EXPECT_EQ(nameTriangle(numbered, k).triangle, k);
}

TEST(Numbering, AreaClassesGrowCoarserBeforeTheyTakeTooManyInstances) {
  Scene scene = emptyScene();
  std::vector<Triangle> triangles;
  for (int i = 0; i < 12; ++i) triangles.push_back(triangleOfSize(std::exp2(float(i))));
  const uint32_t mesh = addMesh(scene, meshOf(triangles));
  for (int i = 0; i < 6000; ++i) placeMesh(scene, mesh);
  const NumberedScene numbered = numberScene(scene, NumberBy::area);
  EXPECT_LE(numbered.instanceCount(), kMostInstances);
  EXPECT_GT(numbered.instanceCount(), 6000u);
  EXPECT_EQ(numbered.triangleCount, 72000u);
}

TEST(Numbering, MoreInstancesThanAReferenceCanNameAreRefused) {
  Scene scene = emptyScene();
  const uint32_t mesh = addMesh(scene, meshOf({triangleOfSize(1.0f)}));
  for (uint32_t i = 0; i < kMostInstances; ++i) placeMesh(scene, mesh);
  EXPECT_EQ(numberScene(scene, NumberBy::file).instanceCount(), kMostInstances);
  placeMesh(scene, mesh);
  EXPECT_THROW(numberScene(scene, NumberBy::file), Error);
  EXPECT_THROW(numberScene(scene, NumberBy::area), Error);
}

TEST(Numbering, MoreTrianglesThanMemoryIsReasonableForAreRefusedBeforeTheyAreMade) {
  Scene scene = emptyScene();
  const uint32_t mesh = addMesh(scene, meshOf(std::vector<Triangle>(2000, triangleOfSize(1.0f))));
  for (uint32_t i = 0; i < 60000; ++i) placeMesh(scene, mesh);
  EXPECT_THROW(numberScene(scene, NumberBy::file), Error);
}

TEST(Numbering, TransformsOfTimeZeroAreSetAlreadyAndOnlyWhatMovesIsReported) {
  const Scene scene = movingScene();
  NumberedScene numbered = numberScene(scene, NumberBy::file);
  EXPECT_TRUE(setTransforms(numbered, scene, 0.0f).empty());
  EXPECT_EQ(setTransforms(numbered, scene, 0.5f), std::vector<uint32_t>{1});
  EXPECT_EQ(numbered.instances[1].row0, vec4(1.0f, 0.0f, 0.0f, 0.5f));
  EXPECT_EQ(numbered.instances[2].row0, vec4(1.0f, 0.0f, 0.0f, 5.0f));
  EXPECT_TRUE(setTransforms(numbered, scene, 0.5f).empty());
}

TEST(Numbering, RowsHoldNoNegativeZeroAndNoDenormal) {
  Scene scene = sceneOf({triangleOfSize(1.0f)});
  scene.nodes[0].scale = vec3(-1.0f, 1e-39f, 1.0f);
  scene.nodes[0].translation = vec3(-0.0f, 0.0f, 2.0f);
  const NumberedScene numbered = numberScene(scene, NumberBy::file);
  for (const vec4& row : {numbered.instances[0].row0, numbered.instances[0].row1, numbered.instances[0].row2})
    for (int i = 0; i < 4; ++i) {
      EXPECT_NE(floatBitsToUint(row[i]), 0x80000000u);
      EXPECT_TRUE(row[i] == 0.0f || std::abs(row[i]) >= kTiny);
    }
  EXPECT_EQ(numbered.instances[0].row0.x, -1.0f);
}

TEST(Numbering, ATransformThatIsNotFiniteIsRefusedWithTheNodesName) {
  Scene scene = sceneOf({triangleOfSize(1.0f)});
  scene.nodes[0].scale.y = INFINITY;
  try {
    numberScene(scene, NumberBy::file);
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("node 0"), std::string::npos) << error.what();
  }
}

TEST(Numbering, TheAlphaThresholdIsTheSmallestByteThatReachesTheCutoff) {
  EXPECT_EQ(numberScene(keyedScene(AlphaMode::mask, 1.0f, 0.5f), NumberBy::file).materials[0].alphaThreshold, 128u);
  EXPECT_EQ(numberScene(keyedScene(AlphaMode::mask, 0.8f, 0.5f), NumberBy::file).materials[0].alphaThreshold, 160u);
  EXPECT_EQ(numberScene(keyedScene(AlphaMode::mask, 1.0f, 0.0f), NumberBy::file).materials[0].alphaThreshold, 0u);
  EXPECT_EQ(numberScene(keyedScene(AlphaMode::mask, 1.0f, 1.0f), NumberBy::file).materials[0].alphaThreshold, 255u);
  EXPECT_EQ(numberScene(keyedScene(AlphaMode::mask, 0.4f, 0.5f), NumberBy::file).materials[0].alphaThreshold, 256u);
  EXPECT_EQ(numberScene(keyedScene(AlphaMode::blend, 1.0f, 0.9f), NumberBy::file).materials[0].alphaThreshold, 128u);
}

TEST(Numbering, WithoutAnImageTheBaseColourAloneDecides) {
  const TraceMaterial passes = numberScene(keyedScene(AlphaMode::mask, 0.6f, 0.5f, false), NumberBy::file).materials[0];
  EXPECT_EQ(passes.alphaWidth, 0u);
  EXPECT_EQ(passes.alphaThreshold, 0u);
  EXPECT_EQ(passes.layer, kNoLayer);
  EXPECT_EQ(numberScene(keyedScene(AlphaMode::mask, 0.4f, 0.5f, false), NumberBy::file).materials[0].alphaThreshold, 256u);
}

TEST(Numbering, AnOpaqueMaterialIsNotKeyedAndNeedsNoAlphaMap) {
  const NumberedScene numbered = numberScene(keyedScene(AlphaMode::opaque, 0.1f, 0.5f), NumberBy::file);
  EXPECT_EQ(numbered.materials[0].flags & kMaterialAlphaKeyed, 0u);
  EXPECT_EQ(numbered.materials[0].layer, 0u);
  EXPECT_TRUE(numbered.alphaBytes.empty());
}

TEST(Numbering, MaterialsOfOneImageShareItsAlphaMapAndOthersFollowBehind) {
  Scene scene = keyedScene(AlphaMode::mask, 1.0f, 0.5f);
  scene.images.push_back({"other", 1, 3, {0, 0, 0, 7, 0, 0, 0, 8, 0, 0, 0, 9}});
  scene.materials.push_back(scene.materials[0]);
  scene.materials.push_back(scene.materials[0]);
  scene.materials[2].imageIndex = 1;
  const NumberedScene numbered = numberScene(scene, NumberBy::file);
  EXPECT_EQ(numbered.materials[0].alphaFirstByte, 0u);
  EXPECT_EQ(numbered.materials[1].alphaFirstByte, 0u);
  EXPECT_EQ(numbered.materials[2].alphaFirstByte, 2u);
  EXPECT_EQ(numbered.materials[2].alphaHeight, 3u);
  EXPECT_EQ(numbered.alphaBytes, (std::vector<uint32_t>{10u | 200u << 8 | 7u << 16 | 8u << 24, 9u}));
}

TEST(Numbering, CornersCarryTextureCoordinatesAndClampedColours) {
  Scene scene = sceneOf({triangleOfSize(1.0f)});
  scene.meshes[0].uvs = {vec2(0.25f, -3.0f), vec2(0.0f), vec2(1.0f)};
  scene.meshes[0].colours = {vec4(2.0f, 0.0f, -1.0f, 1.0f), vec4(0.5f), vec4(1.0f)};
  const NumberedScene numbered = numberScene(scene, NumberBy::file);
  EXPECT_EQ(numbered.corners[0].uv, vec2(0.25f, -3.0f));
  EXPECT_EQ(numbered.corners[0].colour, 0xFF0000FFu);
  EXPECT_EQ(numbered.corners[1].colour, 0x80808080u);
}

}  // namespace
}  // namespace gridscope
