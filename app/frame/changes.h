// Which stages must run again when a request follows another. Each stage feeds those behind it.
#pragma once

#include "app/frame/request.h"

namespace gridscope {

// What no longer holds. `after` it, everything below in this list that reads it does not hold either: see spread().
struct FrameChanges {
  bool source = false;  // scene or capture
  bool scene = false;   // numbering: edits, order of the references, texture size
  bool size = false;    // of the frame
  bool grid = false;    // settings of the grid
  bool build = false;
  bool update = false;
  bool gather = false;
  bool bounce = false;
  bool trace = false;
  bool slice = false;  // the layer that the view `slice` shows
  bool operator==(const FrameChanges&) const = default;

  FrameChanges& add(const FrameChanges& other);
  void spread();  // what a change feeds changes too
  bool any() const { return *this != FrameChanges{}; }
};

// Of two requests with settings.
FrameChanges changesBetween(const FrameRequest& before, const FrameRequest& after);

// Do these hold the same, bit for bit?
bool sameGrid(const GridSettings& a, const GridSettings& b);
bool sameTrace(const TraceSettings& a, const TraceSettings& b);
bool sameBounce(const BounceSettings& a, const BounceSettings& b);
bool sameCamera(const CameraPose& a, const CameraPose& b);

// The same for all settings of a frame.
bool sameSettings(const FrameSettings& a, const FrameSettings& b);

}  // namespace gridscope
