// The tab "Bookmarks": places of the camera that were kept, and the file's own cameras.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/base/text.h"
#include "app/ui/panels/inspector.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

void goTo(WindowModel& model, const CameraPose& pose) { model.camera.pose = pose; }

void drawKept(WindowModel& model) {
  if (model.bookmarks.empty()) return emptyState("None kept yet. \"Keep this view\" adds one.");
  std::optional<size_t> dropped;
  for (size_t i = 0; i < model.bookmarks.size(); ++i) {
    Bookmark& bookmark = model.bookmarks[i];
    ImGui::PushID(static_cast<int>(i));
    if (keyButton("Go", "")) goTo(model, bookmark.pose);
    ImGui::SameLine(0.0f, unit(6));
    ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - unit(70), unit(60)));
    ImGui::InputText("##name", &bookmark.name);
    ImGui::SameLine(0.0f, unit(6));
    if (keyButton("Drop", "")) dropped = i;
    textDim("from ");
    ImGui::SameLine(0.0f, 0.0f);
    textMono(pointText(bookmark.pose.eye));
    ImGui::PopID();
  }
  if (dropped) model.bookmarks.erase(model.bookmarks.begin() + ptrdiff_t(*dropped));
}

void drawFileCameras(WindowModel& model) {
  const std::vector<CameraPose>& cameras = model.frame->scene->cameras;
  if (cameras.empty()) return emptyState("The file has no cameras.");
  for (size_t i = 0; i < cameras.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (keyButton("Go", "")) goTo(model, cameras[i]);
    ImGui::SameLine(0.0f, unit(8));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(cameras[i].name.empty() ? printed("camera %zu", i + 1).c_str() : cameras[i].name.c_str());
    ImGui::PopID();
  }
}

}  // namespace

void drawBookmarksTab(WindowModel& model) {
  ImGui::Dummy(ImVec2(0.0f, unit(4)));
  if (keyButton("Keep this view", "")) model.bookmarks.push_back({printed("view %zu", model.bookmarks.size() + 1), model.camera.pose});
  ImGui::Dummy(ImVec2(0.0f, unit(4)));
  if (sectionHeader("Kept", std::to_string(model.bookmarks.size()))) drawKept(model);
  if (model.frame && model.frame->scene && sectionHeader("From the file", std::to_string(model.frame->scene->cameras.size())))
    drawFileCameras(model);
}

}  // namespace gridscope
