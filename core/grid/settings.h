// What a person can set of a grid, with its default. Lengths are in cell edges where not said otherwise. derive.h turns settings into the
// parameters that the stages read.
#pragma once

#include <cstdint>
#include <optional>

#include "core/scene/numbering.h"
#include "shaders/shared/grid/parameters.h"

namespace gridscope {

enum class Stretch : uint32_t { x = 0, y = 1, z = 2, automatic = 3 };  // automatic: the axis with the fewest cells, x on a tie
enum class Builder { compute, raster };
enum class UpdateMode { all, moved };  // clear and add again every dynamic instance, or only what moved

// What their values are called, on the command line and in every table.
constexpr const char* builderWord(Builder builder) { return builder == Builder::raster ? "raster" : "compute"; }
constexpr const char* updateWord(UpdateMode update) { return update == UpdateMode::moved ? "moved" : "all"; }
constexpr const char* insertionWord(uint32_t insertion) { return insertion == kInsertionSorted ? "sorted" : "first-come"; }
constexpr const char* overlapWord(uint32_t overlap) { return overlap == kOverlapExact ? "exact" : "plane"; }

struct GridSettings {
  uint32_t cells = 128;            // along the longest side of the bounds
  float cellEdge = 0.0f;           // world units; above 0 it replaces `cells`
  uint32_t capacity = 32;          // slots of a cell
  std::optional<Bounds> bounds{};  // replaces the scene's
  Stretch stretch = Stretch::automatic;
  Builder builder = Builder::compute;
  uint32_t insertion = kInsertionSorted;  // kInsertion...
  uint32_t overlap = kOverlapPlane;       // kOverlap...
  float enlargement = 1.05f;              // of the cell in the overlap test
  NumberBy numberBy = NumberBy::file;
  UpdateMode update = UpdateMode::all;
};

}  // namespace gridscope
