// See selected_bounds.h.
#include "app/model/selected_bounds.h"

#include "app/frame/camera_moves.h"
#include "app/frame/table_rows.h"
#include "app/model/held_ray.h"

namespace gridscope {

Bounds selectedBounds(const WindowModel& model) {
  Bounds bounds;
  if (!model.frame || !model.frame->scene) return bounds;
  const FrameSnapshot& frame = *model.frame;
  const Selection& selected = model.selected();
  const GridParameters& grid = frame.gridShape();
  const auto includeCell = [&](const ivec3& cell) {
    const vec3 low = grid.origin + vec3(cell) * grid.cellEdge;
    bounds.include(low), bounds.include(low + vec3(grid.cellEdge));
  };
  switch (selected.last) {
    case Selected::nothing: break;
    case Selected::pixel:
      if (rayIsHeld(model)) {
        bounds.include(model.held->ray->ray.origin - vec3(grid.cellEdge)),
            bounds.include(model.held->ray->ray.origin + vec3(grid.cellEdge));
      } else if (selected.pixel && frame.gather && *selected.pixel < frame.gather->size()) {
        const vec3 seen = (*frame.gather)[*selected.pixel].position;
        bounds.include(seen - vec3(grid.cellEdge)), bounds.include(seen + vec3(grid.cellEdge));
      }
      break;
    case Selected::step:
      if (const auto ray = shownRay(model); ray && selected.step < ray->record.steps.size())
        includeCell(ray->record.steps[selected.step].cell);
      break;
    case Selected::cell: includeCell(*selected.cell); break;
    case Selected::triangle: bounds = boundsOfTriangle(frame, *selected.reference); break;
    case Selected::instance: bounds = boundsOfInstance(frame, *selected.instance); break;
  }
  return bounds;
}

std::optional<vec3> selectedPivot(const WindowModel& model) {
  const Bounds bounds = selectedBounds(model);
  if (bounds.empty() || !model.frame->request.settings) return std::nullopt;
  const vec3 middle = 0.5f * (bounds.low + bounds.high);
  return inPicture(model.camera.pose, *model.frame->request.settings, middle) ? std::optional(middle) : std::nullopt;
}

}  // namespace gridscope
