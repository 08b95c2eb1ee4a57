// Files that the window writes of what it shows, beside where the program was started, each on a thread of model.files, which says what became
// of it: a view as a picture, tables as CSV.
#pragma once

#include <functional>
#include <string>

#include "app/frame/table_exports.h"
#include "app/model/window_model.h"

namespace gridscope {

// SCENE_VIEW.png, or the first free name like it: the view with its legend, as it is shown now.
void saveView(WindowModel& model, const std::string& name);

// SCENE_TABLE.csv, or the first free name like it. `csv` runs on the thread: it must own what it reads.
void exportCsv(WindowModel& model, const std::string& table, size_t rowCount, std::function<std::string()> csv);
void exportCsv(WindowModel& model, const std::string& table, CsvRows rows);

}  // namespace gridscope
