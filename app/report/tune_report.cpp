// See tune_report.h.
#include "app/report/tune_report.h"

#include <algorithm>
#include <set>

#include "app/base/text.h"
#include "core/tune/choice.h"

namespace gridscope {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kBestRows = 10;

std::string traceText(const TuneRow& row) {
  if (row.trace.traversal == kTraversalDda) return printed("dda g%g", double(row.trace.gate));
  return printed("b%g a%g g%g", double(row.trace.back), double(row.trace.ahead), double(row.trace.gate));
}

void addHeader(Table& table) {
  table.add({"",      "cells", "cap.",        "overlap", "by",   "back, ahead, gate", "memory", "stored", "refused",  "saturated",
             "wrong", "hole",  "voxel wrong", "far",     "near", "voxel right",       "visits", "tests",  "build ms", "trace ms"});
}

void addRow(Table& table, const std::string& name, const TuneRow& row) {
  auto share = [&](uint32_t verdict) { return percentOf(row.verdicts[verdict], row.rays); };
  table.add({name,
             row.grid.cellEdge > 0.0f ? printed("edge %g", double(row.grid.cellEdge)) : std::to_string(row.grid.cells),
             std::to_string(row.grid.capacity),
             overlapWord(row.grid.overlap),
             numberingWord(row.grid.numberBy),
             traceText(row),
             byteText(row.bytes),
             grouped(row.stored),
             grouped(row.refused),
             grouped(row.saturated),
             percentOf(row.wrong(), row.rays),
             share(kVerdictHole),
             share(kVerdictVoxelWrong),
             share(kVerdictTooFar),
             share(kVerdictTooNear),
             share(kVerdictVoxelRight),
             printed("%.1f", row.visits),
             printed("%.1f", row.tests),
             printed("%.2f", row.buildMs.median),
             printed("%.2f", row.traceMs.median)});
}

std::string nameOf(const TuneResult& result, size_t index) {
  if (index == result.recommended) return index == 0 ? "own, recommended" : "recommended";
  return index == 0 ? "own" : "";
}

// Measured rows, fewest wrong rays first.
std::vector<size_t> byWrong(const TuneResult& result) {
  std::vector<size_t> order;
  for (size_t i = 0; i < result.rows.size(); ++i)
    if (result.rows[i].measured()) order.push_back(i);
  std::ranges::stable_sort(order, [&](size_t a, size_t b) { return result.rows[a].wrong() < result.rows[b].wrong(); });
  return order;
}

void printRows(std::FILE* out, const TuneResult& result, const std::vector<size_t>& rows) {
  Table table("lrrlllrrrrrrrrrrrrrr");
  addHeader(table);
  for (size_t i : rows) addRow(table, nameOf(result, i), result.rows[i]);
  table.print(out);
}

// Each setting that was refused, with its reason.
void printRefusals(std::FILE* out, const TuneResult& result) {
  std::vector<const TuneRow*> refused;
  for (const TuneRow& row : result.rows)
    if (!row.measured()) refused.push_back(&row);
  if (refused.empty()) return;
  std::fprintf(out, "\n%zu settings could not be tried:\n", refused.size());
  for (const TuneRow* row : refused) std::fprintf(out, "  %s: %s\n", tuneTitle(*row).c_str(), row->refusal.c_str());
}

// One of the recommended setting's numbers that is the least or the most tried: beyond it nobody looked.
std::string endNote(const TuneResult& result, const char* option, double (*valueOf)(const TuneRow& row)) {
  constexpr size_t kLeastValues = 3;  // of an axis: of two, one end is always taken
  std::set<double> tried;
  for (const TuneRow& row : result.rows)
    if (row.measured()) tried.insert(valueOf(row));
  const double taken = valueOf(result.rows[result.recommended]);
  if (tried.size() < kLeastValues || (taken != *tried.begin() && taken != *tried.rbegin())) return "";
  return printed("  %s %g is the %s tried; %s-axis can go on from there\n", option, taken, taken == *tried.begin() ? "least" : "most",
                 option);
}

// What a person should know before taking the recommendation.
void printDoubts(std::FILE* out, const TuneResult& result) {
  const TuneRow& own = result.rows[0];
  const double noise = timeNoise(own, result.rows[result.recommended], relativeNoise(result.rows)) / std::max(own.traceMs.median, 1e-9);
  if (noise > kTuneMostTime - 1.0)
    std::fprintf(out,
                 "  times scattered by %.0f %% of the own setting's, more than the rule allows a setting to take: they decided little. Run "
                 "it while the machine is quiet\n",
                 100.0 * noise);
  if (result.recommended == 0) return;
  std::string notes = endNote(result, "--capacity", [](const TuneRow& row) { return double(row.grid.capacity); });
  if (result.rows[result.recommended].grid.cellEdge == 0.0f)
    notes = endNote(result, "--cells", [](const TuneRow& row) { return double(row.grid.cells); }) + notes;
  if (result.rows[result.recommended].trace.traversal == kTraversalSegment) {
    notes += endNote(result, "--back", [](const TuneRow& row) { return double(row.trace.back); });
    notes += endNote(result, "--ahead", [](const TuneRow& row) { return double(row.trace.ahead); });
  }
  notes += endNote(result, "--gate", [](const TuneRow& row) { return double(row.trace.gate); });
  std::fprintf(out, "%s", notes.c_str());
}

void printRecommendation(std::FILE* out, const TuneResult& result) {
  const TuneRow& own = result.rows[0];
  const TuneRow& best = result.rows[result.recommended];
  std::fprintf(out, "\nrule: at most %g times the memory and %g of the trace time of the own setting, then the fewest wrong rays\n",
               kTuneMostMemory, kTuneMostTime);
  if (result.recommended == 0) {
    std::fprintf(out, "recommended: the own setting; nothing tried within the rule is better\n  %s\n", tuneFlags(best).c_str());
    return printDoubts(out, result);
  }
  std::fprintf(out, "recommended: wrong rays %s -> %s, memory %s -> %s, trace %.2f -> %.2f ms\n  %s\n",
               percentOf(own.wrong(), own.rays).c_str(), percentOf(best.wrong(), best.rays).c_str(), byteText(own.bytes).c_str(),
               byteText(best.bytes).c_str(), own.traceMs.median, best.traceMs.median, tuneFlags(best).c_str());
  printDoubts(out, result);
}

Json spreadJson(const Spread& spread) { return {{"min", spread.min}, {"median", spread.median}, {"max", spread.max}}; }

Json settingJson(const TuneRow& row) {
  Json json = {{"cells", row.grid.cells},
               {"capacity", row.grid.capacity},
               {"overlap", overlapWord(row.grid.overlap)},
               {"numberBy", numberingWord(row.grid.numberBy)},
               {"traversal", traversalWord(row.trace.traversal)},
               {"back", row.trace.back},
               {"ahead", row.trace.ahead},
               {"gate", row.trace.gate},
               {"flags", tuneFlags(row)}};
  if (row.grid.cellEdge > 0.0f) json["cellEdge"] = row.grid.cellEdge;
  return json;
}

Json rowJson(const TuneRow& row) {
  Json json = settingJson(row);
  if (!row.measured()) {
    json["refusal"] = row.refusal;
    return json;
  }
  json["bytes"] = row.bytes;
  json["stored"] = row.stored;
  json["refused"] = row.refused;
  json["occupied"] = row.occupied;
  json["saturated"] = row.saturated;
  json["rays"] = row.rays;
  json["wrong"] = row.wrong();
  json["verdicts"] = Json::object();
  json["agree"] = row.verdicts[kVerdictAgrees];
  for (uint32_t verdict = kVerdictHole; verdict < kVerdictCount; ++verdict)
    json["verdicts"][std::string(verdictName(verdict).key)] = row.verdicts[verdict];
  json["visits"] = row.visits;
  json["tests"] = row.tests;
  json["buildMs"] = spreadJson(row.buildMs);
  json["traceMs"] = spreadJson(row.traceMs);
  json["front"] = row.front;
  return json;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace

void printTune(std::FILE* out, const TuneResult& result) {
  std::vector<size_t> best = byWrong(result);
  if (best.size() > kBestRows) best.resize(kBestRows);
  for (size_t named : {result.recommended, size_t{0}}) {
    std::erase(best, named);
    best.insert(best.begin(), named);
  }
  std::fprintf(out, "The own setting, the recommended one, and those with the fewest wrong rays:\n");
  printRows(out, result, best);

  std::vector<size_t> front;
  for (size_t i : byWrong(result))
    if (result.rows[i].front) front.push_back(i);
  std::fprintf(out, "\nThe front: %zu settings that no other beats in memory, trace time and wrong rays together:\n", front.size());
  printRows(out, result, front);
  printRefusals(out, result);
  printRecommendation(out, result);
}

Json tuneJson(const TuneResult& result) {
  Json json = {{"sweep",
                {{"tried", result.rows.size()},
                 {"stopped", result.stopped},
                 {"fault", result.fault},
                 {"seconds", result.seconds},
                 {"rule", {{"mostMemory", kTuneMostMemory}, {"mostTime", kTuneMostTime}}},
                 {"timeNoise", relativeNoise(result.rows)}}}};
  json["own"] = rowJson(result.rows[0]);
  json["recommended"] = rowJson(result.rows[result.recommended]);
  json["recommended"]["index"] = result.recommended;
  json["settings"] = Json::array();
  for (const TuneRow& row : result.rows) json["settings"].push_back(rowJson(row));
  return json;
}

std::string tuneCsv(const TuneResult& result) {
  std::string csv =
      "cells,cell_edge,capacity,overlap,number_by,traversal,back,ahead,gate,bytes,stored,refused,occupied,saturated,rays,wrong,hole,"
      "voxel_wrong,too_far,too_near,voxel_right,agree,visits,tests,build_ms,trace_ms,trace_ms_min,trace_ms_max,front,recommended,"
      "refusal\r\n";
  for (size_t i = 0; i < result.rows.size(); ++i) {
    const TuneRow& row = result.rows[i];
    csv += printed("%s,%s,%u,%s,%s,%s,%g,%g,%g,", row.grid.cellEdge > 0.0f ? "" : std::to_string(row.grid.cells).c_str(),
                   row.grid.cellEdge > 0.0f ? printed("%.9g", double(row.grid.cellEdge)).c_str() : "", row.grid.capacity,
                   overlapWord(row.grid.overlap), numberingWord(row.grid.numberBy), traversalWord(row.trace.traversal),
                   double(row.trace.back), double(row.trace.ahead), double(row.trace.gate));
    if (!row.measured()) {
      csv += std::string(19, ',') + "0,0," + quoted(row.refusal) + "\r\n";
      continue;
    }
    const uint64_t counts[] = {row.bytes,
                               row.stored,
                               row.refused,
                               row.occupied,
                               row.saturated,
                               row.rays,
                               row.wrong(),
                               row.verdicts[kVerdictHole],
                               row.verdicts[kVerdictVoxelWrong],
                               row.verdicts[kVerdictTooFar],
                               row.verdicts[kVerdictTooNear],
                               row.verdicts[kVerdictVoxelRight],
                               row.verdicts[kVerdictAgrees]};
    for (uint64_t count : counts) csv += std::to_string(count) + ",";
    csv += printed("%.3f,%.3f,%.4f,%.4f,%.4f,%.4f,%d,%d,\r\n", row.visits, row.tests, row.buildMs.median, row.traceMs.median,
                   row.traceMs.min, row.traceMs.max, row.front ? 1 : 0, i == result.recommended ? 1 : 0);
  }
  return csv;
}

}  // namespace gridscope
