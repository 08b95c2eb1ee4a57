// What keys reach that is otherwise clicked: tabs, views, rows (flow.h).
#include <algorithm>
#include <filesystem>

#include "app/model/flow.h"
#include "views/view.h"

namespace gridscope {

// `places` on from `at` among `count`, around at the ends.
static size_t around(size_t at, int places, size_t count) {
  return size_t((int64_t(at) + places % int64_t(count) + int64_t(count)) % int64_t(count));
}

void stepTab(WindowModel& model, int places) { model.showTab(BottomTab(around(size_t(model.bottomTab), places, kBottomTabCount))); }

void stepView(WindowModel& model, int places) {
  const std::span<const View> views = allViews();
  const auto now = std::ranges::find(views, model.panes[size_t(model.activePane)].view, &View::name);
  showView(model, std::string(views[around(now == views.end() ? 0 : size_t(now - views.begin()), places, views.size())].name));
}

std::optional<size_t> rowBeside(std::optional<size_t> selected, int places, size_t count) {
  if (count == 0 || places == 0) return std::nullopt;
  if (!selected || *selected >= count) return places > 0 ? 0 : count - 1;
  return size_t(std::clamp<int64_t>(int64_t(*selected) + places, 0, int64_t(count) - 1));
}

std::string whyNoTime(const WindowModel& model) {
  if (!model.frame || !model.frame->scene) return "No frame yet";
  return model.frame->scene->captureFrames == 1 ? "The capture holds one frame alone" : "";
}

std::string bookmarkKey(const std::string& scene) {
  std::error_code fault;
  if (!std::filesystem::exists(scene, fault)) return scene;  // built in
  const std::filesystem::path whole = std::filesystem::weakly_canonical(std::filesystem::absolute(scene), fault);
  return fault ? scene : whole.string();
}

}  // namespace gridscope
