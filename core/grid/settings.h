// Everything a person can set, with its default. Lengths are in cell edges where not said otherwise. derive.h turns settings into the
// parameters that the stages read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/scene/scene.h"
#include "shaders/shared/pipeline/parameters.h"

namespace gridscope {

enum class Stretch : uint32_t { x = 0, y = 1, z = 2, automatic = 3 };  // automatic: the axis with the fewest cells, x on a tie
enum class Builder { compute, raster };
enum class NumberBy { file, area };    // order of the references: the file's, or falling triangle area
enum class UpdateMode { all, moved };  // clear and add again every dynamic instance, or only what moved

// What their values are called, on the command line and in every table.
constexpr const char* builderWord(Builder builder) { return builder == Builder::raster ? "raster" : "compute"; }
constexpr const char* numberingWord(NumberBy order) { return order == NumberBy::area ? "area" : "file"; }
constexpr const char* updateWord(UpdateMode update) { return update == UpdateMode::moved ? "moved" : "all"; }
constexpr const char* insertionWord(uint32_t insertion) { return insertion == kInsertionSorted ? "sorted" : "first-come"; }
constexpr const char* overlapWord(uint32_t overlap) { return overlap == kOverlapExact ? "exact" : "plane"; }
constexpr const char* traversalWord(uint32_t traversal) { return traversal == kTraversalDda ? "dda" : "segment"; }

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

struct TraceSettings {
  uint32_t traversal = kTraversalSegment;  // kTraversal...
  float back = 1.0f;                       // how far a segment's window reaches back
  float ahead = 0.75f;                     // how far it reaches beyond the segment's end
  float tMin = 1e-3f;                      // nearest hit that counts
  bool gapFill = true;
  float gate = 1.75f;        // distance along the launch normal before which gaps are not filled
  uint32_t maxSegments = 0;  // 0: enough to cross the grid
};

struct BounceSettings {
  uint32_t seed = 1;
  float roughness = 0.15f;  // 0..1, the most: rougher materials mirror as if they were this glossy; 1: their own
};

struct FrameSettings {
  GridSettings grid;
  TraceSettings trace;
  BounceSettings bounce;
  uint32_t width = 640;  // pixels of gather, rays and hits
  uint32_t height = 360;
  CameraPose camera;
  uint32_t textureSize = 512;  // texels of a diffuse map's side on the device
};

}  // namespace gridscope
