// Plain values that say how a frame is shown and what of it: panes and where they look, overlays, the camera, a rectangle, an order of rays.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "views/picture.h"

namespace gridscope {

// How one view of the viewport is shown.
struct Pane {
  std::string view = "final";
  std::optional<ValueRange> range;  // not given: fitted to the values
};

// Where in the frame the viewport looks. Linked panes share one.
struct ViewportPlace {
  float zoom = 0.0f;  // screen pixels a frame pixel; 0: the frame fits
  vec2 centre{0.5f};  // of the frame's width and height
};

struct Overlays {
  bool cellBoxes = false;
  size_t boxMeasure = 0;                    // what chooses and colours the boxes: of boxMeasures()
  std::array<int, 2> boxRange{1, 1 << 30};  // its values whose boxes are drawn
  bool saturatedBoxes = false;
  bool raySegments = true;
  bool visitedCells = true;
  bool testedTriangles = true;
  bool selection = true;
  bool dimmed = false;  // the picture, under a ray
  bool lens = true;     // on the selected step's cell, where it is small in the picture
  bool clip = false;    // only what lies in clipBox
  Bounds clipBox;       // world
};

enum class CameraMode { orbit, fly };

struct CameraState {
  CameraPose pose;  // what the frame is gathered from
  CameraMode mode = CameraMode::orbit;
  float speed = 1.0f;  // of flying, world units a second
  bool zUp = false;
};

struct Bookmark {
  std::string name;
  CameraPose pose;
};

// Rectangle of pixels that filters the tables; end behind the last.
struct PixelArea {
  ivec2 begin{0};
  ivec2 end{0};
};

// The ray order of the Rays table: previous and next ray follow it.
struct RayOrder {
  std::vector<uint32_t> pixels;   // as the table shows them, filters applied
  std::string name = "by pixel";  // "Rays, by tests"
};

}  // namespace gridscope
