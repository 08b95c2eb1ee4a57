// See table_exports.h.
#include "app/frame/table_exports.h"

#include <algorithm>
#include <span>

#include "app/base/text.h"

namespace gridscope {

namespace {

std::string whole(uint64_t number) { return std::to_string(number); }
std::string decimal(double number) { return printed("%.9g", number); }
std::string share(uint64_t part, uint64_t all) { return all == 0 ? "" : printed("%.4g", 100.0 * double(part) / double(all)); }
std::string place(const ivec3& cell) { return printed("%d,%d,%d", cell.x, cell.y, cell.z); }

}  // namespace

CsvRows verdictRows(const TruthTotals& totals) {
  CsvRows rows{{"verdict", "rays", "percent"}};
  const auto add = [&](std::string_view name, uint64_t rays) {
    rows.push_back({std::string(name), whole(rays), share(rays, totals.rays)});
  };
  add("agrees, hit", totals.agreeHit);
  add("agrees, miss", totals.agreeMiss);
  for (const uint32_t verdict : {kVerdictHole, kVerdictVoxelRight, kVerdictVoxelWrong, kVerdictTooFar, kVerdictTooNear})
    add(verdictName(verdict).title, totals.verdicts[verdict]);
  return rows;
}

CsvRows causeRows(const TruthTotals& totals, const ProofTotals* proofs) {
  CsvRows rows{{"cause", "rays", "percent of those that differ", "evidence", "confirmed alone", "confirmed as a chain", "control confirmed",
                "control tried"}};
  for (uint32_t cause = kCauseNone + 1; cause < kCauseCount; ++cause) {
    if (totals.causes[cause] == 0) continue;
    std::vector<std::string> row{std::string(causeName(cause).title), whole(totals.causes[cause]),
                                 share(totals.causes[cause], totals.differ()), std::string(causeName(cause).about)};
    if (proofs) {
      const ProofTotals::Count& count = proofs->causes[cause];
      for (const uint64_t number : {count.alone, count.chain, count.controlConfirmed, count.controlTotal}) row.push_back(whole(number));
    } else {
      row.resize(rows.front().size());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

CsvRows meshRows(const Ledger& ledger, const CaptureNames& names) {
  CsvRows rows{{"mesh", "rays", "holes", "voxel right", "voxel wrong", "too far", "too near", "references stored", "references lost"}};
  for (const size_t index : worstOf(std::span<const GroupLoss>(ledger.meshes), ledger.meshes.size())) {
    const GroupLoss& loss = ledger.meshes[index];
    const bool named = loss.index < names.meshes.size() && !names.meshes[loss.index].empty();
    std::vector<std::string> row{named ? names.meshes[loss.index] : "mesh " + std::to_string(loss.index), whole(loss.rays)};
    for (const uint32_t verdict : {kVerdictHole, kVerdictVoxelRight, kVerdictVoxelWrong, kVerdictTooFar, kVerdictTooNear})
      row.push_back(whole(loss.verdicts[verdict]));
    row.push_back(whole(loss.stored)), row.push_back(whole(loss.lost));
    rows.push_back(std::move(row));
  }
  return rows;
}

CsvRows costlyCellRows(const Ledger& ledger) {
  CsvRows rows{{"cell", "tried", "stored", "refused", "rays"}};
  for (const size_t index : worstOf(std::span<const CellLoss>(ledger.cells), ledger.cells.size())) {
    const CellLoss& loss = ledger.cells[index];
    rows.push_back({place(loss.cell), whole(loss.tried), whole(loss.stored), whole(loss.refused), whole(loss.rays)});
  }
  return rows;
}

CsvRows slotRows(const SceneFacts& scene, const CellContents& contents) {
  CsvRows rows{{"slot", "reference", "instance", "mesh", "triangle"}};
  const auto add = [&](const std::string& slot, uint32_t reference) {
    const TriangleName name = nameTriangle(scene.numbered, reference);
    rows.push_back(
        {slot, printed("0x%08X", reference), instanceName(scene, name.sceneInstance), meshName(scene, name.mesh), whole(name.triangle)});
  };
  for (size_t slot = 0; slot < contents.stored.size(); ++slot) add(whole(slot), contents.stored[slot]);
  for (const uint32_t reference : contents.refused) add("refused", reference);
  return rows;
}

CsvRows stepRows(const FrameSnapshot& frame, const RecordedRay& ray) {
  CsvRows rows{{"step", "segment", "start", "cell", "outcome", "stored", "saturated", "tests", "from the launch plane, cell edges"}};
  for (uint32_t step = 0; step < ray.record.steps.size(); ++step) {
    const StepRecord& one = ray.record.steps[step];
    rows.push_back({whole(step), std::to_string(one.segment), decimal(double(one.start)), place(one.cell),
                    std::string(stepLook(stepOutcome(ray.record, step)).word), std::to_string(one.stored), one.saturated ? "1" : "0",
                    whole(one.tests.size()), decimal(double(stepTravel(frame, ray, step)))});
  }
  return rows;
}

CsvRows testRows(const SceneFacts& scene, const StepFacts& facts) {
  CsvRows rows{{"slot", "reference", "mesh", "triangle", "t", "u", "v", "verdict"}};
  const auto add = [&](const std::string& slot, const TestRecord& test, const TriangleName& name, const vec2& weights,
                       const std::string& verdict) {
    rows.push_back({slot, printed("0x%08X", test.reference), meshName(scene, name.mesh), whole(name.triangle), decimal(double(test.t)),
                    decimal(double(weights.x)), decimal(double(weights.y)), verdict});
  };
  for (const TestFacts& one : facts.tests) add(whole(one.test.slot), one.test, one.name, one.weights, testWord(one.test));
  for (const RefusedFacts& one : facts.refusedTests)
    add("refused", one.test, one.name, one.weights, one.wouldHit ? "would hit" : testWord(one.test));
  return rows;
}

CsvRows triangleCellRows(const TriangleCells& cells) {
  CsvRows rows{{"cell", "holds it"}};
  for (const ivec3& cell : cells.stored) rows.push_back({place(cell), "1"});
  for (const ivec3& cell : cells.refused) rows.push_back({place(cell), "0"});
  return rows;
}

}  // namespace gridscope
