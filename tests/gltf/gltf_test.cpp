// The glTF loader on well-made files: what they become, and what is said of what can't be shown.
#include "core/gltf/gltf.h"

#include <cmath>
#include <fstream>

#include "tests/gltf/file.h"

namespace gridscope {
namespace {

TEST(Gltf, TriangleWithoutIndicesKeepsItsCornersAndGetsAFlatNormal) {
  const Scene scene = load(oneTriangle());
  EXPECT_EQ(cornersOf(scene), (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(scene.meshes[0].normals, std::vector<vec3>(3, vec3(0, 0, 1)));
  EXPECT_EQ(scene.name, "made.glb");
  EXPECT_EQ(scene.meshes[0].name, "thing");
  EXPECT_EQ(scene.materials.size(), 1u);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(Gltf, IndicesOfEveryWidthAreRead) {
  for (int type : {kUnsignedByte, kUnsignedShort, kUnsignedInt}) {
    GltfFile file;
    const int positions = file.addVec3(kSquare);
    const int indices = type == kUnsignedByte    ? file.add<uint8_t>({3, 1, 2}, "SCALAR", type, 3)
                        : type == kUnsignedShort ? file.add<uint16_t>({3, 1, 2}, "SCALAR", type, 3)
                                                 : file.add<uint32_t>({3, 1, 2}, "SCALAR", type, 3);
    file.addMesh({{"POSITION", positions}})["indices"] = indices;
    EXPECT_EQ(cornersOf(load(file)), (std::vector<vec3>{{1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));
  }
}

TEST(Gltf, StripsAndFansKeepTheFrontWhereTheSpecificationPutsIt) {
  GltfFile strip = oneTriangle();
  strip.document["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", strip.addVec3(kSquare)}}}, {"mode", 5}};
  EXPECT_EQ(cornersOf(load(strip)), (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));

  GltfFile fan = oneTriangle();
  const std::vector<float> round = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  fan.document["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", fan.addVec3(round)}}}, {"mode", 6}};
  EXPECT_EQ(cornersOf(load(fan)), (std::vector<vec3>{{1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}));
}

TEST(Gltf, InterleavedAttributesAreReadWithTheirStride) {
  GltfFile file;
  const int view = file.addView<float>({0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0, 2, 0, 1, 0, 0, 0, 2});
  file.document["bufferViews"][0]["byteStride"] = 24;
  for (int offset : {0, 12})
    file.document["accessors"].push_back(
        {{"bufferView", view}, {"byteOffset", offset}, {"componentType", kFloat}, {"count", 3}, {"type", "VEC3"}});
  file.addMesh({{"POSITION", 0}, {"NORMAL", 1}});
  const Scene scene = load(file);
  EXPECT_EQ(cornersOf(scene), (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(scene.meshes[0].normals[2], vec3(0, 0, 1)) << "normals are made unit";
}

TEST(Gltf, SparseValuesReplaceThoseOfTheBufferOrZero) {
  for (bool withBase : {true, false}) {
    GltfFile file = oneTriangle();
    const int indices = file.addView<uint8_t>({1, 2}), values = file.addView<float>({5, 0, 0, 0, 7, 0});
    json& accessor = file.document["accessors"][0];
    accessor["sparse"] = {
        {"count", 2}, {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}}, {"values", {{"bufferView", values}}}};
    if (!withBase) accessor.erase("bufferView");
    EXPECT_EQ(cornersOf(load(file)), (std::vector<vec3>{{0, 0, 0}, {5, 0, 0}, {0, 7, 0}}));
  }
}

TEST(Gltf, NormalisedIntegersBecomeFractions) {
  GltfFile file;
  const int positions = file.addVec3(kCorner);
  const int colours = file.add<uint8_t>({255, 0, 51, 0, 255, 0, 0, 0, 0, 0, 0, 0}, "VEC3", kUnsignedByte, 3);
  file.document["accessors"][1]["normalized"] = true;
  file.document["bufferViews"][1]["byteStride"] = 4;
  const int normals = file.add<int8_t>({0, 127, 0, 0, 0, 127, 0, 0, 0, 0, -128, 0}, "VEC3", kByte, 3);
  file.document["accessors"][2]["normalized"] = true;
  file.document["bufferViews"][2]["byteStride"] = 4;
  file.addMesh({{"POSITION", positions}, {"COLOR_0", colours}, {"NORMAL", normals}});
  const Mesh mesh = load(file).meshes.at(0);
  EXPECT_EQ(mesh.colours.at(0), vec4(1.0f, 0.0f, 0.2f, 1.0f));
  EXPECT_EQ(mesh.normals, (std::vector<vec3>{{0, 1, 0}, {0, 1, 0}, {0, 0, -1}}));
}

TEST(Gltf, UnusableNormalsAreReplacedByTheGeometricOne) {
  GltfFile file;
  const int positions = file.addVec3(kCorner);
  const int normals = file.addVec3({NAN, 0, 0, 0, 0, 0, 0, 1, 0});
  file.addMesh({{"POSITION", positions}, {"NORMAL", normals}});
  EXPECT_EQ(load(file).meshes.at(0).normals, (std::vector<vec3>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
}

TEST(Gltf, TrianglesWithoutAreaAreKept) {
  GltfFile file;
  file.addMesh({{"POSITION", file.addVec3({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0})}});
  const Mesh mesh = load(file).meshes.at(0);
  ASSERT_EQ(mesh.triangleCount(), 2u);
  EXPECT_EQ(mesh.normals[0], vec3(0, 1, 0));
}

TEST(Gltf, NodesOfAnyDepthMultiplyMirroredOnesToo) {
  GltfFile file = oneTriangle();
  file.document["nodes"] = json::array();
  for (int i = 0; i < 100; ++i) file.document["nodes"].push_back({{"translation", {1, 0, 0}}, {"children", {i + 1}}});
  file.document["nodes"].push_back({{"scale", {-2, 1, 1}}, {"children", {101}}});
  file.document["nodes"].push_back({{"mesh", 0}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1}}});
  const Scene scene = load(file);
  const SceneInstance& instance = scene.instances.at(0);
  const mat4 world = nodeTransforms(scene, 0.0f)[instance.node] * instance.local;
  EXPECT_EQ(world * vec4(1, 0, 0, 1), vec4(100, 1, 5, 1));
  EXPECT_EQ(world * vec4(0, 1, 0, 1), vec4(102, 0, 5, 1));
  EXPECT_LT(glm::determinant(world), 0.0f);
}

TEST(Gltf, OneMeshOnTwoNodesIsOneMeshAndTwoInstances) {
  GltfFile file = oneTriangle();
  file.document["nodes"] = {{{"mesh", 0}, {"name", "left"}}, {{"mesh", 0}, {"name", "right"}, {"translation", {2, 0, 0}}}};
  const Scene scene = load(file);
  EXPECT_EQ(scene.meshes.size(), 1u);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[1].name, "right");
  EXPECT_FLOAT_EQ(sceneBounds(scene).high.x, 3.0f);
}

TEST(Gltf, PrimitivesOfOneMeshAreNamedByTheirMaterial) {
  GltfFile file = oneTriangle();
  json& primitives = file.document["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives[0]["material"] = 0;
  file.document["materials"] = {{{"name", "brass"}}};
  const Scene scene = load(file);
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.meshes[0].name, "thing/brass");
  EXPECT_EQ(scene.meshes[1].name, "thing/default");
  EXPECT_EQ(scene.instances.size(), 2u);
}

TEST(Gltf, OnlyTheDefaultSceneIsLoaded) {
  GltfFile file = oneTriangle();
  file.document["nodes"].push_back({{"mesh", 0}, {"name", "other"}});
  file.document["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  EXPECT_EQ(load(file).instances.at(0).name, "node 0");
  file.document["scene"] = 1;
  EXPECT_EQ(load(file).instances.at(0).name, "other");
  file.document.erase("scene");
  file.document.erase("scenes");
  EXPECT_EQ(load(file).instances.size(), 2u);
}

TEST(Gltf, GpuInstancingPlacesTheMeshManyTimes) {
  GltfFile file = oneTriangle();
  const int translations = file.addVec3({0, 0, 0, 10, 0, 0}), scales = file.addVec3({1, 1, 1, 3, 3, 3});
  file.document["nodes"][0]["translation"] = {0, 5, 0};
  file.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", translations}, {"SCALE", scales}};
  file.document["extensionsRequired"] = file.document["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  const Scene scene = load(file);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[1].name, "node 0[1]");
  EXPECT_EQ(sceneBounds(scene).high, vec3(13, 8, 0));
}

TEST(Gltf, CamerasStandWhereTheirNodesDo) {
  GltfFile file = oneTriangle();
  file.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}},
                              {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 9}}}}};
  file.document["nodes"].push_back({{"camera", 0}, {"name", "eye"}, {"translation", {0, 0, 4}}});
  file.document["nodes"].push_back({{"camera", 1}});
  const Scene scene = load(file);
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_EQ(scene.cameras[0].name, "eye");
  EXPECT_EQ(scene.cameras[0].eye, vec3(0, 0, 4));
  EXPECT_EQ(glm::normalize(scene.cameras[0].target - scene.cameras[0].eye), vec3(0, 0, -1));
  EXPECT_NEAR(scene.cameras[0].verticalFovDegrees, 28.65f, 0.01f);
  ASSERT_EQ(scene.warnings.size(), 1u);
  expectContains(scene.warnings[0], "made.glb: orthographic cameras");
}

TEST(Gltf, AMeshUnderAMovedNodeIsDynamicUnlessItsKeysAreAllAlike) {
  for (float end : {3.0f, 0.0f}) {
    GltfFile file = oneTriangle();
    file.document["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
    const int times = file.add<float>({0, 2}, "SCALAR", kFloat, 2), values = file.addVec3({0, 0, 0, end, 0, 0});
    file.document["animations"] = {{{"name", "slide"},
                                    {"samplers", {{{"input", times}, {"output", values}}}},
                                    {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    const Scene scene = load(file);
    EXPECT_EQ(scene.instances.at(0).dynamic, end != 0.0f);
    ASSERT_EQ(scene.animations.size(), 1u);
    EXPECT_EQ(scene.animations[0].duration, 2.0f);
    EXPECT_NEAR(sceneBounds(scene).high.x, 1.0f + end, 1e-4f);
  }
}

TEST(Gltf, MaterialsAreReadAsTheFileSays) {
  GltfFile file = oneTriangle();
  file.document["meshes"][0]["primitives"][0]["material"] = 0;
  file.document["materials"] = {{{"name", "leaf"},
                                 {"alphaMode", "MASK"},
                                 {"alphaCutoff", 0.25},
                                 {"doubleSided", true},
                                 {"extensions", {{"KHR_materials_unlit", json::object()}}},
                                 {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 2.0, 1}}, {"roughnessFactor", 0.75}}}}};
  const Material material = load(file).materials.at(0);
  EXPECT_EQ(material.name, "leaf");
  EXPECT_EQ(material.alphaMode, AlphaMode::mask);
  EXPECT_EQ(material.alphaCutoff, 0.25f);
  EXPECT_TRUE(material.doubleSided && material.unlit);
  EXPECT_EQ(material.baseColour, vec4(0.5f, 0.25f, 1.0f, 1.0f));
  EXPECT_EQ(material.metallic, 1.0f) << "the specification's default";
  EXPECT_EQ(material.roughness, 0.75f);
}

TEST(Gltf, AnEmbeddedImageIsDecodedWithItsFirstRowOnTop) {
  GltfFile file = texturedSquare(pngBytes(1, 2, {255, 0, 0, 255, 0, 0, 255, 128}));
  file.document["textures"][0]["sampler"] = 0;
  file.document["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
  const Scene scene = load(file);
  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.images[0].rgba, (std::vector<uint8_t>{255, 0, 0, 255, 0, 0, 255, 128}));
  EXPECT_EQ(scene.materials[0].imageIndex, 0);
  EXPECT_EQ(scene.materials[0].wrapU, WrapMode::clamp);
  EXPECT_EQ(scene.materials[0].wrapV, WrapMode::mirror);
  EXPECT_EQ(scene.meshes[0].uvs.at(1), vec2(1, 0));
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(Gltf, TextureTransformIsBakedIntoTheCoordinates) {
  GltfFile file = texturedSquare(pngBytes(1, 1, {1, 2, 3, 255}));
  json& texture = file.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  texture["extensions"]["KHR_texture_transform"] = {{"offset", {0.5, 0.25}}, {"rotation", 1.5707963267948966}, {"scale", {2, 3}}};
  const std::vector<vec2> uvs = load(file).meshes.at(0).uvs;
  // u goes up in the image (v falls), v goes along u.
  EXPECT_NEAR(uvs.at(1).x, 0.5f, 1e-6f);
  EXPECT_NEAR(uvs.at(1).y, -1.75f, 1e-6f);
  EXPECT_NEAR(uvs.at(2).x, 3.5f, 1e-6f);
  EXPECT_NEAR(uvs.at(2).y, 0.25f, 1e-6f);
}

TEST(Gltf, ATextureThatCannotBeReadBecomesACheckerWithAWarning) {
  std::string huge = pngBytes(1, 1, {1, 2, 3, 255});
  huge[16] = 0, huge[17] = 1, huge[18] = 0, huge[19] = 0;  // 65,536 pixels wide, says the header
  std::string bomb = pngBytes(1, 1, {1, 2, 3, 255});
  bomb[18] = 31, bomb[22] = 31;  // 7,937 x 7,937
  const std::string whole = pngBytes(64, 64, std::vector<uint8_t>(64 * 64 * 4, 77));
  for (const std::string& bytes : {huge, bomb, whole.substr(0, 60), std::string("no image"), std::string("\xABKTX 20\xBB and more")}) {
    const Scene scene = load(texturedSquare(bytes));
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].rgba.size(), 64u * 64u * 4u);
    EXPECT_EQ(scene.images[0].rgba[0], 255) << "magenta";
    ASSERT_EQ(scene.warnings.size(), 1u);
    expectContains(scene.warnings[0], "'picture'");
  }
}

TEST(Gltf, FilesBesideTheSceneAreFoundByTheirPercentEncodedName) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "gltf folder";
  std::filesystem::create_directories(folder);
  GltfFile file = oneTriangle();
  std::ofstream(folder / "caf\xC3\xA9 1.bin", std::ios::binary) << file.binary;
  file.document["buffers"] = {{{"byteLength", file.binary.size()}, {"uri", "caf%C3%A9%201.bin"}}};
  std::ofstream(folder / "scene.gltf") << file.document.dump();
  const Scene scene = loadGltf(folder / "scene.gltf");
  EXPECT_EQ(scene.meshes.at(0).triangleCount(), 1u);
  EXPECT_EQ(scene.name, "scene.gltf");
  std::filesystem::remove_all(folder);
}

TEST(Gltf, AFileThatIsNotThereIsRefusedByName) {
  for (const char* name : {"/nowhere/at all.glb", "/"}) {
    try {
      loadGltf(name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(std::string(name) + ": ")) << error.what();
    }
  }
}

TEST(Gltf, WhatCannotBeShownIsNamedOnce) {
  GltfFile file = oneTriangle();
  json& primitives = file.document["meshes"][0]["primitives"];
  for (int mode : {0, 1, 2, 3}) primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
  primitives[0]["targets"] = {{{"POSITION", 0}}};
  file.document["nodes"][0]["skin"] = 0;
  file.document["skins"] = {{{"joints", {0}}}};
  file.document["extensionsUsed"] = {"KHR_lights_punctual"};
  const Scene scene = load(file);
  EXPECT_EQ(scene.meshes.size(), 1u);
  ASSERT_EQ(scene.warnings.size(), 4u);
  std::string all;
  for (const std::string& warning : scene.warnings) all += warning + '\n';
  for (const char* part : {"morph targets", "skins", "points and lines", "KHR_lights_punctual"}) expectContains(all, part);
}

}  // namespace
}  // namespace gridscope
