// The stage times of the last frames, one upon the other, with the changes of settings marked.
#include <algorithm>
#include <array>

#include "app/base/text.h"
#include "app/frame/stage_history.h"
#include "app/ui/panels/plot_frame.h"
#include "app/ui/panels/plots.h"
#include "app/ui/widgets/widgets.h"

namespace gridscope {

namespace {

struct Stage {
  const char* name;
  uint32_t colour;  // 0xRRGGBB
  double (*time)(const StageTimes&);
};

// From the bottom of the plot to its top.
constexpr std::array<Stage, 6> kStages{{
    {"view", 0x8A95A1u, [](const StageTimes& times) { return times.views; }},
    {"bounce", 0x9A8BC0u, [](const StageTimes& times) { return times.bounce; }},
    {"gather", 0x5FA89Au, [](const StageTimes& times) { return times.gather; }},
    {"update", 0xE0876Au, [](const StageTimes& times) { return times.clear + times.add; }},
    {"build", 0xC9A950u, [](const StageTimes& times) { return times.build; }},
    {"trace", 0x7F93ADu, [](const StageTimes& times) { return times.trace; }},
}};
constexpr size_t kBuild = 4;

using Stack = std::array<double, kStages.size()>;

// What each stage took in a frame. The build counts where it ran: its time then differs from the frame before.
std::vector<Stack> stacksOf(const StageHistory& history) {
  std::vector<Stack> stacks;
  double build = -1.0;
  for (const StageMoment& moment : history.moments()) {
    Stack stack;
    for (size_t stage = 0; stage < kStages.size(); ++stage) stack[stage] = std::max(0.0, kStages[stage].time(moment.times));
    if (stack[kBuild] == build)
      stack[kBuild] = 0.0;
    else
      build = stack[kBuild];
    stacks.push_back(stack);
  }
  return stacks;
}

double sumOf(const Stack& stack) {
  double sum = 0.0;
  for (const double time : stack) sum += time;
  return sum;
}

ImVec4 stageColour(size_t stage) {
  const vec3 colour = unpackColour(kStages[stage].colour);
  return ImVec4(colour.x, colour.y, colour.z, 1.0f);
}

void drawStacks(const PlotFrame& plot, const std::vector<Stack>& stacks) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (size_t at = 0; at < stacks.size(); ++at) {
    const double frame = double(at) - double(stacks.size()) + 1.0;
    const float left = plot.x(frame - 0.5), right = plot.x(frame + 0.5);
    double sum = 0.0;
    for (size_t stage = 0; stage < kStages.size(); ++stage) {
      const float bottom = plot.y(sum);
      sum += stacks[at][stage];
      const float top = plot.y(sum);
      if (bottom - top > 0.1f) list->AddRectFilled(ImVec2(left, top), ImVec2(right, bottom), packed(stageColour(stage)));
    }
  }
}

void drawChanges(const PlotFrame& plot, const StageHistory& history) {
  float free = plot.low().x;
  for (size_t at = 0; at < history.moments().size(); ++at) {
    const std::string& change = history.moments()[at].change;
    if (change.empty()) continue;
    const float x = plot.x(double(at) - double(history.moments().size()) + 0.5), width = plotTextWidth(change, false);
    dashedLine(x, plot.low().y, plot.high().y, packed(uiColour(UiColour::text)));
    if (x < free || x + width + unit(4) > plot.high().x) continue;
    ImVec4 ground = uiColour(UiColour::panel);
    ground.w = 0.8f;
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x + unit(2), plot.low().y), ImVec2(x + width + unit(6), plot.low().y + unit(15)),
                                              packed(ground));
    plotText(ImVec2(x + unit(4), plot.low().y), change, uiColour(UiColour::text), false);
    free = x + width + unit(10);
  }
}

// Name and milliseconds of each stage, the topmost first, and their sum.
void drawLegend(const PlotFrame& plot, const StageTimes& times, const Stack& last, float right) {
  const float left = plot.high().x + unit(12), line = std::clamp((plot.high().y - plot.low().y) / 7.0f, unit(13), unit(19));
  float y = plot.low().y - unit(2);
  const auto row = [&](const char* name, double time, const ImVec4* colour) {
    const std::string text = printed(time < 10.0 ? "%.2f" : "%.0f", time);
    if (colour) ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(left, y + unit(3)), ImVec2(left + unit(8), y + unit(11)), packed(*colour));
    plotText(ImVec2(left + (colour ? unit(13) : 0.0f), y), name, uiColour(colour ? UiColour::dim : UiColour::text), false);
    plotText(ImVec2(right - unit(4) - plotTextWidth(text, true), y), text, uiColour(UiColour::text), true);
    y += line;
  };
  for (size_t stage = kStages.size(); stage-- > 0;) {
    const ImVec4 colour = stageColour(stage);
    row(kStages[stage].name, kStages[stage].time(times), &colour);
  }
  row("ms a frame", sumOf(last), nullptr);
}

void drawReadOut(const PlotFrame& plot, const StageHistory& history, const std::vector<Stack>& stacks) {
  if (!plot.hovered()) return;
  const int at = int(std::lround(plot.mouseX())) + int(stacks.size()) - 1;
  if (at < 0 || at >= int(stacks.size())) return;
  const float x = plot.x(double(at) - double(stacks.size()) + 1.0);
  ImGui::GetWindowDrawList()->AddLine(ImVec2(x, plot.low().y), ImVec2(x, plot.high().y), packed(uiColour(UiColour::text)), 1.0f);
  std::string text = at + 1 == int(stacks.size()) ? "the last frame" : grouped(stacks.size() - 1 - size_t(at)) + " frames ago";
  text += printed(": %.2f ms", sumOf(stacks[size_t(at)]));
  for (size_t stage = kStages.size(); stage-- > 0;) text += printed("\n%-8s %8.2f ms", kStages[stage].name, stacks[size_t(at)][stage]);
  if (!history.moments()[size_t(at)].change.empty()) text += "\n" + history.moments()[size_t(at)].change;
  ImGui::PushFont(windowFonts().mono);
  ImGui::SetTooltip("%s", text.c_str());
  ImGui::PopFont();
}

}  // namespace

void drawStageTimes(WindowModel& model, const ImVec2& low, const ImVec2& high) {
  const std::vector<Stack> stacks = stacksOf(model.stageHistory);
  double highest = 0.0;
  for (const Stack& stack : stacks) highest = std::max(highest, sumOf(stack));
  PlotLook look{.title = "Stage times, last 200 frames",
                .note = "ms",
                .x = {.low = -double(StageHistory::kMost) + 0.5, .high = 0.5},
                .y = scaleFromZero(highest),
                .legendWidth = 108.0f,
                .footHeight = 16.0f,
                .ticksX = false};
  const PlotFrame plot(look, low, high);
  if (!plot.drawn()) return;
  const float labels = plot.high().y + unit(3);
  plotText(ImVec2(plot.low().x, labels), "-200", uiColour(UiColour::dim), true);
  if (plot.high().x - plot.low().x > unit(130))
    plotText(ImVec2(0.5f * (plot.low().x + plot.high().x - plotTextWidth("-100", true)), labels), "-100", uiColour(UiColour::dim), true);
  plotText(ImVec2(plot.high().x - plotTextWidth("now", true), labels), "now", uiColour(UiColour::dim), true);
  if (stacks.empty()) return;
  drawStacks(plot, stacks);
  drawChanges(plot, model.stageHistory);
  drawLegend(plot, model.frame->times, stacks.back(), high.x);
  drawReadOut(plot, model.stageHistory, stacks);
}

}  // namespace gridscope
