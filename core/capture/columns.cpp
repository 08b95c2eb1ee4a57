// See columns.h.
#include "core/capture/columns.h"

#include <array>
#include <cstddef>
#include <cstring>

#include "core/base/error.h"

namespace gridscope {

namespace {

constexpr std::array<PartRow, kPartCount> kParts = {{
    {Part::triangles, "triangles", Lead::count, sizeof(Triangle), false},
    {Part::corners, "corners", Lead::triangleCorners, sizeof(Corner), false},
    {Part::numbers, "triangle numbers", Lead::count, sizeof(uint32_t), false},
    {Part::instances, "instances", Lead::count, sizeof(InstanceColumns), false},
    {Part::rows, "transforms", Lead::count, sizeof(InstanceRows), true},
    {Part::materials, "materials", Lead::count, sizeof(TraceMaterial), false},
    {Part::alpha, "alpha maps", Lead::count, sizeof(uint32_t), false},
    {Part::grid, "grid", Lead::grid, sizeof(uint32_t), true},
    {Part::gather, "gather", Lead::pixels, sizeof(GatherPixel), true},
    {Part::rays, "rays", Lead::pixels, sizeof(Ray), true},
    {Part::hits, "hits", Lead::pixels, sizeof(Hit), true},
    {Part::counters, "counters", Lead::pixels, sizeof(RayCounters), true},
    {Part::exact, "exact hits", Lead::pixels, sizeof(ExactHit), true},
}};

// Materials are two arrays: the words in front of `flags` are floats, the others are whole numbers.
constexpr uint64_t kMaterialFloats = offsetof(TraceMaterial, flags) / 4;
constexpr uint64_t kMaterialWords = (sizeof(TraceMaterial) - offsetof(TraceMaterial, flags)) / 4;
static_assert(kMaterialFloats == 6 && kMaterialWords == 8);

const std::vector<ColumnRow>& columns() {
  static const std::vector<ColumnRow> rows = {
      {"triangles.npy", Part::triangles, NpyType::f4, 0, {3, 3}, false, false},
      {"triangles_number.npy", Part::numbers, NpyType::u4, 0, {}, false, false},
      {"corners_normal.npy", Part::corners, NpyType::f4, offsetof(Corner, normal), {3}, false, false},
      {"corners_uv.npy", Part::corners, NpyType::f4, offsetof(Corner, uv), {2}, false, false},
      {"corners_colour.npy", Part::corners, NpyType::u1, offsetof(Corner, colour), {4}, false, false},
      {"instances.npy", Part::instances, NpyType::u4, 0, {5}, false, false},
      {"instances_transform.npy", Part::rows, NpyType::f4, 0, {3, 4}, false, false},
      {"materials_shading.npy", Part::materials, NpyType::f4, 0, {kMaterialFloats}, false, false},
      {"materials_keying.npy", Part::materials, NpyType::u4, offsetof(TraceMaterial, flags), {kMaterialWords}, false, false},
      {"alpha.npy", Part::alpha, NpyType::u1, 0, {4}, false, false},
      {"grid.npy", Part::grid, NpyType::u4, 0, {}, false, false},
      {"gather_position.npy", Part::gather, NpyType::f4, offsetof(GatherPixel, position), {3}, false, false},
      {"gather_geometric_normal.npy", Part::gather, NpyType::f4, offsetof(GatherPixel, geometricNormal), {3}, false, false},
      {"gather_shading_normal.npy", Part::gather, NpyType::f4, offsetof(GatherPixel, shadingNormal), {3}, false, false},
      {"gather_barycentrics.npy", Part::gather, NpyType::f4, offsetof(GatherPixel, barycentrics), {2}, false, false},
      {"gather_depth.npy", Part::gather, NpyType::f4, offsetof(GatherPixel, depth), {}, false, false},
      {"gather_reference.npy", Part::gather, NpyType::u4, offsetof(GatherPixel, reference), {}, false, false},
      {"gather_material.npy", Part::gather, NpyType::u4, offsetof(GatherPixel, material), {}, false, false},
      {"rays_origin.npy", Part::rays, NpyType::f4, offsetof(Ray, origin), {3}, false, false},
      {"rays_direction.npy", Part::rays, NpyType::f4, offsetof(Ray, direction), {3}, false, false},
      {"rays_launch_normal.npy", Part::rays, NpyType::f4, offsetof(Ray, launchNormal), {3}, true, false},
      {"rays_valid.npy", Part::rays, NpyType::u1, offsetof(Ray, valid), {}, true, true},
      {"hits_kind.npy", Part::hits, NpyType::u1, offsetof(Hit, kind), {}, false, true},
      {"hits_t.npy", Part::hits, NpyType::f4, offsetof(Hit, t), {}, false, false},
      {"hits_reference.npy", Part::hits, NpyType::u4, offsetof(Hit, reference), {}, false, false},
      {"hits_barycentrics.npy", Part::hits, NpyType::f4, offsetof(Hit, u), {2}, false, false},
      {"counters_visits.npy", Part::counters, NpyType::u4, offsetof(RayCounters, visits), {}, false, false},
      {"counters_tests.npy", Part::counters, NpyType::u4, offsetof(RayCounters, tests), {}, false, false},
      {"exact_t.npy", Part::exact, NpyType::f4, offsetof(ExactHit, t), {}, false, false},
      {"exact_reference.npy", Part::exact, NpyType::u4, offsetof(ExactHit, reference), {}, false, false},
  };
  return rows;
}

// Calls visit with the vector that holds a part.
template <class Visit>
auto visitPart(CaptureArrays& arrays, Part part, size_t frame, const Visit& visit) {
  CaptureFrame& current = arrays.capture.frames[frame];
  NumberedScene& scene = arrays.capture.scene;
  switch (part) {
    case Part::triangles: return visit(scene.objectTriangles);
    case Part::corners: return visit(scene.corners);
    case Part::numbers: return visit(scene.meshTriangles);
    case Part::instances: return visit(arrays.instances);
    case Part::rows: return visit(current.rows);
    case Part::materials: return visit(scene.materials);
    case Part::alpha: return visit(scene.alphaBytes);
    case Part::grid: return visit(current.grid);
    case Part::gather: return visit(current.gather);
    case Part::rays: return visit(current.rays);
    case Part::hits: return visit(current.hits);
    case Part::counters: return visit(current.counters);
    case Part::exact: break;
  }
  return visit(current.exact);
}

// Bytes of a column's values within one element, there and in the file.
size_t bytesInElement(const ColumnRow& column) { return column.narrow ? 4 : columnWidth(column) * npyTypeSize(column.type); }
size_t bytesInFile(const ColumnRow& column) { return columnWidth(column) * npyTypeSize(column.type); }

}  // namespace

const PartRow& partRow(Part part) { return kParts[static_cast<size_t>(part)]; }
std::span<const ColumnRow> captureColumns() { return columns(); }

GridArray gridArrayOf(const GridParameters& grid, std::string_view entry) {
  for (const GridArray& array : gridArrays(grid))
    if (entry == array.name + std::string(".npy")) return array;
  throw Error(std::string(entry) + ": the grid has no such array");
}

const ColumnRow* findColumn(const std::string& entry) {
  for (const ColumnRow& column : columns())
    if (column.entry == entry) return &column;
  return nullptr;
}

uint64_t columnWidth(const ColumnRow& column) {
  uint64_t width = 1;
  for (uint64_t side : column.tail) width *= side;
  return width;
}

std::span<std::byte> partBytes(CaptureArrays& arrays, Part part, size_t frame) {
  return visitPart(arrays, part, frame, [](auto& elements) { return std::as_writable_bytes(std::span(elements)); });
}

void resizePart(CaptureArrays& arrays, Part part, size_t frame, uint64_t count) {
  visitPart(arrays, part, frame, [count](auto& elements) { elements.resize(count); });
}

void packColumn(const ColumnRow& column, std::span<const std::byte> elements, std::byte* values) {
  const size_t stride = partRow(column.part).elementBytes, size = bytesInFile(column);
  if (elements.empty()) return;
  if (size == stride) {
    std::memcpy(values, elements.data(), elements.size());
    return;
  }
  const size_t count = elements.size() / stride;
  for (size_t i = 0; i < count; ++i) std::memcpy(values + i * size, elements.data() + i * stride + column.offset, size);
}

void unpackColumn(const ColumnRow& column, const std::byte* values, std::span<std::byte> elements) {
  const size_t stride = partRow(column.part).elementBytes, size = bytesInFile(column);
  if (elements.empty()) return;
  if (size == stride) {
    std::memcpy(elements.data(), values, elements.size());
    return;
  }
  const size_t count = elements.size() / stride;
  for (size_t i = 0; i < count; ++i) {
    std::byte* place = elements.data() + i * stride + column.offset;
    if (column.narrow) std::memset(place, 0, bytesInElement(column));
    std::memcpy(place, values + i * size, size);  // little-endian: a byte is the low one of its word
  }
}

}  // namespace gridscope
