// See load_rays.h.
#include "app/session/load_rays.h"

#include <cmath>

#include "app/base/text.h"
#include "core/base/error.h"

namespace gridscope {

namespace {

constexpr uint64_t kMostRays = uint64_t(1) << 26;
constexpr uint64_t kMostFileBytes = kMostRays * 9 * sizeof(double) + 65536;
constexpr double kUnitTolerance = 1e-5;  // a float's unit vector is off by about 1e-7; more is not meant as one

// Rays and columns of an array's shape, and the frame that they fill.
struct RayShape {
  uint64_t count;
  uint64_t columns;
  FrameSize size;
};

RayShape shapeOf(const NpyArray& array, std::optional<FrameSize> size) {
  const std::string shape = npyShapeText(array.shape);
  const size_t dimensions = array.shape.size();
  if ((dimensions != 2 && dimensions != 3) || (array.shape.back() != 6 && array.shape.back() != 9))
    throw Error("has the shape " + shape + "; give (height, width, 6 or 9) or (count, 6 or 9)");
  const uint64_t width = array.shape[dimensions - 2];
  const uint64_t height = dimensions == 3 ? array.shape[0] : 1;
  if (width == 0 || height == 0) throw Error("has the shape " + shape + ": no rays");
  if (width > kMostRays || height > kMostRays || width * height > kMostRays)
    throw Error("has the shape " + shape + "; at most " + grouped(kMostRays) + " rays are taken");

  const FrameSize own{static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
  if (!size) return {width * height, array.shape.back(), own};
  const bool fits = dimensions == 2 ? uint64_t(size->width) * size->height == width : size->width == width && size->height == height;
  if (!fits) throw Error("has the shape " + shape + printed(", which is not the %u x %u rays of --size", size->width, size->height));
  return {width * height, array.shape.back(), *size};
}

class RayReader {
 public:
  // `row`: 6 or 9 numbers.
  template <class Number>
  Ray read(const Number* row, uint64_t columns, uint64_t index) {
    for (uint64_t k = 0; k < columns; ++k)
      if (!std::isfinite(row[k])) throw fault(index, "is not finite");
    for (int k = 0; k < 3; ++k)
      if (std::abs(double(row[k])) > kCoordinateLimit) throw fault(index, printed("starts beyond %g", kCoordinateLimit));
    Ray ray{};
    ray.origin = storedVector({row[0], row[1], row[2]});
    if (!unit({row[3], row[4], row[5]}, ray.direction)) throw fault(index, "has a direction of length 0");
    if (columns == 9) unit({row[6], row[7], row[8]}, ray.launchNormal);  // zero: gaps are never filled
    ray.valid = 1;
    return ray;
  }

  uint64_t changed() const { return changed_; }

 private:
  static Error fault(uint64_t index, const std::string& what) {
    return Error("ray " + std::to_string(index) + " " + what + "; mend or remove it");
  }
  static vec3 storedVector(const glm::dvec3& v) { return vec3(stored(float(v.x)), stored(float(v.y)), stored(float(v.z))); }

  // Keeps what is a unit vector but for rounding, bit for bit; false for a vector without length.
  bool unit(const glm::dvec3& v, vec3& result) {
    const double length = std::hypot(v.x, v.y, v.z);
    if (!(length > 1e-30) || !std::isfinite(length)) return false;
    const bool change = std::abs(length - 1.0) > kUnitTolerance;
    changed_ += change ? 1 : 0;
    result = storedVector(change ? v / length : v);
    return true;
  }

  uint64_t changed_ = 0;
};

template <class Number>
LoadedRays readRows(std::span<const Number> values, const RayShape& shape) {
  LoadedRays loaded{.rays = {}, .size = shape.size, .note = {}};
  RayReader reader;
  loaded.rays.reserve(shape.count);
  for (uint64_t i = 0; i < shape.count; ++i) loaded.rays.push_back(reader.read(&values[i * shape.columns], shape.columns, i));
  if (reader.changed() > 0) loaded.note = grouped(reader.changed()) + " vectors were not of length 1 and have been normalised";
  return loaded;
}

}  // namespace

LoadedRays raysFrom(const NpyArray& array, std::optional<FrameSize> size) {
  const RayShape shape = shapeOf(array, size);
  if (array.type == NpyType::f4) return readRows(array.values<float>(), shape);
  if (array.type == NpyType::f8) return readRows(array.values<double>(), shape);
  throw Error(std::string("holds ") + npyTypeName(array.type) + "; give float32 or float64 (<f4 or <f8)");
}

LoadedRays loadRays(const Options& options) {
  if (options.rays.empty()) return {};
  try {
    const NpyArray array = readNpy(options.rays, kMostFileBytes);
    try {
      return raysFrom(array, options.size);
    } catch (const Error& error) {
      throw error.within(options.rays.string());
    }
  } catch (const Error& error) {
    throw Error(std::string("--rays ") + error.what());
  }
}

}  // namespace gridscope
