// The arrays of a capture, one row each: what the entry is called, which structures it takes its values from, and their place in them. Reading,
// writing, the manifest and FORMAT.md follow this table.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/capture/capture.h"

namespace gridscope {

// Arrays of one structure: their columns have one count, and a product that lacks one of its columns can't be used.
enum class Part { triangles, corners, numbers, instances, rows, materials, alpha, grid, gather, rays, hits, counters, exact };
inline constexpr size_t kPartCount = 13;

// What the first dimensions of a column count.
enum class Lead { count, triangleCorners, grid, pixels };  // (n), (n / 3, 3), as gridArrays() says, (height, width)

// The row of `instances`.
struct InstanceColumns {
  uint32_t firstTriangle;
  uint32_t triangleCount;
  uint32_t mesh;
  uint32_t sceneInstance;
  uint32_t material;
};

struct PartRow {
  Part part;
  const char* name;  // for messages
  Lead lead;
  size_t elementBytes;
  bool perFrame;  // may have a leading frame axis
};

struct ColumnRow {
  const char* entry;
  Part part;
  NpyType type;
  size_t offset;               // of its values in the structure
  std::vector<uint64_t> tail;  // dimensions behind the lead
  bool optional;               // the part can do without it: zero, or one where `valid` says so
  bool narrow;                 // a 32-bit word of the structure, stored as one byte
};

const PartRow& partRow(Part part);
std::span<const ColumnRow> captureColumns();
// The grid's array that an entry holds.
GridArray gridArrayOf(const GridParameters& grid, std::string_view entry);

const ColumnRow* findColumn(const std::string& entry);

// Values of a column in one element.
uint64_t columnWidth(const ColumnRow& column);

// A capture with its instances as the file has them.
struct CaptureArrays {
  Capture& capture;
  std::vector<InstanceColumns> instances;
};

// Elements of a part, as bytes; `frame` counts for those that change.
std::span<std::byte> partBytes(CaptureArrays& arrays, Part part, size_t frame);
void resizePart(CaptureArrays& arrays, Part part, size_t frame, uint64_t count);

// Between the elements of a part and the values of one column, one behind the other.
void packColumn(const ColumnRow& column, std::span<const std::byte> elements, std::byte* values);
void unpackColumn(const ColumnRow& column, const std::byte* values, std::span<std::byte> elements);

}  // namespace gridscope
