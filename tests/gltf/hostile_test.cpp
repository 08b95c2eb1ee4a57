// The glTF loader on damaged and hostile files: each becomes an Error of one line, and nothing else.
#include "core/gltf/gltf.h"

#include <cmath>
#include <cstring>

#include "tests/gltf/file.h"

namespace gridscope {
namespace {

TEST(GltfHostile, ARequiredExtensionIsRefusedByName) {
  GltfFile file = oneTriangle();
  file.document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  expectContains(refusal(file), "KHR_draco_mesh_compression");

  GltfFile compressed = oneTriangle();
  compressed.document["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  EXPECT_EQ(load(compressed).meshes.size(), 1u) << "there is a plain copy";
  compressed.document["accessors"][0].erase("bufferView");
  expectContains(refusal(compressed), "mesh 'thing' is compressed with KHR_draco_mesh_compression");
}

TEST(GltfHostile, ASceneWithoutTrianglesIsRefused) {
  GltfFile empty;
  expectContains(refusal(empty), "holds no triangles");
  GltfFile points = oneTriangle();
  points.document["meshes"][0]["primitives"][0]["mode"] = 0;
  expectContains(refusal(points), "holds no triangles");
}

TEST(GltfHostile, IndicesBeyondTheVerticesAreRefused) {
  GltfFile file = indexedSquare();
  file.document["accessors"][0]["count"] = 3;
  expectContains(refusal(file), "mesh 'thing': index 3 is beyond its 3 vertices");
}

TEST(GltfHostile, PositionsThatAreNotFiniteOrTooFarOutAreRefused) {
  GltfFile file;
  file.addMesh({{"POSITION", file.addVec3({0, 0, 0, INFINITY, 0, 0, 0, 1, 0})}});
  expectContains(refusal(file), "mesh 'thing': vertex 1 is not a finite position");

  GltfFile far = oneTriangle();
  far.document["nodes"][0]["scale"] = {2e6, 1, 1};
  expectContains(refusal(far), "beyond 1,000,000 units");
}

// Each replaces one value of a good file, at a JSON pointer, and says what the message must hold.
struct HostileValue {
  const char* place;
  json value;
  const char* message;
};

TEST(GltfHostile, HostileValuesAreRefusedWithTheirPlace) {
  const std::vector<HostileValue> cases = {
      {"/asset/version", "1.0", "glTF 1.0"},
      {"/asset", 3, "asset is not an object"},
      {"/scene", 0, "there are only 0 scenes"},
      {"/nodes/0/mesh", 7, "nodes[0].mesh is 7, but there are only 1 meshes"},
      {"/nodes/0/mesh", -1, "nodes[0].mesh is not a whole number"},
      {"/nodes/0/mesh", "0", "nodes[0].mesh is not a whole number"},
      {"/nodes/0/children", {0}, "node 0 is its own ancestor"},
      {"/nodes/0/children", {5}, "nodes[0].children[0] is 5"},
      {"/nodes/0/scale", {1, 1}, "has 2 numbers instead of 3"},
      {"/nodes/0/scale", {1, 1, 1e300}, "too large for a float"},
      {"/nodes/0/matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "matrix with perspective"},
      {"/nodes/0/camera", 0, "there are only 0 cameras"},
      {"/nodes", json::object(), "nodes is not an array"},
      {"/meshes/0/primitives", 1, "meshes[0].primitives is not an array"},
      {"/meshes/0/primitives/0/attributes/POSITION", 9, "meshes[0].primitives[0].attributes.POSITION is 9"},
      {"/meshes/0/primitives/0/attributes/POSITION", 1, "POSITION is not a VEC3"},
      {"/meshes/0/primitives/0/attributes/NORMAL", 1, "NORMAL has the wrong number of components"},
      {"/meshes/0/primitives/0/indices", 0, "indices are not unsigned integers"},
      {"/meshes/0/primitives/0/material", 0, "there are only 0 materials"},
      {"/accessors/0/count", 5, "accessor 0: its data ends at byte 60 of a buffer view of 48 bytes"},
      {"/accessors/0/count", 0, "accessor 0: it holds nothing"},
      {"/accessors/0/count", 4294967295u, "absurdly large"},
      {"/accessors/0/count", 1e30, "absurdly large"},
      {"/accessors/0/count", 1073741824, "its data ends at byte"},
      {"/accessors/0/byteOffset", 1073741824, "its data ends at byte"},
      {"/accessors/0/byteOffset", 18446744073709551615u, "absurdly large"},
      {"/accessors/0/componentType", 5130, "type or componentType is unknown"},
      {"/accessors/0/componentType", 5127, "type or componentType is unknown"},
      {"/accessors/0/type", "VEC5", "type or componentType is unknown"},
      {"/accessors/1/type", "MAT4", "its data ends at byte"},
      {"/bufferViews/0/byteLength", 1000, "buffer view 0 ends at byte 1000 of a buffer of 60 bytes"},
      {"/bufferViews/0/byteLength", 0, "buffer view 0 has no bytes"},
      {"/bufferViews/0/byteOffset", 1073741824, "buffer view 0 ends at byte"},
      {"/bufferViews/0/byteStride", 4, "elements of 12 bytes overlap in a stride of 4"},
      {"/bufferViews/0/byteStride", 100000, "above 252"},
      {"/bufferViews/0/buffer", 1, "there are only 1 buffers"},
      {"/buffers/0/byteLength", 1000, "buffer 0: it has 60 bytes instead of 1000"},
      {"/buffers/0/byteLength", 18446744073709551615u, "absurdly large"},
      {"/buffers/0/uri", "/etc/passwd", "outside the file's own folder"},
      {"/buffers/0/uri", "..%2Fsecret.bin", "outside the file's own folder"},
      {"/buffers/0/uri", "a/..\\..\\secret.bin", "outside the file's own folder"},
      {"/buffers/0/uri", "http://example.com/a.bin", "outside the file's own folder"},
      {"/buffers/0/uri", "nothing.bin", "there is no such file"},
      {"/buffers/0/uri", "data:;base64,????", "not base64"},
      {"/buffers/0/uri", "data:AAAA", "not base64"},
      {"/cameras", {{{"type", "perspective"}}}, "camera"},
      {"/animations",
       {{{"channels", {{{"sampler", 4}, {"target", {{"node", 0}, {"path", "scale"}}}}}}, {"samplers", json::array()}}},
       "sampler is out of range"},
      {"/animations",
       {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}}}, {"samplers", {{{"input", 0}, {"output", 0}}}}}},
       "key times are not floats"},
      {"/extensionsRequired", {"A", "B\nC"}, "it requires A, B C"},
  };
  for (const HostileValue& hostile : cases) {
    GltfFile file = indexedSquare();
    file.document["buffers"] = {{{"byteLength", file.binary.size()},
                                 {"uri",
                                  "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAA"
                                  "gD8AAAAAAAABAAIAAgABAAMA"}}};
    EXPECT_EQ(load(file.document.dump()).meshes.at(0).triangleCount(), 2u);
    file.document[json::json_pointer(hostile.place)] = hostile.value;
    SCOPED_TRACE(std::string(hostile.place) + " = " + hostile.value.dump());
    expectContains(refusal(file.document.dump(), ::testing::TempDir()), hostile.message);
  }
}

TEST(GltfHostile, NodesThatAreNoTreeAreRefused) {
  GltfFile file = oneTriangle();
  file.document["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {3}}}, {{"children", {1}}}};
  expectContains(refusal(file), "is its own ancestor");
  file.document["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
  expectContains(refusal(file), "node 2 is a child of node 0 and of node 1");
  file.document["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
  file.document["scenes"] = {{{"nodes", {0, 1}}}};
  expectContains(refusal(file), "a scene lists node 1, which is a child of node 0");
}

TEST(GltfHostile, SparseIndicesMustRiseAndStayInRange) {
  for (const std::vector<uint8_t>& indices : {std::vector<uint8_t>{2, 1}, std::vector<uint8_t>{1, 1}, std::vector<uint8_t>{1, 3}}) {
    GltfFile file = oneTriangle();
    const int view = file.addView(indices), values = file.addView<float>({5, 0, 0, 0, 7, 0});
    file.document["accessors"][0]["sparse"] = {
        {"count", 2}, {"indices", {{"bufferView", view}, {"componentType", kUnsignedByte}}}, {"values", {{"bufferView", values}}}};
    expectContains(refusal(file), "sparse indices");
  }
}

TEST(GltfHostile, AFewBytesCannotUnfoldToManyTrianglesOrInstances) {
  // A count that no byte stands behind.
  GltfFile zeros = oneTriangle();
  zeros.document["accessors"][0].erase("bufferView");
  zeros.document["accessors"][0]["count"] = 900'000'000;
  expectContains(refusal(zeros), "more triangles than a file of this size can hold");

  // The same indices, named by many primitives.
  GltfFile shared;
  const int positions = shared.addVec3(kCorner);
  const int indices = shared.add(std::vector<uint8_t>(30'000, 0), "SCALAR", kUnsignedByte, 30'000);
  json& primitive = shared.addMesh({{"POSITION", positions}});
  primitive["indices"] = indices;
  const json copy = primitive;
  for (int i = 0; i < 1000; ++i) shared.document["meshes"][0]["primitives"].push_back(copy);
  expectContains(refusal(shared), "more triangles than a file of this size can hold");

  // A mesh of many primitives on many nodes.
  GltfFile placed = oneTriangle();
  json& primitives = placed.document["meshes"][0]["primitives"];
  for (int i = 0; i < 299; ++i) primitives.push_back(json(primitives[0]));
  for (int i = 0; i < 299; ++i) placed.document["nodes"].push_back({{"mesh", 0}});
  expectContains(refusal(placed), "more than 65535 meshes");

  GltfFile instanced = oneTriangle();
  instanced.document["accessors"].push_back({{"componentType", kFloat}, {"count", 1'000'000}, {"type", "VEC3"}});
  instanced.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 1;
  expectContains(refusal(instanced), "more than 65535");
}

TEST(GltfHostile, DeepOrBrokenJsonIsRefused) {
  expectContains(refusal(std::string("")), "empty");
  expectContains(refusal(std::string("{\"asset\"")), "damaged");
  expectContains(refusal(std::string("[1, 2]")), "not a glTF document");
  expectContains(refusal(std::string("\xFF\xFE{}")), "damaged");
  expectContains(refusal("{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(1'000'000, '[')), "nested");
  expectContains(refusal("{\"asset\":{\"version\":\"2.0\",\"minVersion\":\"2.1\"}}"), "glTF 2.1");
}

TEST(GltfHostile, AnimationsMustHaveRisingTimesAndAsManyValues) {
  GltfFile file = oneTriangle();
  const int rising = file.add<float>({0, 1}, "SCALAR", kFloat, 2), falling = file.add<float>({1, 0}, "SCALAR", kFloat, 2);
  const int values = file.addVec3({0, 0, 0, 1, 0, 0, 2, 0, 0});
  const auto animate = [&](int input, const char* interpolation) {
    file.document["animations"] = {{{"samplers", {{{"input", input}, {"output", values}, {"interpolation", interpolation}}}},
                                    {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  };
  animate(rising, "LINEAR");
  expectContains(refusal(file), "animation 'animation 0': it has 3 values instead of 2");
  animate(rising, "CUBICSPLINE");
  expectContains(refusal(file), "it has 3 values instead of 6");
  animate(falling, "LINEAR");
  expectContains(refusal(file), "key times do not rise");
  animate(rising, "WOBBLY");
  expectContains(refusal(file), "interpolation 'WOBBLY' is unknown");
}

// Each in an allocation of its own size, so that the address sanitizer sees a read beyond it.
TEST(GltfHostile, EveryTruncationIsRefusedOrLoaded) {
  const std::string whole = texturedSquare(pngBytes(2, 2, std::vector<uint8_t>(16, 200))).glb();
  for (size_t size = 0; size < whole.size(); ++size) {
    const auto* bytes = reinterpret_cast<const std::byte*>(whole.data());
    const std::vector<std::byte> cut(bytes, bytes + size);
    EXPECT_THROW(loadGltfMemory(cut, "cut.glb", {}), Error) << size;
  }
}

TEST(GltfHostile, ChunkLengthsBeyondTheFileAreRefused) {
  std::string bytes = oneTriangle().glb();
  const uint32_t huge = 0xFFFFFFF0;
  std::string jsonLength = bytes;
  std::memcpy(&jsonLength[12], &huge, 4);
  expectContains(refusal(jsonLength), "the JSON chunk ends");
  std::string fileLength = bytes;
  std::memcpy(&fileLength[8], &huge, 4);
  expectContains(refusal(fileLength), "the file ends");
  std::string version = bytes;
  version[4] = 1;
  expectContains(refusal(version), "version 1");
}

}  // namespace
}  // namespace gridscope
