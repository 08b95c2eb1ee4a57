// See drag.h. drag_handle.h works out the way.
#include "app/ui/viewport/drag.h"

#include <array>
#include <cmath>

#include "app/frame/instance_edits.h"
#include "app/frame/projection.h"
#include "app/frame/table_rows.h"
#include "app/model/drag_handle.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

constexpr float kArm = 58.0f, kHandle = 7.0f;  // pixels at UI scale 1
constexpr float kMostOffset = 1e6f;            // world units

// The drag that goes on, as it began.
struct Drag {
  DragWay way = DragWay::plane;
  CameraParameters camera{};
  vec3 centre{0.0f}, offset{0.0f};
  vec2 from{0.0f};
};

std::optional<Drag>& currentDrag() {
  static std::optional<Drag> drag;
  return drag;
}

ImU32 handleColour(DragWay way) {
  constexpr ImU32 kColours[] = {IM_COL32(224, 122, 95, 255), IM_COL32(129, 178, 80, 255), IM_COL32(96, 148, 224, 255),
                                IM_COL32(255, 255, 255, 255)};
  return kColours[int(way)];
}

// Where a handle stands: at the centre, or at the end of an arm as long on the screen whatever the distance.
std::optional<ImVec2> handlePlace(const PaneRect& pane, const vec3& centre, DragWay way) {
  vec3 point = centre;
  if (way != DragWay::plane) point[int(way)] += worldPerPixel(pane.camera, centre) * unit(kArm) / pane.scale;
  const auto projected = projectPoint(pane.camera, point);
  return projected ? std::optional(pane.toScreen(projected->pixel)) : std::nullopt;
}

void dragHandle(WindowModel& model, const PaneRect& pane, const InstanceEdit& edit, const vec3& centre, DragWay way) {
  const std::optional<ImVec2> middle = handlePlace(pane, centre, DragWay::plane), end = handlePlace(pane, centre, way);
  if (!middle || !end) return;
  const float half = unit(kHandle);
  ImGui::PushID(int(way));
  ImGui::SetCursorScreenPos({end->x - half, end->y - half});
  ImGui::InvisibleButton("handle", {2.0f * half, 2.0f * half});
  ImGui::SetItemAllowOverlap();
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (ImGui::IsItemActivated()) currentDrag() = Drag{way, pane.camera, centre, edit.offset, pane.toPixel(ImGui::GetIO().MousePos)};
  if (ImGui::IsItemActive() && currentDrag()) {
    const Drag& drag = *currentDrag();
    InstanceEdit moved = edit;
    moved.offset = drag.offset + dragOffset(drag.camera, drag.centre, drag.way, drag.from, pane.toPixel(ImGui::GetIO().MousePos));
    if (glm::length(moved.offset) < kMostOffset) setEdit(model.request.edits, moved);
  }
  if (ImGui::IsItemDeactivated()) currentDrag().reset();
  whyTooltip(way == DragWay::plane ? "Drag: moves the instance across the view" : "Drag: moves the instance along this axis");
  ImGui::PopID();

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = lit ? IM_COL32(255, 222, 120, 255) : handleColour(way);
  if (way == DragWay::plane) {
    list.AddRectFilled({end->x - half - 1, end->y - half - 1}, {end->x + half + 1, end->y + half + 1}, IM_COL32(0, 0, 0, 150), unit(2));
    list.AddRectFilled({end->x - unit(5), end->y - unit(5)}, {end->x + unit(5), end->y + unit(5)}, colour, unit(1));
    return;
  }
  list.AddLine(*middle, *end, IM_COL32(0, 0, 0, 150), unit(5));
  list.AddLine(*middle, *end, colour, unit(2.4f));
  list.AddCircleFilled(*end, unit(6), colour);
}

}  // namespace

void dragInstance(WindowModel& model, const PaneRect& pane) {
  const Selection& selected = model.selected();
  if (selected.last != Selected::instance || !selected.instance || !model.frame->worldTriangles) return;
  const InstanceEdit* found = editOf(model.request.edits, *selected.instance);
  if (!isMadeDynamic(found)) return;
  const InstanceEdit edit = *found;
  const Bounds bounds = boundsOfInstance(*model.frame, *selected.instance);
  if (bounds.empty()) return;
  vec3 centre = 0.5f * (bounds.low + bounds.high);
  if (const auto& drag = currentDrag()) centre = drag->centre + edit.offset - drag->offset;
  for (const DragWay way : {DragWay::x, DragWay::y, DragWay::z, DragWay::plane}) dragHandle(model, pane, edit, centre, way);
}

}  // namespace gridscope
