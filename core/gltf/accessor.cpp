// Reads one element at a time from an accessor, see accessor.h.
#include "core/gltf/accessor.h"

#include <algorithm>
#include <cstring>

#include <tiny_gltf.h>

#include "core/gltf/ranges.h"

namespace gridscope {

namespace {

const unsigned char* viewData(const tinygltf::Model& model, int viewIndex, size_t offset) {
  const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(viewIndex)];
  return model.buffers[static_cast<size_t>(view.buffer)].data.data() + view.byteOffset + offset;
}

template <typename T>
T load(const unsigned char* data) {
  T value;
  std::memcpy(&value, data, sizeof value);  // a file may leave its data unaligned
  return value;
}

uint32_t loadUnsigned(const unsigned char* data, size_t bytes) {
  return bytes == 1 ? *data : bytes == 2 ? load<uint16_t>(data) : load<uint32_t>(data);
}

}  // namespace

AccessorView::AccessorView(const tinygltf::Model& model, int accessorIndex) {
  const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(accessorIndex)];
  count_ = accessor.count;
  componentType_ = accessor.componentType;
  componentBytes_ = gltfComponentBytes(static_cast<uint64_t>(componentType_));
  componentCount_ = accessor.type == TINYGLTF_TYPE_SCALAR ? 1 : accessor.type <= 4 ? accessor.type : 0;
  normalized_ = accessor.normalized;
  stride_ = componentBytes_ * static_cast<size_t>(componentCount_);
  if (accessor.bufferView >= 0) {
    data_ = viewData(model, accessor.bufferView, accessor.byteOffset);
    const size_t stride = model.bufferViews[static_cast<size_t>(accessor.bufferView)].byteStride;
    if (stride != 0) stride_ = stride;
  }
  if (!accessor.sparse.isSparse) return;
  const auto& sparse = accessor.sparse;
  sparseCount_ = static_cast<size_t>(sparse.count);
  sparseIndexBytes_ = gltfComponentBytes(static_cast<uint64_t>(sparse.indices.componentType));
  sparseIndices_ = viewData(model, sparse.indices.bufferView, static_cast<size_t>(sparse.indices.byteOffset));
  sparseValues_ = viewData(model, sparse.values.bufferView, static_cast<size_t>(sparse.values.byteOffset));
}

bool AccessorView::isFloat() const { return componentType_ == TINYGLTF_COMPONENT_TYPE_FLOAT; }

bool AccessorView::isUnsignedInteger() const {
  return componentType_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || componentType_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         componentType_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

vec4 AccessorView::at(size_t index) const {
  vec4 value(0.0f);
  const unsigned char* data = element(index);
  if (!data) return value;
  if (isFloat()) {
    std::memcpy(&value, data, sizeof(float) * static_cast<size_t>(componentCount_));
    return value;
  }
  for (int c = 0; c < componentCount_; ++c) value[c] = component(data + static_cast<size_t>(c) * componentBytes_);
  return value;
}

uint32_t AccessorView::indexAt(size_t index) const {
  const unsigned char* data = element(index);
  return data ? loadUnsigned(data, componentBytes_) : 0;
}

const unsigned char* AccessorView::element(size_t index) const {
  // The guard made sure that sparse indices rise.
  size_t begin = 0, end = sparseCount_;
  while (begin < end) {
    const size_t middle = (begin + end) / 2;
    const size_t found = loadUnsigned(sparseIndices_ + middle * sparseIndexBytes_, sparseIndexBytes_);
    if (found == index) return sparseValues_ + middle * componentBytes_ * static_cast<size_t>(componentCount_);
    (found < index ? begin : end) = found < index ? middle + 1 : middle;
  }
  return data_ ? data_ + index * stride_ : nullptr;
}

float AccessorView::component(const unsigned char* data) const {
  switch (componentType_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return normalized_ ? std::max(load<int8_t>(data) / 127.0f, -1.0f) : load<int8_t>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return normalized_ ? *data / 255.0f : *data;
    case TINYGLTF_COMPONENT_TYPE_SHORT: return normalized_ ? std::max(load<int16_t>(data) / 32767.0f, -1.0f) : load<int16_t>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return normalized_ ? load<uint16_t>(data) / 65535.0f : load<uint16_t>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return static_cast<float>(load<uint32_t>(data));
    default: return load<float>(data);
  }
}

}  // namespace gridscope
