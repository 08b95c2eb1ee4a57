// The shape of a glTF document, see shape.h.
#include "core/gltf/shape.h"

#include <cfloat>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/gltf_files.h"

namespace gridscope {

using nlohmann::json;

namespace {

enum class Kind {
  index,     // into the root's array `of`
  indices,   // an array of them
  indexMap,  // an object of them
  count,     // a whole number from 0 to kCountLimit
  number,    // finite as a float
  numbers,   // an array of `size` of them
  flag,
  text,     // fit for a message (plainName), but for URIs
  object,   // of shape `fields`
  objects,  // an array of them
};

enum Need { optional, required };

struct Field {
  const char* key;
  Kind kind;
  Need need = optional;
  const char* of = nullptr;
  size_t size = 0;
  const std::vector<Field>* fields = nullptr;
};
using Shape = std::vector<Field>;

// A byte offset beyond the file limit can't be right, and a vertex or key count neither.
constexpr uint64_t kCountLimit = kGltfFileLimit;

const Shape kAsset = {{"version", Kind::text, required}, {"minVersion", Kind::text}};
const Shape kSceneList = {{"name", Kind::text}, {"nodes", Kind::indices, optional, "nodes"}};

const Shape kInstancing = {{"attributes", Kind::indexMap, required, "accessors"}};
const Shape kNodeExtensions = {{"EXT_mesh_gpu_instancing", Kind::object, optional, nullptr, 0, &kInstancing}};
const Shape kNode = {
    {"name", Kind::text},
    {"children", Kind::indices, optional, "nodes"},
    {"mesh", Kind::index, optional, "meshes"},
    {"camera", Kind::index, optional, "cameras"},
    {"matrix", Kind::numbers, optional, nullptr, 16},
    {"translation", Kind::numbers, optional, nullptr, 3},
    {"rotation", Kind::numbers, optional, nullptr, 4},
    {"scale", Kind::numbers, optional, nullptr, 3},
    {"extensions", Kind::object, optional, nullptr, 0, &kNodeExtensions},
};

const Shape kPrimitive = {
    {"attributes", Kind::indexMap, required, "accessors"},
    {"indices", Kind::index, optional, "accessors"},
    {"material", Kind::index, optional, "materials"},
    {"mode", Kind::count},
};
const Shape kMesh = {{"name", Kind::text}, {"primitives", Kind::objects, required, nullptr, 0, &kPrimitive}};

const Shape kSparseIndices = {
    {"bufferView", Kind::index, required, "bufferViews"},
    {"byteOffset", Kind::count},
    {"componentType", Kind::count, required},
};
const Shape kSparseValues = {{"bufferView", Kind::index, required, "bufferViews"}, {"byteOffset", Kind::count}};
const Shape kSparse = {
    {"count", Kind::count, required},
    {"indices", Kind::object, required, nullptr, 0, &kSparseIndices},
    {"values", Kind::object, required, nullptr, 0, &kSparseValues},
};
const Shape kAccessor = {
    {"bufferView", Kind::index, optional, "bufferViews"},
    {"byteOffset", Kind::count},
    {"componentType", Kind::count, required},
    {"normalized", Kind::flag},
    {"count", Kind::count, required},
    {"type", Kind::text, required},
    {"sparse", Kind::object, optional, nullptr, 0, &kSparse},
};
const Shape kBufferView = {
    {"buffer", Kind::index, required, "buffers"},
    {"byteOffset", Kind::count},
    {"byteLength", Kind::count, required},
    {"byteStride", Kind::count},
};
const Shape kBuffer = {{"uri", Kind::text}, {"byteLength", Kind::count, required}};

const Shape kTextureTransform = {
    {"offset", Kind::numbers, optional, nullptr, 2},
    {"rotation", Kind::number},
    {"scale", Kind::numbers, optional, nullptr, 2},
    {"texCoord", Kind::count},
};
const Shape kTextureInfoExtensions = {{"KHR_texture_transform", Kind::object, optional, nullptr, 0, &kTextureTransform}};
const Shape kTextureInfo = {
    {"index", Kind::index, required, "textures"},
    {"texCoord", Kind::count},
    {"extensions", Kind::object, optional, nullptr, 0, &kTextureInfoExtensions},
};
const Shape kMetallicRoughness = {
    {"baseColorFactor", Kind::numbers, optional, nullptr, 4},
    {"baseColorTexture", Kind::object, optional, nullptr, 0, &kTextureInfo},
    {"metallicFactor", Kind::number},
    {"roughnessFactor", Kind::number},
    {"metallicRoughnessTexture", Kind::object, optional, nullptr, 0, &kTextureInfo},
};
const Shape kNoFields = {};
const Shape kMaterialExtensions = {{"KHR_materials_unlit", Kind::object, optional, nullptr, 0, &kNoFields}};
const Shape kMaterial = {
    {"name", Kind::text},        {"pbrMetallicRoughness", Kind::object, optional, nullptr, 0, &kMetallicRoughness},
    {"alphaMode", Kind::text},   {"alphaCutoff", Kind::number},
    {"doubleSided", Kind::flag}, {"extensions", Kind::object, optional, nullptr, 0, &kMaterialExtensions},
};
const Shape kTexture = {{"sampler", Kind::index, optional, "samplers"}, {"source", Kind::index, optional, "images"}};
const Shape kImage = {{"name", Kind::text}, {"uri", Kind::text}, {"bufferView", Kind::index, optional, "bufferViews"}};
const Shape kSampler = {{"wrapS", Kind::count}, {"wrapT", Kind::count}};

const Shape kPerspective = {{"yfov", Kind::number, required}, {"znear", Kind::number, required}};
const Shape kOrthographic = {
    {"xmag", Kind::number, required},
    {"ymag", Kind::number, required},
    {"zfar", Kind::number, required},
    {"znear", Kind::number, required},
};
const Shape kCamera = {
    {"name", Kind::text},
    {"type", Kind::text, required},
    {"perspective", Kind::object, optional, nullptr, 0, &kPerspective},
    {"orthographic", Kind::object, optional, nullptr, 0, &kOrthographic},
};

const Shape kTarget = {{"node", Kind::index, optional, "nodes"}, {"path", Kind::text, required}};
const Shape kChannel = {{"sampler", Kind::count, required}, {"target", Kind::object, required, nullptr, 0, &kTarget}};
const Shape kAnimationSampler = {
    {"input", Kind::index, required, "accessors"},
    {"output", Kind::index, required, "accessors"},
    {"interpolation", Kind::text},
};
const Shape kAnimation = {
    {"name", Kind::text},
    {"channels", Kind::objects, required, nullptr, 0, &kChannel},
    {"samplers", Kind::objects, required, nullptr, 0, &kAnimationSampler},
};

const Shape kRoot = {
    {"asset", Kind::object, required, nullptr, 0, &kAsset},
    {"scene", Kind::index, optional, "scenes"},
    {"scenes", Kind::objects, optional, nullptr, 0, &kSceneList},
    {"nodes", Kind::objects, optional, nullptr, 0, &kNode},
    {"meshes", Kind::objects, optional, nullptr, 0, &kMesh},
    {"accessors", Kind::objects, optional, nullptr, 0, &kAccessor},
    {"bufferViews", Kind::objects, optional, nullptr, 0, &kBufferView},
    {"buffers", Kind::objects, optional, nullptr, 0, &kBuffer},
    {"materials", Kind::objects, optional, nullptr, 0, &kMaterial},
    {"textures", Kind::objects, optional, nullptr, 0, &kTexture},
    {"images", Kind::objects, optional, nullptr, 0, &kImage},
    {"samplers", Kind::objects, optional, nullptr, 0, &kSampler},
    {"cameras", Kind::objects, optional, nullptr, 0, &kCamera},
    {"animations", Kind::objects, optional, nullptr, 0, &kAnimation},
};

// Where in the document a value stands; a list on the stack, so that only an error costs a string.
struct Place {
  const Place* above = nullptr;
  std::string_view key;
  int64_t index = -1;

  std::string text() const {
    std::string text = above ? above->text() : "";
    if (index >= 0) return text + "[" + std::to_string(index) + "]";
    return text.empty() ? plainName(key) : text + "." + plainName(key);
  }
};

[[noreturn]] void refuse(const Place& place, const std::string& complaint) {
  throw Error(place.text() + " " + complaint + "; export the file again");
}

class ShapeReader {
 public:
  explicit ShapeReader(const json& root) : root_(root) {}

  json object(const json& value, const Shape& shape, const Place& place) const {
    if (!value.is_object()) refuse(place, "is not an object");
    json known = json::object();
    for (const Field& field : shape) {
      const auto found = value.find(field.key);
      const Place inside{&place, field.key};
      if (found != value.end()) {
        known[field.key] = read(*found, field, inside);
      } else if (field.need == required) {
        refuse(inside, "is missing");
      }
    }
    return known;
  }

 private:
  json read(const json& value, const Field& field, const Place& place) const {
    switch (field.kind) {
      case Kind::index: return index(value, field, place);
      case Kind::indices:
      case Kind::numbers:
      case Kind::objects: return list(value, field, place);
      case Kind::indexMap: return indexMap(value, field, place);
      case Kind::count: return wholeNumber(value, place);
      case Kind::number: return number(value, place);
      case Kind::flag:
        if (!value.is_boolean()) refuse(place, "is neither true nor false");
        return value;
      case Kind::text:
        if (!value.is_string()) refuse(place, "is not a text");
        return std::string_view(field.key) == "uri" ? value : json(plainName(value.get_ref<const std::string&>()));
      case Kind::object: return object(value, *field.fields, place);
    }
    return {};
  }

  json list(const json& value, const Field& field, const Place& place) const {
    if (!value.is_array()) refuse(place, "is not an array");
    if (field.kind == Kind::numbers && value.size() != field.size)
      refuse(place, "has " + std::to_string(value.size()) + " numbers instead of " + std::to_string(field.size));
    json known = json::array();
    for (size_t i = 0; i < value.size(); ++i) {
      const Place inside{&place, {}, static_cast<int64_t>(i)};
      known.push_back(field.kind == Kind::indices   ? index(value[i], field, inside)
                      : field.kind == Kind::numbers ? number(value[i], inside)
                                                    : object(value[i], *field.fields, inside));
    }
    return known;
  }

  json indexMap(const json& value, const Field& field, const Place& place) const {
    if (!value.is_object()) refuse(place, "is not an object");
    json known = json::object();
    for (const auto& [key, entry] : value.items()) known[key] = index(entry, field, Place{&place, key});
    return known;
  }

  json index(const json& value, const Field& field, const Place& place) const {
    const json whole = wholeNumber(value, place);
    const auto found = root_.find(field.of);
    const size_t size = found != root_.end() && found->is_array() ? found->size() : 0;
    if (whole.get<uint64_t>() >= size)
      refuse(place, "is " + whole.dump() + ", but there are only " + std::to_string(size) + " " + field.of);
    return whole;
  }

  // 5.0 is a whole number, too: some exporters write all numbers with a point.
  json wholeNumber(const json& value, const Place& place) const {
    const double number = value.is_number() ? value.get<double>() : -1.0;
    if (!(number >= 0.0) || number != std::floor(number)) refuse(place, "is not a whole number of 0 or more");
    if (number > static_cast<double>(kCountLimit)) refuse(place, "is " + value.dump() + ", which is absurdly large");
    return static_cast<uint64_t>(number);
  }

  json number(const json& value, const Place& place) const {
    if (!value.is_number()) refuse(place, "is not a number");
    if (!(std::abs(value.get<double>()) <= FLT_MAX)) refuse(place, "is too large for a float");
    return value.get<double>();
  }

  const json& root_;
};

}  // namespace

json knownShape(const json& document) {
  if (!document.is_object()) throw Error("this is JSON, but not a glTF document; export the file again");
  return ShapeReader(document).object(document, kRoot, Place{});
}

}  // namespace gridscope
