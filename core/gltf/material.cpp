// Materials and the images they need, see material.h.
#include "core/gltf/material.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <thread>

#include <tiny_gltf.h>

#include "core/base/error.h"
#include "core/base/image_decode.h"

namespace gridscope {

namespace {

// All images of a scene together, decoded: 1 GiB. What comes after is replaced by the checker.
constexpr uint64_t kScenePixelLimit = uint64_t{256} << 20;

// One image as it is loaded: its bytes, then its pixels, or why it has none.
struct PendingImage {
  GltfImageSource source;
  Bytes ownBytes{};
  std::span<const unsigned char> encoded{};
  Image image{};
  bool wantsMean = false;
  vec2 meanRoughnessMetallic{1.0f};
  std::string problem{};
};

// Source image of a texture, -1 for none, or one in a format of an extension.
int imageOf(const tinygltf::Model& model, int texture) { return texture < 0 ? -1 : model.textures[static_cast<size_t>(texture)].source; }

WrapMode wrapMode(int gltfMode) {
  if (gltfMode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return WrapMode::clamp;
  return gltfMode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? WrapMode::mirror : WrapMode::repeat;
}

float unitRange(double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); }

// Reads the bytes and the header; the pixels come later, in threads.
void openImage(PendingImage& pending, const tinygltf::Model& model, const std::filesystem::path& folder, uint64_t& pixelTotal) {
  try {
    if (pending.source.bufferView >= 0) {
      const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(pending.source.bufferView)];
      const Bytes& buffer = model.buffers[static_cast<size_t>(view.buffer)].data;
      pending.encoded = std::span(buffer).subspan(view.byteOffset, view.byteLength);
    } else {
      pending.ownBytes = readGltfUri(pending.source.uri, folder);
      pending.encoded = pending.ownBytes;
    }
    const uint64_t pixels = imageSize(pending.encoded).pixels();
    if (pixelTotal + pixels > kScenePixelLimit) throw Error("all images together have more than 256 Mi pixels");
    pixelTotal += pixels;
  } catch (const Error& error) {
    pending.problem = error.what();
  }
}

// Mean of the green (roughness) and the blue (metallic) channel, 0..1.
vec2 meanGreenBlue(const Image& image) {
  uint64_t green = 0, blue = 0;
  for (size_t i = 0; i + 3 < image.rgba.size(); i += 4) green += image.rgba[i + 1], blue += image.rgba[i + 2];
  const double scale = 1.0 / (255.0 * std::max<double>(1.0, static_cast<double>(image.rgba.size() / 4)));
  return vec2(static_cast<double>(green) * scale, static_cast<double>(blue) * scale);
}

void decodeAll(std::vector<PendingImage>& images) {
  std::atomic<size_t> next = 0;
  const auto work = [&] {
    for (size_t i = next++; i < images.size(); i = next++) {
      PendingImage& pending = images[i];
      if (!pending.problem.empty()) continue;
      try {
        pending.image = decodeImage(pending.encoded, pending.source.name);
        if (pending.wantsMean) pending.meanRoughnessMetallic = meanGreenBlue(pending.image);
      } catch (const std::exception& exception) {
        pending.problem = exception.what();
      }
    }
  };
  const size_t threadCount = std::min<size_t>({images.size(), std::max(1u, std::thread::hardware_concurrency()), 8});
  std::vector<std::jthread> threads;
  for (size_t i = 1; i < threadCount; ++i) threads.emplace_back(work);
  work();
}

// The images that the materials name, each once; a damaged one has become the checker.
class ImageSet {
 public:
  ImageSet(const tinygltf::Model& model, const CheckedGltf& checked, const std::filesystem::path& folder) : model_(model) {
    for (const tinygltf::Material& material : model.materials) {
      want(checked, material.pbrMetallicRoughness.baseColorTexture.index);
      want(checked, material.pbrMetallicRoughness.metallicRoughnessTexture.index);
      if (PendingImage* pending = find(material.pbrMetallicRoughness.metallicRoughnessTexture.index)) pending->wantsMean = true;
    }
    uint64_t pixelTotal = 0;
    for (PendingImage& pending : images_) openImage(pending, model, folder, pixelTotal);
    decodeAll(images_);
  }

  // Of a texture; null when it has no image that is PNG or JPEG.
  PendingImage* find(int texture) {
    const auto found = places_.find(imageOf(model_, texture));
    return found == places_.end() ? nullptr : &images_[found->second];
  }

 private:
  void want(const CheckedGltf& checked, int texture) {
    const int image = imageOf(model_, texture);
    if (image < 0 || !places_.emplace(image, images_.size()).second) return;
    images_.push_back({.source = checked.images[static_cast<size_t>(image)]});
  }

  const tinygltf::Model& model_;
  std::vector<PendingImage> images_;
  std::map<int, size_t> places_;
};

class MaterialLoader {
 public:
  MaterialLoader(const tinygltf::Model& model, ImageSet& images, Scene& scene, GltfWarnings& warnings)
      : model_(model), images_(images), scene_(scene), warnings_(warnings) {}

  Material load(const tinygltf::Material& source, size_t index) {
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    Material material;
    material.name = source.name.empty() ? "material " + std::to_string(index) : plainName(source.name);
    for (int c = 0; c < 4; ++c) material.baseColour[c] = unitRange(pbr.baseColorFactor[static_cast<size_t>(c)]);
    material.metallic = unitRange(pbr.metallicFactor);
    material.roughness = unitRange(pbr.roughnessFactor);
    if (source.alphaMode == "MASK") material.alphaMode = AlphaMode::mask;
    if (source.alphaMode == "BLEND") material.alphaMode = AlphaMode::blend;
    material.alphaCutoff = unitRange(source.alphaCutoff);
    material.doubleSided = source.doubleSided;
    material.unlit = source.extensions.contains("KHR_materials_unlit");
    if (pbr.baseColorTexture.index >= 0) setBaseColour(material, pbr.baseColorTexture.index);
    if (pbr.metallicRoughnessTexture.index >= 0) averageRoughness(material, pbr.metallicRoughnessTexture.index);
    return material;
  }

 private:
  void setBaseColour(Material& material, int texture) {
    if (const int sampler = model_.textures[static_cast<size_t>(texture)].sampler; sampler >= 0) {
      material.wrapU = wrapMode(model_.samplers[static_cast<size_t>(sampler)].wrapS);
      material.wrapV = wrapMode(model_.samplers[static_cast<size_t>(sampler)].wrapT);
    }
    const auto [place, isNew] = sceneImages_.emplace(imageOf(model_, texture), -1);
    if (isNew) place->second = addImage(images_.find(texture), material.name);
    material.imageIndex = place->second;
  }

  int32_t addImage(PendingImage* pending, const std::string& materialName) {
    if (pending && pending->problem.empty()) {
      scene_.images.push_back(std::move(pending->image));
      return static_cast<int32_t>(scene_.images.size()) - 1;
    }
    const std::string name = pending ? "'" + pending->source.name + "'" : "that of material '" + materialName + "'";
    const std::string problem = pending ? pending->problem : "only PNG and JPEG are supported, not KTX2, WebP or DDS";
    warnings_.add("textures that can't be read are replaced by a checker", problem.starts_with(name) ? problem : name + ": " + problem);
    return checker();
  }

  // One for all: a small file can name any number of images that are not there.
  int32_t checker() {
    if (checkerIndex_ < 0) {
      checkerIndex_ = static_cast<int32_t>(scene_.images.size());
      scene_.images.push_back(checkerImage("unreadable"));
    }
    return checkerIndex_;
  }

  // The shading has one roughness per material, so a map becomes its mean.
  void averageRoughness(Material& material, int texture) {
    const PendingImage* pending = images_.find(texture);
    if (!pending || !pending->problem.empty()) return;
    material.roughness *= pending->meanRoughnessMetallic.x;
    material.metallic *= pending->meanRoughnessMetallic.y;
    warnings_.add("maps of metalness and roughness are replaced by their mean", "'" + pending->source.name + "'");
  }

  const tinygltf::Model& model_;
  ImageSet& images_;
  Scene& scene_;
  GltfWarnings& warnings_;
  std::map<int, int32_t> sceneImages_;  // from the file's images
  int32_t checkerIndex_ = -1;
};

vec2 vec2Of(const tinygltf::Value& value, const char* key, const vec2& otherwise) {
  if (!value.Has(key)) return otherwise;
  const tinygltf::Value& list = value.Get(key);
  return vec2(list.Get(0).GetNumberAsDouble(), list.Get(1).GetNumberAsDouble());
}

}  // namespace

vec2 UvMapping::apply(const vec2& uv) const {
  const vec2 scaled = uv * scale;
  const float sine = std::sin(rotation), cosine = std::cos(rotation);
  return vec2(cosine * scaled.x + sine * scaled.y, cosine * scaled.y - sine * scaled.x) + offset;
}

UvMapping baseColourMapping(const tinygltf::Material& material) {
  const tinygltf::TextureInfo& texture = material.pbrMetallicRoughness.baseColorTexture;
  UvMapping mapping{.set = texture.texCoord};
  const auto found = texture.extensions.find("KHR_texture_transform");
  if (found == texture.extensions.end()) return mapping;
  const tinygltf::Value& transform = found->second;
  mapping.offset = vec2Of(transform, "offset", mapping.offset);
  mapping.scale = vec2Of(transform, "scale", mapping.scale);
  if (transform.Has("rotation")) mapping.rotation = static_cast<float>(transform.Get("rotation").GetNumberAsDouble());
  if (transform.Has("texCoord")) mapping.set = transform.Get("texCoord").GetNumberAsInt();
  return mapping;
}

void loadMaterials(const tinygltf::Model& model, const CheckedGltf& checked, const std::filesystem::path& folder, Scene& scene,
                   GltfWarnings& warnings) {
  ImageSet images(model, checked, folder);
  MaterialLoader loader(model, images, scene, warnings);
  for (const tinygltf::Material& material : model.materials) scene.materials.push_back(loader.load(material, scene.materials.size()));
}

}  // namespace gridscope
