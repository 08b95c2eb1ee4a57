// A histogram of cells or rays with the capacity marked, and the slider below it that sets the colour range of the view of the same values.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "app/base/beside.h"
#include "app/base/text.h"
#include "app/frame/histogram.h"
#include "app/ui/panels/plot_frame.h"
#include "app/ui/panels/plots.h"
#include "app/ui/panels/range_slider.h"
#include "app/ui/panels/table_parts.h"
#include "app/ui/widgets/widgets.h"
#include "views/view.h"

namespace gridscope {

namespace {

constexpr uint32_t kMostBars = 64;

// What can be counted, and which views show the same values; the first is the one to offer.
struct CountedWords {
  Counted what;
  const char* title;
  const char* many;      // of what a bar counts
  const char* unitName;  // of the values
  std::array<const char*, 3> views;
};

constexpr CountedWords kWords[] = {
    {Counted::tried, "References tried per cell", "cells", "references", {"occupancy", "slice", "saturation"}},
    {Counted::stored, "References stored per cell", "cells", "references", {"occupancy", "slice", "saturation"}},
    {Counted::visits, "Cells visited by a ray", "rays", "cells", {"visits", "", ""}},
    {Counted::tests, "Triangles tested by a ray", "rays", "tests", {"tests", "", ""}},
};

// One of the two histograms, kept between display frames.
struct HistogramPanel {
  size_t counted;  // into kWords
  Beside<Histogram> job{};
};

bool ofCells(Counted what) { return what == Counted::stored || what == Counted::tried; }

// The pane that shows these values: the active one, or another of four; null: none.
Pane* paneShowing(WindowModel& model, const CountedWords& words) {
  const auto shows = [&](const Pane& pane) { return std::find(words.views.begin(), words.views.end(), pane.view) != words.views.end(); };
  if (shows(model.panes[size_t(model.activePane)])) return &model.panes[size_t(model.activePane)];
  if (model.layout != ViewportLayout::four) return nullptr;
  const auto found = std::find_if(model.panes.begin(), model.panes.end(), shows);
  return found == model.panes.end() ? nullptr : &*found;
}

// The range that a pane shows: its own, or the one fitted to its values.
ValueRange shownRange(const WindowModel& model, const Pane& pane) {
  if (pane.range) return *pane.range;
  static std::shared_ptr<const Pipeline::ViewImage> fittedTo;
  static ValueRange fitted{0.0f, 1.0f};
  const auto image = model.frame->views.find(pane.view);
  const View* view = findView(pane.view);
  if (image == model.frame->views.end() || !image->second || !view) return fitted;
  if (fittedTo != image->second) {
    fittedTo = image->second;
    fitted = viewRange(*view, image->second->elements, uint32_t(model.frame->parameters.grid.capacity));
  }
  return fitted;
}

void wantHistogram(const WindowModel& model, HistogramPanel& panel) {
  const std::shared_ptr<const FrameSnapshot> frame = model.frame;
  const CountedWords& words = kWords[panel.counted];
  const uint32_t capacity = uint32_t(frame->parameters.grid.capacity);
  const std::vector<const void*> sources = {&words, ofCells(words.what) ? static_cast<const void*>(frame->grid.get()) : frame->hits.get(),
                                            ofCells(words.what) ? nullptr : frame->counters.get()};
  if (!(ofCells(words.what) ? static_cast<bool>(frame->grid) : frame->hits && frame->counters)) return;
  panel.job.want(sources, [frame, what = words.what, capacity] {
    const std::vector<uint32_t> values = countedValues(what, *frame);
    const uint32_t reach = what == Counted::stored ? capacity : what == Counted::tried ? 2 * capacity : reachOf(values);
    return countValues(values, reach, kMostBars + 1);
  });
}

void drawChoice(HistogramPanel& panel, int place, const ImVec2& low, float width) {
  ImGui::SetCursorScreenPos(ImVec2(low.x - unit(4), low.y));
  ImGui::PushID(place);
  ImGui::PushStyleColor(ImGuiCol_FrameBg, ImVec4(0, 0, 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(unit(4), unit(2)));
  ImGui::PushFont(windowFonts().sansBold);
  const float wanted = ImGui::CalcTextSize(kWords[panel.counted].title).x + unit(36);
  ImGui::SetNextItemWidth(std::min(width, wanted));
  const bool open = ImGui::BeginCombo("##counted", kWords[panel.counted].title);
  ImGui::PopFont();
  if (open) {
    for (size_t index = 0; index < std::size(kWords); ++index)
      if (ImGui::Selectable(kWords[index].title, index == panel.counted)) panel.counted = index;
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ImGui::PopID();
}

std::string barText(const Histogram& histogram, size_t bar, const CountedWords& words) {
  const uint64_t first = uint64_t(bar) * histogram.width;
  const bool open = histogram.lastIsOpen && bar + 1 == histogram.counts.size();
  std::string range = grouped(first);
  if (open)
    range += " to " + grouped(histogram.largest);
  else if (histogram.width > 1)
    range += " to " + grouped(first + histogram.width - 1);
  return range + " " + words.unitName + ": " + grouped(histogram.counts[bar]) + " " + words.many + ", " +
         percentOf(histogram.counts[bar], histogram.total);
}

struct BarColours {
  uint32_t map;
  ValueRange range;
  std::optional<uint32_t> capacity;  // above it: pink and hatched
};

void drawBars(const PlotFrame& plot, const Histogram& histogram, const BarColours& colours, const CountedWords& words) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  std::optional<size_t> under;
  for (size_t bar = 0; bar < histogram.counts.size(); ++bar) {
    const double value = double(bar) * histogram.width;
    const ImVec2 low(plot.x(value - 0.5 * histogram.width), plot.low().y), high(plot.x(value + 0.5 * histogram.width), plot.high().y);
    const float gap = high.x - low.x > unit(4) ? unit(1) : 0.0f;
    if (plot.hovered() && ImGui::GetIO().MousePos.x >= low.x && ImGui::GetIO().MousePos.x < high.x) under = bar;
    if (histogram.counts[bar] == 0) continue;
    const ImVec2 top(low.x, plot.y(double(histogram.counts[bar]))), bottom(high.x - gap, plot.high().y);
    const bool beyond = colours.capacity && value > *colours.capacity;
    const vec3 mapped = colourMap(colours.map, float((value - colours.range[0]) / std::max(1e-6f, colours.range[1] - colours.range[0])));
    const ImVec4 colour = beyond ? meaningColour(kColourSaturated) : ImVec4(mapped.x, mapped.y, mapped.z, 1.0f);
    list->AddRectFilled(top, bottom, packed(colour));
    if (beyond) hatch(list, top, bottom, packed(ImVec4(colour.x * 0.62f, colour.y * 0.62f, colour.z * 0.62f, 1.0f)));
  }
  if (!under) return;
  const double value = double(*under) * histogram.width;
  ImVec4 glow = uiColour(UiColour::text);
  glow.w = 0.12f;
  list->AddRectFilled(ImVec2(plot.x(value - 0.5 * histogram.width), plot.low().y),
                      ImVec2(plot.x(value + 0.5 * histogram.width), plot.high().y), packed(glow));
  ImGui::SetTooltip("%s", barText(histogram, *under, words).c_str());
}

void drawCapacity(const WindowModel& model, const PlotFrame& plot, uint32_t capacity) {
  const GridTotals& totals = model.frame->totals;
  const float x = plot.x(capacity + 0.5);
  dashedLine(x, plot.low().y, plot.high().y, packed(uiColour(UiColour::text)));
  const std::string left = "capacity " + std::to_string(capacity);
  const std::string right = grouped(totals.statistics.saturated) + " saturated cells refuse " + grouped(totals.refused());
  const float leftWidth = plotTextWidth(left, false), rightWidth = plotTextWidth(right, false), y = plot.low().y - unit(1);
  // Dark behind the words, so that bars below them do not hide them.
  const auto word = [&](float place, const std::string& text, const ImVec4& colour) {
    ImVec4 ground = uiColour(UiColour::panel);
    ground.w = 0.8f;
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(place - unit(2), y),
                                              ImVec2(place + plotTextWidth(text, false) + unit(2), y + unit(15)), packed(ground));
    plotText(ImVec2(place, y), text, colour, false);
  };
  if (x - leftWidth - unit(5) > plot.low().x) word(x - leftWidth - unit(5), left, uiColour(UiColour::text));
  if (totals.statistics.saturated > 0 && x + rightWidth + unit(5) < plot.high().x)
    word(x + unit(5), right, meaningColour(kColourSaturated));
}

// The slider below the axis, and the buttons that fit its range or show the view that it belongs to.
void drawRange(WindowModel& model, const PlotFrame& plot, const PlotScale& scale, const CountedWords& words) {
  Pane* pane = paneShowing(model, words);
  ValueRange range = pane ? shownRange(model, *pane) : ValueRange{float(scale.low), float(scale.high)};
  const float top = plot.high().y + unit(18);
  if (rangeSlider(words.title, {plot.low().x, top, plot.high().x - plot.low().x}, scale, range, pane != nullptr)) {
    range = {std::max(0.0f, std::round(range[0])), std::round(range[1])};
    if (range[0] < range[1]) pane->range = range;
  }
  const View* view = findView(pane ? std::string_view(pane->view) : std::string_view(words.views[0]));
  const std::string name = view ? std::string(view->title) : words.views[0];
  if (pane)
    whyTooltip(("Colour range of the view " + name + ": " + plotNumber(range[0]) + " to " + plotNumber(range[1])).c_str());
  else
    whyTooltip(("No view shows these values now; show " + name + " to set its range here").c_str());
}

void drawButtons(WindowModel& model, const CountedWords& words, float right, float top) {
  Pane* pane = paneShowing(model, words);
  const std::string label = pane ? "Fit  R" : std::string("Show ") + words.views[0];
  ImGui::SetCursorScreenPos(ImVec2(right - smallButtonWidth(label.c_str()) - unit(4), top + unit(1)));
  const bool possible = !pane || pane->range.has_value();
  if (!smallButton(label.c_str(), words.title, pane ? "Fits the colour range to the values" : "Shows the view of these values", possible,
                   "The range is fitted to the values already"))
    return;
  if (pane)
    pane->range.reset();
  else
    model.panes[size_t(model.activePane)] = Pane{.view = words.views[0]};
}

}  // namespace

void drawHistogram(WindowModel& model, int place, const ImVec2& low, const ImVec2& high) {
  static std::array<HistogramPanel, 2> panels{HistogramPanel{0}, HistogramPanel{2}};
  HistogramPanel& panel = panels[size_t(place)];
  drawChoice(panel, place, low, high.x - low.x - unit(paneShowing(model, kWords[panel.counted]) ? 64.0f : 112.0f));
  const CountedWords words = kWords[panel.counted];
  wantHistogram(model, panel);
  drawButtons(model, words, high.x, low.y);
  const std::optional<Histogram>& histogram = panel.job.value();
  if (!histogram || histogram->counts.empty()) {
    plotText(ImVec2(low.x, low.y + unit(30)),
             !histogram ? "Counting..." : "Nothing counted: show the view " + std::string(words.views[0]) + " once.",
             uiColour(UiColour::dim), false);
    return;
  }

  const double width = histogram->width, capacity = model.frame->parameters.grid.capacity;
  const double end = std::max(double(histogram->counts.size() - 1) * width, words.what == Counted::stored ? capacity : 1.0);
  const PlotScale x{.low = 0.0, .high = end}, y = scaleOfTens(0.7, std::max<double>(10.0, double(histogram->most())));
  PlotLook look{.x = x, .y = {.low = 0.7, .high = y.high, .logarithmic = true}, .footHeight = 16.0f};
  const PlotFrame plot(look, low, high);
  if (!plot.drawn()) return;
  const Pane* pane = paneShowing(model, words);
  const ValueRange fitted{0.0f, ofCells(words.what) ? float(capacity) : float(end)};
  drawBars(plot, *histogram,
           {.map = model.colourMap,
            .range = pane ? shownRange(model, *pane) : fitted,
            .capacity = ofCells(words.what) ? std::optional(uint32_t(capacity)) : std::nullopt},
           words);
  if (ofCells(words.what)) drawCapacity(model, plot, uint32_t(capacity));
  drawRange(model, plot, x, words);
}

}  // namespace gridscope
