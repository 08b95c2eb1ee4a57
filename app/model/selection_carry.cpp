// See selection_carry.h.
#include "app/model/selection_carry.h"

#include <algorithm>
#include <cmath>

namespace gridscope {

static bool holds(const NumberedScene& numbered, uint32_t reference) {
  const uint32_t instance = referenceInstance(reference);
  return instance < numbered.instanceCount() && referenceTriangle(reference) < numbered.instances[instance].triangleCount;
}

std::optional<uint32_t> referenceOf(const NumberedScene& numbered, const TriangleName& name) {
  for (uint32_t i = 0; i < numbered.instanceCount(); ++i) {
    const InstanceSource& source = numbered.sources[i];
    if (source.sceneInstance != name.sceneInstance || source.mesh != name.mesh) continue;
    const auto first = numbered.meshTriangles.begin() + source.firstTriangle, end = first + numbered.instances[i].triangleCount;
    if (const auto found = std::find(first, end, name.triangle); found != end) return makeReference(i, uint32_t(found - first));
  }
  return std::nullopt;
}

bool sameNumbering(const NumberedScene& a, const NumberedScene& b) {
  const auto sameSource = [](const InstanceSource& x, const InstanceSource& y) {
    return x.sceneInstance == y.sceneInstance && x.mesh == y.mesh && x.firstTriangle == y.firstTriangle;
  };
  return a.instanceCount() == b.instanceCount() &&
         std::equal(a.sources.begin(), a.sources.end(), b.sources.begin(), b.sources.end(), sameSource) &&
         a.meshTriangles == b.meshTriangles;
}

Selection carriedToNumbering(Selection selection, const NumberedScene& before, const NumberedScene& after) {
  selection.slot.reset();  // other references stand in the slots
  if (!selection.reference) return selection;
  if (holds(before, *selection.reference))
    selection.reference = referenceOf(after, nameTriangle(before, *selection.reference));
  else
    selection.reference.reset();
  if (!selection.reference && selection.last == Selected::triangle) selection.last = Selected::nothing;
  return selection;
}

// The same place of the picture, in the middle of pixels.
static uint32_t carried(uint32_t place, uint32_t before, uint32_t after) {
  return std::min(uint32_t((double(place) + 0.5) * double(after) / double(before)), after - 1);
}

Selection carriedToSize(Selection selection, uvec2 before, uvec2 after) {
  if (!selection.pixel) return selection;
  const uvec2 pixel(*selection.pixel % before.x, *selection.pixel / before.x);
  const bool inside = pixel.y < before.y;
  if (inside)
    selection.pixel = carried(pixel.y, before.y, after.y) * after.x + carried(pixel.x, before.x, after.x);
  else
    selection.pixel.reset();
  if (selection.last == Selected::step) selection.last = Selected::pixel;  // of another ray
  if (!inside && selection.last == Selected::pixel) selection.last = Selected::nothing;
  selection.step = 0;
  return selection;
}

std::optional<PixelArea> carriedToSize(const std::optional<PixelArea>& area, uvec2 before, uvec2 after) {
  if (!area) return area;
  PixelArea carried;
  for (int axis = 0; axis < 2; ++axis) {
    const double scale = double(after[axis]) / double(before[axis]);
    carried.begin[axis] = std::clamp(int(std::floor(area->begin[axis] * scale)), 0, int(after[axis]) - 1);
    carried.end[axis] = std::clamp(int(std::ceil(area->end[axis] * scale)), carried.begin[axis] + 1, int(after[axis]));
  }
  return carried;
}

}  // namespace gridscope
