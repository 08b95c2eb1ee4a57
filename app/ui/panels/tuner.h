// The parts of the tuner: what they share, and each.
#pragma once

#include <imgui.h>

#include <optional>

#include "app/jobs/tune_job.h"
#include "app/model/window_model.h"

namespace gridscope {

enum class TunerPage { recommendation, front, all };

// The tuner, kept between display frames.
struct TunerPanel {
  TuneJob job;
  TuneState state;  // a copy of the job's, of this display frame
  TuneAxes axes;
  std::optional<TuneLimits> limits;  // a person's; not given: the rule's own
  TunerPage page = TunerPage::recommendation;
  bool againstTime = false;       // the one plot, where there is room for one: time instead of memory
  std::optional<size_t> hovered;  // row under the mouse, in plot or table

  TuneLimits shownLimits() const { return limits.value_or(usualLimits(state.rows.front())); }
  std::optional<size_t> recommended() const;  // by the rule, or the best within a person's limits
};

// Run or Cancel with what is done, and the button of the axes.
void drawTunerStrip(WindowModel& model, TunerPanel& tuner);

// Wrong rays against memory or time in a rectangle, screen pixels; a click on a point applies it.
void drawTunerPlot(WindowModel& model, TunerPanel& tuner, bool againstTime, const ImVec2& low, const ImVec2& high);

// Rows of the sweep, the best first; a click applies one.
void drawTunerTable(WindowModel& model, TunerPanel& tuner, bool frontAlone, const ImVec2& size);

// What to take, within which limits, and the flags to paste.
void drawTunerRecommendation(WindowModel& model, TunerPanel& tuner, const ImVec2& size);

// Takes a row's setting over, to be undone like every other.
void applyRow(WindowModel& model, const TuneRow& row);

// The same, with the frame as it is now kept as B beside it.
void compareRow(WindowModel& model, const TuneRow& row);

// The colour of a capacity: small ones dark, large ones bright.
ImVec4 capacityColour(const TunerPanel& tuner, uint32_t capacity);

// The row that the frame shown was made with; nothing: the sweep did not try it.
std::optional<size_t> rowOfFrame(const WindowModel& model, const TunerPanel& tuner);

std::string cellsText(const TuneRow& row);  // "128" along the longest side, or "edge 0.25"

double wrongShare(const TuneRow& row);  // percent of the rays

}  // namespace gridscope
