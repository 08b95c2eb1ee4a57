// Draws a sheet as a table: titles that sort, rows that select, links, the filters at work and what they leave, and CSV.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/jobs/table_job.h"
#include "app/model/window_model.h"

namespace gridscope {

// One table of the window, kept between display frames.
struct SheetPanel {
  TableKind kind;
  SheetOrder order;
  TableJob job{};
  std::optional<uint32_t> shownId{};  // the selection that the table was last scrolled to
};

// What a table's rows mean.
struct SheetActions {
  std::optional<uint32_t> selectedId;                                          // row to mark
  std::function<void(uint32_t id)> click;                                      // a row was clicked
  std::function<std::optional<uint32_t>(size_t column, double value)> swatch;  // 0xRRGGBB square before a word, or a number's colour
  const char* unknownWhy = "";                                                 // what must happen for columns that are not known
  const char* lastTitle = nullptr;                                             // one more column, drawn by drawLast
  std::function<void(uint32_t id, size_t row)> drawLast;
};

// The strip above and the table, filling what is left of the region.
void drawSheet(WindowModel& model, SheetPanel& panel, const SheetActions& actions);

}  // namespace gridscope
