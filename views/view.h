// What a view is. A view reads products and never reruns a stage: it gives one element a pixel (or a cell of a slice), a value or a
// colour; palette.h turns elements into pixels. A view is one file, views/NAME.h, and one line in views/views.inc.
//
// views/NAME.h is read twice. C++ sees the description:
//     #ifdef __cplusplus
//     {.name = "visits", .title = "Cells visited", .unit = "cells", ...},
//     #else
// GLSL (included by shaders/views/view.comp) sees the function, in GLSL 4.6 with everything of shaders/pipeline/bindings.glsl and shaders/shared/views/view_element.h:
//     ViewElement viewElement(uint pixel) { return valueElement(float(counters[pixel].visits)); }
//     #endif
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "shaders/shared/views/palette.h"

namespace gridscope {

// What an element stands for, and with that which products a view needs and how large its image is.
enum class ViewScope {
  surface,  // a pixel of the gather buffer
  ray,      // a pixel's ray
  slice,    // a cell of one layer
};

enum class ViewRange {
  none,       // elements are colours
  automatic,  // 0 to the 99th percentile of the values, at least 1
  extent,     // lowest to highest value
  capacity,   // 0 to the grid's capacity
};

// What a view reads beside the frame's products; findings.glsl. It costs a person's wait, so that it is made only when it is shown.
enum class ViewNeed {
  nothing,
  truth,          // Pipeline::useTruths
  triangleCosts,  // Pipeline::useTriangleCosts: of the truth
  cellRays,       // Pipeline::useCellRays
  stability,      // Pipeline::useStability: of builds that add references first-come
  cellUpdates,    // Pipeline::useCellUpdates
};

struct View {
  std::string_view name;   // of the command line and the file
  std::string_view title;  // of the legend and the window
  std::string_view unit;   // what is counted; empty for colours
  std::string_view about;  // one sentence: what it shows and how to read it
  ViewScope scope = ViewScope::surface;
  ViewRange range = ViewRange::none;
  bool needsCounters = false;  // asks for the counting trace
  bool needsGrid = false;      // reads the grid's cells: with --device cpu the device must hold a copy
  ViewNeed need = ViewNeed::nothing;
  std::string_view marks = "";  // what kMark... elements mean, "saturated (refused)" say; empty: none
};

// All views, in the order of views/views.inc.
std::span<const View> allViews();

// nullptr when there is none of that name.
const View* findView(std::string_view name);

}  // namespace gridscope
