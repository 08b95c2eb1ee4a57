// The tables of the window that are no sheets, as rows of fields for CSV files: titles first, numbers as programs read them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/frame/scene_places.h"
#include "app/frame/step_facts.h"
#include "app/model/window_model.h"

namespace gridscope {

using CsvRows = std::vector<std::vector<std::string>>;

CsvRows verdictRows(const TruthTotals& totals);
CsvRows causeRows(const TruthTotals& totals, const ProofTotals* proofs);  // proofs: null where nothing is proven yet
CsvRows meshRows(const Ledger& ledger, const CaptureNames& names);        // meshes that cost rays, the most first
CsvRows costlyCellRows(const Ledger& ledger);                             // likewise cells
CsvRows slotRows(const SceneFacts& scene, const CellContents& contents);  // stored, then refused
CsvRows stepRows(const FrameSnapshot& frame, const RecordedRay& ray);
CsvRows testRows(const SceneFacts& scene, const StepFacts& facts);  // of one step: tested, then refused
CsvRows triangleCellRows(const TriangleCells& cells);

// Writes SCENE_TABLE.csv, or the first free name like it, beside where the program was started, on a thread of model.files, which says what became
// of it. `csv` runs on that thread: it must own what it reads.
void exportCsv(WindowModel& model, const std::string& table, size_t rowCount, std::function<std::string()> csv);
void exportCsv(WindowModel& model, const std::string& table, CsvRows rows);

}  // namespace gridscope
