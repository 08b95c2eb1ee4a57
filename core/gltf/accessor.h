// Reads one element at a time from an accessor of a checked glTF model: any component type, stride, normalisation, sparse or not.
// Nothing is unpacked in advance, so an accessor costs no memory however large it claims to be.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/scene/scene.h"

namespace tinygltf {
class Model;
}

namespace gridscope {

class AccessorView {
 public:
  AccessorView(const tinygltf::Model& model, int accessorIndex);

  size_t count() const { return count_; }
  int componentCount() const { return componentCount_; }  // 1 to 4; 0 for a matrix
  bool isFloat() const;
  bool isUnsignedInteger() const;

  vec4 at(size_t index) const;           // missing components are 0
  uint32_t indexAt(size_t index) const;  // of an accessor of unsigned integers

 private:
  const unsigned char* element(size_t index) const;
  float component(const unsigned char* data) const;

  const unsigned char* data_ = nullptr;  // null: all zero but for the sparse ones
  size_t count_ = 0;
  size_t stride_ = 0;
  int componentCount_ = 0;
  int componentType_ = 0;
  size_t componentBytes_ = 0;
  bool normalized_ = false;

  const unsigned char* sparseIndices_ = nullptr;
  const unsigned char* sparseValues_ = nullptr;
  size_t sparseCount_ = 0;
  size_t sparseIndexBytes_ = 0;
};

}  // namespace gridscope
