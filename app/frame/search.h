// What a person means by a few words: "pixel 214,192", "cell 72,4,47", "72,4,47", "triangle thorn 3106", "0x00000C22", a name.
#pragma once

#include <optional>
#include <string>

#include "app/frame/snapshot.h"

namespace gridscope {

// Exactly one is given.
struct SearchTarget {
  std::optional<uint32_t> pixel;
  std::optional<ivec3> cell;
  std::optional<uint32_t> reference;  // triangle
  std::optional<uint32_t> instance;   // of the scene
};

// Two numbers are a pixel, three a cell, whatever stands before them; a hexadecimal number is a reference; a mesh's name with a number behind
// is its triangle; everything else the first instance whose name or mesh's name holds the words. Nothing: the frame has no such thing.
std::optional<SearchTarget> findTarget(const FrameSnapshot& frame, const std::string& words);

}  // namespace gridscope
