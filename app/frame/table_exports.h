// The tables of the window that are no sheets, as rows of fields for CSV files: titles first, numbers as programs read them.
#pragma once

#include <string>
#include <vector>

#include "app/frame/scene_places.h"
#include "app/frame/step_facts.h"

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

}  // namespace gridscope
