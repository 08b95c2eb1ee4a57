#include "core/scene/built_in_scenes.h"

#include <array>
#include <string>

#include "core/base/error.h"

namespace gridscope {

namespace {

constexpr std::array kBuiltInScenes = {
    BuiltInScene{.name = "hall",
                 .lesson = "a vaulted nave with a glossy floor, ivy, a filigree that saturates its cells, and three teapots",
                 .make = makeHall},
    BuiltInScene{
        .name = "empty-walk", .lesson = "rays that cross a hundred empty cells, one blank slot read in each", .make = makeEmptyWalk},
    BuiltInScene{.name = "saturated-cell",
                 .lesson = "a tuft that fills its cell: later triangles are refused, and gaps are filled with voxel hits",
                 .make = makeSaturatedCell,
                 .cellEdge = 0.25f,
                 .capacity = 16},
    BuiltInScene{.name = "alpha-leaf",
                 .lesson = "hits on the transparent part of a leaf are turned down, and the ray goes on",
                 .make = makeAlphaLeaf,
                 .cells = 48},
    BuiltInScene{.name = "stepped-corner",
                 .lesson = "blades in the corners of cells that cell-sized segments step over, beside blades in the middles",
                 .make = makeSteppedCorner,
                 .cellEdge = 0.25f},
    BuiltInScene{.name = "revisit",
                 .lesson = "two segments start in one cell: the second is skipped, and with a short elongation a hit is lost",
                 .make = makeRevisit,
                 .cellEdge = 0.25f,
                 .ahead = 0.05f},
    BuiltInScene{.name = "mirrored-instances",
                 .lesson = "one mesh eight times: turned, mirrored by its node, by a parent, and by both",
                 .make = makeMirroredInstances,
                 .cells = 64},
    BuiltInScene{.name = "moving-crowd",
                 .lesson = "twelve dynamic instances of which three move: an update of all against one of the moved",
                 .make = [] { return makeMovingCrowd(3); },
                 .cells = 64},
    BuiltInScene{.name = "diagonal",
                 .lesson = "long and thin and large triangles across the whole grid, whose bounding boxes hold every cell",
                 .make = makeDiagonal,
                 .cells = 32},
};

}  // namespace

std::span<const BuiltInScene> builtInScenes() { return kBuiltInScenes; }

const BuiltInScene& findBuiltInScene(std::string_view name) {
  std::string known;
  for (const BuiltInScene& scene : kBuiltInScenes) {
    if (scene.name == name) return scene;
    known += known.empty() ? "" : ", ";
    known += scene.name;
  }
  throw Error("no built-in scene is called '" + std::string(name) + "'; there are " + known);
}

Scene makeBuiltInScene(std::string_view name) { return findBuiltInScene(name).make(); }

}  // namespace gridscope
