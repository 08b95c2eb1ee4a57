// Arrays in NumPy's .npy format: what captures hold, and what rays of one's own come in. Reading takes every byte for hostile: what comes
// out agrees with its header, or is an Error; nothing is allocated beyond the size of the input.
// Source: NumPy Enhancement Proposal 1, A Simple File Format for NumPy Arrays, 2007.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace gridscope {

// Element types, all little-endian.
enum class NpyType { u1, u2, u4, u8, i4, i8, f4, f8 };

size_t npyTypeSize(NpyType type);       // bytes
const char* npyTypeName(NpyType type);  // as the header spells it: "<f4", "|u1"

template <class Value>
constexpr NpyType npyTypeOf();
template <>
constexpr NpyType npyTypeOf<uint8_t>() {
  return NpyType::u1;
}
template <>
constexpr NpyType npyTypeOf<uint16_t>() {
  return NpyType::u2;
}
template <>
constexpr NpyType npyTypeOf<uint32_t>() {
  return NpyType::u4;
}
template <>
constexpr NpyType npyTypeOf<uint64_t>() {
  return NpyType::u8;
}
template <>
constexpr NpyType npyTypeOf<int32_t>() {
  return NpyType::i4;
}
template <>
constexpr NpyType npyTypeOf<int64_t>() {
  return NpyType::i8;
}
template <>
constexpr NpyType npyTypeOf<float>() {
  return NpyType::f4;
}
template <>
constexpr NpyType npyTypeOf<double>() {
  return NpyType::f8;
}

// An array in C order: the last index runs fastest.
struct NpyArray {
  NpyType type = NpyType::u1;
  std::vector<uint64_t> shape;   // empty: one value
  std::vector<std::byte> bytes;  // elementCount() values

  uint64_t elementCount() const { return bytes.size() / npyTypeSize(type); }

  // The values. Value must be the array's type.
  template <class Value>
  std::span<const Value> values() const {
    CHECK_EQ(std::string_view(npyTypeName(type)), std::string_view(npyTypeName(npyTypeOf<Value>())));
    return {reinterpret_cast<const Value*>(bytes.data()), elementCount()};
  }
};

// What stands in front of the data.
struct NpyHeader {
  NpyType type = NpyType::u1;
  std::vector<uint64_t> shape;
  size_t dataOffset = 0;  // of the first value in the file
};

// Throws Error as parseNpy(), which it is the first half of; the data may be missing, or be of another size.
NpyHeader parseNpyHeader(std::span<const std::byte> file);

// Bytes of an array; UINT64_MAX when they do not fit into 64 bits.
uint64_t npyByteCount(NpyType type, std::span<const uint64_t> shape);

// Throws Error: not a .npy file, a type or an order that is not supported, bytes that do not agree with the shape.
NpyArray parseNpy(std::span<const std::byte> file);

// The same from a file of at most maxBytes; the Error's message begins with the file's name.
NpyArray readNpy(const std::filesystem::path& file, uint64_t maxBytes);

// Everything in front of the data of a .npy file (version 1.0).
std::vector<std::byte> formatNpyHeader(NpyType type, std::span<const uint64_t> shape);

// A whole .npy file (version 1.0). `data` must hold the shape's product of values.
std::vector<std::byte> formatNpy(NpyType type, std::span<const uint64_t> shape, std::span<const std::byte> data);

template <class Value>
std::vector<std::byte> formatNpy(std::span<const uint64_t> shape, std::span<const Value> values) {
  return formatNpy(npyTypeOf<Value>(), shape, std::as_bytes(values));
}

// "(3, 4)", as the header writes a shape.
std::string npyShapeText(std::span<const uint64_t> shape);

}  // namespace gridscope
