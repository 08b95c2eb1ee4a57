// The left panel's lower half: what changes the picture alone. Overlays, camera, bookmarks.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/base/text.h"
#include "app/frame/camera_moves.h"
#include "app/frame/cell_boxes.h"
#include "app/ui/panels/range_slider.h"
#include "app/ui/shell/layout.h"
#include "app/ui/widgets/action_button.h"
#include "app/ui/widgets/rows.h"

namespace gridscope {

namespace {

// What the boxes show, and two handles over its values, in doublings; the last place stands for all that is above.
void drawBoxRange(WindowModel& model) {
  Overlays& o = model.overlays;
  rowLabel("by", "What a box's colour shows, and which boxes are drawn");
  if (ImGui::BeginCombo("##measure", boxMeasure(o).name)) {
    for (size_t i = 0; i < boxMeasures().size(); ++i)
      if (ImGui::Selectable(boxMeasures()[i].name, i == o.boxMeasure)) o.boxMeasure = i, o.boxRange = Overlays().boxRange;
    ImGui::EndCombo();
  }
  const float most = 16.0f * float(model.frame->parameters.grid.capacity);
  const PlotScale scale{1.0, double(most), true};
  std::array<float, 2> range{float(o.boxRange[0]), std::min(float(o.boxRange[1]), most)};
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float words = unit(94), width = ImGui::GetContentRegionAvail().x - words;
  if (rangeSlider("##boxes", {low.x + unit(4), low.y + unit(2), width - unit(12)}, scale, range, true))
    o.boxRange = {int(std::lround(range[0])), range[1] >= 0.99f * most ? Overlays().boxRange[1] : int(std::lround(range[1]))};
  ImGui::SetCursorScreenPos({low.x + width, low.y});
  textMono(printed("%d \u2026 ", o.boxRange[0]) + (o.boxRange[1] >= Overlays().boxRange[1] ? "most" : std::to_string(o.boxRange[1])));
}

void drawOverlaySwitches(WindowModel& model) {
  Overlays& o = model.overlays;
  const int on =
      o.cellBoxes + o.saturatedBoxes + o.raySegments + o.visitedCells + o.testedTriangles + o.dimmed + o.lens + o.selection + o.clip;
  if (!sectionHeader("Overlays", printed("%d on", on))) return;
  ImGui::Checkbox("Cell boxes", &o.cellBoxes);
  if (o.cellBoxes) {
    drawBoxRange(model);
  }
  ImGui::Checkbox("Saturated cells", &o.saturatedBoxes);
  ImGui::SameLine();
  swatch(kColourSaturated, true);
  ImGui::NewLine();
  ImGui::Checkbox("Ray segments by outcome", &o.raySegments);
  ImGui::Checkbox("Cells the ray visited", &o.visitedCells);
  ImGui::Checkbox("Tested triangles", &o.testedTriangles);
  ImGui::Checkbox("Dim the picture under a ray", &o.dimmed);
  ImGui::Checkbox("Lens on the step's cell", &o.lens);
  ImGui::Checkbox("Selection", &o.selection);
  ImGui::Checkbox("Clip box", &o.clip);
  if (!o.clip || !model.frame->scene) return;
  const Bounds& bounds = model.frame->scene->bounds;
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::PushID(axis);
    rowLabel(printed("%c from, to", "xyz"[axis]).c_str());
    const float speed = 0.002f * std::max(bounds.high[axis] - bounds.low[axis], 1e-3f);
    ImGui::DragFloatRange2("##clip", &o.clipBox.low[axis], &o.clipBox.high[axis], speed, bounds.low[axis], bounds.high[axis], "%.2f");
    ImGui::PopID();
  }
}

void drawCamera(WindowModel& model) {
  CameraState& camera = model.camera;
  if (!sectionHeader("Camera", camera.mode == CameraMode::orbit ? "Orbit" : "Fly")) return;
  const std::vector<CameraPose>& cameras = model.frame->scene->cameras;
  rowLabel("File's camera");
  if (ImGui::BeginCombo("##cameras", camera.pose.name.empty() ? "moved" : camera.pose.name.c_str())) {
    for (const CameraPose& one : cameras)
      if (ImGui::Selectable(one.name.c_str())) camera.pose = one;
    ImGui::EndCombo();
  }
  ImGui::PushFont(windowFonts().mono);
  const float speed = 0.01f * std::max(camera.speed, 1e-4f);
  CameraPose wanted = camera.pose;
  rowLabel("Position");
  bool changed = ImGui::DragFloat3("##eye", &wanted.eye.x, speed, 0, 0, "%.2f");
  rowLabel("Looks at");
  changed |= ImGui::DragFloat3("##target", &wanted.target.x, speed, 0, 0, "%.2f");
  if (changed && wanted.eye != wanted.target && glm::length(wanted.eye) < 1e6f && glm::length(wanted.target) < 1e6f) camera.pose = wanted;
  rowLabel("Field of view");
  fillSlider("##fov", camera.pose.verticalFovDegrees, {5.0f, 150.0f}, "%.1f deg");
  camera.pose.verticalFovDegrees = std::clamp(camera.pose.verticalFovDegrees, 1.0f, 170.0f);
  rowLabel("Speed", "Of flying: hold the right mouse button and W A S D Q E");
  ImGui::DragFloat("##speed", &camera.speed, 0.01f * camera.speed, 1e-4f, 1e5f, "%.2f /s",
                   ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
  ImGui::PopFont();
  rowLabel("Up axis");
  int up = camera.zUp ? 1 : 0;
  if (ImGui::Combo("##up", &up, "y\0z\0")) {
    camera.zUp = up == 1;
    camera.pose.up = worldUp(camera);
  }
  actionButton(model, "Reset camera", "Reset##camera");
}

void drawBookmarks(WindowModel& model) {
  if (!sectionHeader("Bookmarks", printed("%zu", model.bookmarks.size()), false)) return;
  static std::string name;
  ImGui::SetNextItemWidth(-unit(70));
  const bool entered = ImGui::InputTextWithHint("##name", "Name of this view", &name, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if (ImGui::Button("Keep", {unit(60), 0}) || entered) {
    model.bookmarks.push_back({name.empty() ? printed("view %zu", model.bookmarks.size() + 1) : name, model.camera.pose});
    name.clear();
  }
  size_t removed = model.bookmarks.size();
  for (size_t i = 0; i < model.bookmarks.size(); ++i) {
    ImGui::PushID(int(i));
    if (ImGui::Selectable(model.bookmarks[i].name.c_str(), false, 0, {ImGui::GetContentRegionAvail().x - unit(26), 0}))
      model.camera.pose = model.bookmarks[i].pose;
    ImGui::SameLine();
    if (ImGui::SmallButton("x")) removed = i;
    ImGui::PopID();
  }
  if (removed < model.bookmarks.size()) model.bookmarks.erase(model.bookmarks.begin() + ptrdiff_t(removed));
}

}  // namespace

void drawViewSettings(WindowModel& model) {
  drawOverlaySwitches(model);
  drawCamera(model);
  drawBookmarks(model);
}

}  // namespace gridscope
