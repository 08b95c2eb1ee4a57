// The tab Plots: one or two histograms, as the width allows, and the stage times of the last frames.
#include "app/ui/panels/plots.h"

#include "app/ui/panels/panels.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

void drawPlots(WindowModel& model) {
  if (!model.frame || !model.frame->scene) return emptyState("No frame yet: it shows here as soon as the first one is done.");
  const ImVec2 start = ImGui::GetCursorScreenPos(), free = ImGui::GetContentRegionAvail();
  const float gap = unit(16), top = start.y + unit(4), bottom = start.y + free.y - unit(2);
  // A histogram wants about 380 pixels, the stage times with their legend about 300.
  const int histograms = free.x >= unit(1000) ? 2 : 1;
  const float stages = free.x * (histograms == 2 ? 0.32f : 0.47f), each = (free.x - stages - gap * float(histograms)) / float(histograms);
  float x = start.x + unit(4);
  for (int place = 0; place < histograms; ++place, x += each + gap) drawHistogram(model, place, ImVec2(x, top), ImVec2(x + each, bottom));
  drawStageTimes(model, ImVec2(x, top), ImVec2(start.x + free.x - unit(2), bottom));
  ImGui::SetCursorScreenPos(start);
  ImGui::Dummy(ImVec2(free.x, free.y - unit(2)));
}

}  // namespace gridscope
