// The scenes that are made in code and need no file: the hall, shown when no scene is named, and small ones that each teach
// one behaviour of a fixed-capacity grid.
#pragma once

#include <span>
#include <string_view>

#include "core/scene/scene.h"

namespace gridscope {

// A scene with the settings under which its lesson shows. A setting that is 0 is left to the tool's default.
struct BuiltInScene {
  std::string_view name;
  std::string_view lesson;  // one line
  Scene (*make)() = nullptr;
  uint32_t cells = 0;     // along the longest side
  float cellEdge = 0.0f;  // metres; used instead of cells by lessons that need to know where the cell faces are
  uint32_t capacity = 0;  // slots a cell
  float ahead = 0.0f;     // elongation of a segment, in cell edges
  uint32_t width = 0;     // picture, pixels
  uint32_t height = 0;
};

// All of them, the hall first.
std::span<const BuiltInScene> builtInScenes();

// The entry of that name; throws an Error that lists the known ones.
const BuiltInScene& findBuiltInScene(std::string_view name);

// Makes the scene of that name; throws as findBuiltInScene does.
Scene makeBuiltInScene(std::string_view name);

Scene makeHall();
Scene makeEmptyWalk();
Scene makeSaturatedCell();
Scene makeAlphaLeaf();
Scene makeSteppedCorner();
Scene makeRevisit();
Scene makeMirroredInstances();
Scene makeDiagonal();

// Twelve dynamic instances, of which the first movingCount (at most 12) move and the rest stand still.
inline constexpr uint32_t kCrowdCount = 12;
Scene makeMovingCrowd(uint32_t movingCount);

}  // namespace gridscope
