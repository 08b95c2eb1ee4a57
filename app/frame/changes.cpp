// See changes.h.
#include "app/frame/changes.h"

#include <tuple>

#include "app/frame/scene_edits.h"

namespace gridscope {

static bool sameBounds(const std::optional<Bounds>& a, const std::optional<Bounds>& b) {
  return a.has_value() == b.has_value() && (!a || (a->low == b->low && a->high == b->high));
}

// Without the order of the references, which the numbering is about. The builder does not change a bit, but who chooses it wants to see it run.
bool sameGrid(const GridSettings& a, const GridSettings& b) {
  auto values = [](const GridSettings& s) {
    return std::make_tuple(s.cells, s.cellEdge, s.capacity, s.stretch, s.builder, s.insertion, s.overlap, s.enlargement, s.update);
  };
  return values(a) == values(b) && sameBounds(a.bounds, b.bounds);
}

bool sameTrace(const TraceSettings& a, const TraceSettings& b) {
  auto values = [](const TraceSettings& s) {
    return std::make_tuple(s.traversal, s.back, s.ahead, s.tMin, s.gapFill, s.gate, s.maxSegments);
  };
  return values(a) == values(b);
}

bool sameBounce(const BounceSettings& a, const BounceSettings& b) { return a.seed == b.seed && a.roughness == b.roughness; }

bool sameCamera(const CameraPose& a, const CameraPose& b) {
  return a.eye == b.eye && a.target == b.target && a.up == b.up && a.verticalFovDegrees == b.verticalFovDegrees;
}

bool sameSettings(const FrameSettings& a, const FrameSettings& b) {
  return sameGrid(a.grid, b.grid) && a.grid.numberBy == b.grid.numberBy && sameTrace(a.trace, b.trace) && sameBounce(a.bounce, b.bounce) &&
         sameCamera(a.camera, b.camera) && a.width == b.width && a.height == b.height && a.textureSize == b.textureSize;
}

FrameChanges& FrameChanges::add(const FrameChanges& other) {
  source |= other.source, scene |= other.scene, size |= other.size, grid |= other.grid, build |= other.build, update |= other.update;
  gather |= other.gather, bounce |= other.bounce, trace |= other.trace, slice |= other.slice;
  spread();
  return *this;
}

void FrameChanges::spread() {
  scene |= source;
  grid |= scene;
  size |= scene;
  build |= grid;
  update |= build;
  gather |= size || scene;
  bounce |= gather;
  trace |= bounce || update;
}

FrameChanges changesBetween(const FrameRequest& before, const FrameRequest& after) {
  const FrameSettings &a = *before.settings, &b = *after.settings;
  FrameChanges changes;
  changes.source = before.source != after.source;
  const bool editsDiffer = before.edits != after.edits;
  const bool onlyMoved = editsDiffer && differInOffsetsAlone(before.edits, after.edits);
  const bool timeDiffers = before.timeSeconds != after.timeSeconds;
  changes.scene = (editsDiffer && !onlyMoved) || a.grid.numberBy != b.grid.numberBy || a.textureSize != b.textureSize;
  changes.size = a.width != b.width || a.height != b.height;
  changes.grid = !sameGrid(a.grid, b.grid);
  changes.update = onlyMoved || timeDiffers;
  changes.gather = changes.update || !sameCamera(a.camera, b.camera);
  changes.bounce = before.frame != after.frame || !sameBounce(a.bounce, b.bounce);
  changes.trace = !sameTrace(a.trace, b.trace);
  changes.slice = before.slice.axis != after.slice.axis || before.slice.index != after.slice.index;
  changes.spread();
  return changes;
}

}  // namespace gridscope
