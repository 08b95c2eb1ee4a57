// Part of the guard, see ranges.h. No sum or product here can overflow: the shape limits every count to 2^30, a stride is at
// most 252, and all is done in 64 bits.
#include "core/gltf/ranges.h"

#include <cstring>
#include <map>
#include <string>

#include "core/base/error.h"

namespace gridscope {

using nlohmann::json;

namespace {

constexpr uint64_t kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125;

uint64_t componentCount(const std::string& type) {
  static const std::map<std::string, uint64_t> counts = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                         {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
  const auto found = counts.find(type);
  return found == counts.end() ? 0 : found->second;
}

uint64_t numberOr(const json& object, const char* key, uint64_t otherwise) { return object.value(key, otherwise); }

// A run of `count` elements in a view must end inside it.
void checkRun(const json& view, uint64_t offset, uint64_t count, uint64_t stride, uint64_t elementBytes) {
  const uint64_t end = offset + (count - 1) * stride + elementBytes;
  const uint64_t length = view["byteLength"];
  if (end > length)
    throw Error("its data ends at byte " + std::to_string(end) + " of a buffer view of " + std::to_string(length) +
                " bytes; export the file again");
}

// Sparse indices must rise, so that a search finds them, and stay below the accessor's count.
void checkSparseIndices(const unsigned char* data, uint64_t bytes, uint64_t sparseCount, uint64_t count) {
  int64_t last = -1;
  for (uint64_t i = 0; i < sparseCount; ++i) {
    uint32_t index = 0;
    std::memcpy(&index, data + i * bytes, bytes);
    if (index <= last || index >= count) throw Error("its sparse indices do not rise, or are out of range; export the file again");
    last = index;
  }
}

class RangeChecker {
 public:
  RangeChecker(const json& document, const std::vector<Bytes>& buffers)
      : views_(document.value("bufferViews", json::array())), buffers_(buffers) {}

  void checkViews(const json& document) const {
    for (size_t i = 0; i < views_.size(); ++i) {
      const json& view = views_[i];
      const uint64_t offset = numberOr(view, "byteOffset", 0), length = view["byteLength"];
      const uint64_t stride = numberOr(view, "byteStride", 0);
      const uint64_t held = document["buffers"][view["buffer"].get<size_t>()]["byteLength"];
      const std::string name = "buffer view " + std::to_string(i);
      if (length == 0) throw Error(name + " has no bytes; export the file again");
      if (offset + length > held)
        throw Error(name + " ends at byte " + std::to_string(offset + length) + " of a buffer of " + std::to_string(held) +
                    " bytes; export the file again");
      if (stride > 252) throw Error(name + " has a stride of " + std::to_string(stride) + " bytes, above 252; export the file again");
    }
  }

  void checkAccessor(const json& accessor) const {
    const uint64_t bytes = gltfComponentBytes(accessor["componentType"]);
    const uint64_t elementBytes = bytes * componentCount(accessor["type"]);
    const uint64_t count = accessor["count"];
    if (elementBytes == 0) throw Error("its type or componentType is unknown; export the file again");
    if (count == 0) throw Error("it holds nothing; export the file again");
    if (accessor.contains("bufferView")) {
      const json& view = views_[accessor["bufferView"].get<size_t>()];
      const uint64_t stride = numberOr(view, "byteStride", 0);
      if (stride != 0 && stride < elementBytes)
        throw Error("its elements of " + std::to_string(elementBytes) + " bytes overlap in a stride of " + std::to_string(stride) +
                    "; export the file again");
      checkRun(view, numberOr(accessor, "byteOffset", 0), count, stride ? stride : elementBytes, elementBytes);
    }
    if (accessor.contains("sparse")) checkSparse(accessor["sparse"], elementBytes, count);
  }

 private:
  void checkSparse(const json& sparse, uint64_t elementBytes, uint64_t count) const {
    const json &indices = sparse["indices"], &values = sparse["values"];
    const uint64_t sparseCount = sparse["count"], type = indices["componentType"];
    if (sparseCount == 0 || sparseCount > count) throw Error("its sparse count is out of range; export the file again");
    if (type != kUnsignedByte && type != kUnsignedShort && type != kUnsignedInt)
      throw Error("its sparse indices are not unsigned integers; export the file again");

    const uint64_t indexBytes = gltfComponentBytes(type), offset = numberOr(indices, "byteOffset", 0);
    const json& indexView = views_[indices["bufferView"].get<size_t>()];
    checkRun(indexView, offset, sparseCount, indexBytes, indexBytes);
    checkRun(views_[values["bufferView"].get<size_t>()], numberOr(values, "byteOffset", 0), sparseCount, elementBytes, elementBytes);
    const Bytes& buffer = buffers_[indexView["buffer"].get<size_t>()];
    checkSparseIndices(buffer.data() + numberOr(indexView, "byteOffset", 0) + offset, indexBytes, sparseCount, count);
  }

  const json views_;
  const std::vector<Bytes>& buffers_;
};

// An index accessor of nothing but zeros has no use, and tinygltf wants a buffer view.
void checkIndexAccessors(const json& document) {
  if (!document.contains("meshes")) return;
  for (const json& mesh : document["meshes"]) {
    for (const json& primitive : mesh["primitives"]) {
      if (primitive.contains("indices") && !document["accessors"][primitive["indices"].get<size_t>()].contains("bufferView"))
        throw Error("accessor " + primitive["indices"].dump() + " of a mesh's indices has no data; export the file again");
    }
  }
}

// Every node has at most one parent; returns it for each, -1 for a root.
std::vector<int64_t> parentsOf(const json& nodes) {
  std::vector<int64_t> parents(nodes.size(), -1);
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].contains("children")) continue;
    for (const json& childNumber : nodes[i]["children"]) {
      const size_t child = childNumber;
      if (parents[child] >= 0)
        throw Error("node " + std::to_string(child) + " is a child of node " + std::to_string(parents[child]) + " and of node " +
                    std::to_string(i) + "; export the file again");
      parents[child] = static_cast<int64_t>(i);
    }
  }
  return parents;
}

}  // namespace

uint32_t gltfComponentBytes(uint64_t componentType) {
  switch (componentType) {
    case 5120:
    case 5121: return 1;
    case 5122:
    case 5123: return 2;
    case 5125:
    case 5126: return 4;
    default: return 0;
  }
}

void checkRanges(const json& document, const std::vector<Bytes>& buffers) {
  const RangeChecker checker(document, buffers);
  checker.checkViews(document);
  if (!document.contains("accessors")) return;
  const json& accessors = document["accessors"];
  for (size_t i = 0; i < accessors.size(); ++i) {
    try {
      checker.checkAccessor(accessors[i]);
    } catch (const Error& error) {
      throw error.within("accessor " + std::to_string(i));
    }
  }
  checkIndexAccessors(document);
}

void checkNodeTree(const json& document) {
  if (!document.contains("nodes")) return;
  const std::vector<int64_t> parents = parentsOf(document["nodes"]);

  // With one parent each, whatever can't be reached from a root hangs in a ring. 0: not known, 1: on the way, 2: ends at a root.
  std::vector<char> state(parents.size(), 0);
  for (size_t i = 0; i < parents.size(); ++i) {
    int64_t node = static_cast<int64_t>(i);
    for (; node >= 0 && state[node] == 0; node = parents[node]) state[node] = 1;
    if (node >= 0 && state[node] == 1) throw Error("node " + std::to_string(node) + " is its own ancestor; export the file again");
    for (node = static_cast<int64_t>(i); node >= 0 && state[node] == 1; node = parents[node]) state[node] = 2;
  }
  if (!document.contains("scenes")) return;
  for (const json& scene : document["scenes"]) {
    if (!scene.contains("nodes")) continue;
    for (const json& root : scene["nodes"]) {
      if (parents[root.get<size_t>()] >= 0)
        throw Error("a scene lists node " + root.dump() + ", which is a child of node " + std::to_string(parents[root.get<size_t>()]) +
                    "; export the file again");
    }
  }
}

}  // namespace gridscope
