// What a render says about its frames: collected once, printed as a table and written as JSON.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/base/text.h"
#include "app/session/session.h"
#include "app/session/settings_table.h"
#include "core/base/statistics.h"
#include "core/checks/exact_check.h"
#include "core/grid/statistics.h"
#include "core/trace/statistics.h"

namespace gridscope {

struct FrameReport {
  uint32_t frame = 0;
  float timeSeconds = 0.0f;  // in the animations
  GridTotals grid;
  uint64_t tried = 0;  // references
  TriangleTotals triangles;
  RayTotals rays;
  std::optional<CounterTotals> counters;  // where the counting trace ran
  StageTimes times;
  UpdateReport update;
};

struct RenderReport {
  double startMs = 0.0;               // load, upload, compile
  std::vector<FrameReport> frames;    // empty when the build already differed from C++
  std::vector<std::string> pictures;  // files written
  std::optional<uint64_t>
      foreignHits;  // of the last frame's captured hits: how many are not what the trace ends with; nothing: none captured
  std::optional<ExactComparison> exact;  // of --check-exact
  std::optional<std::string> check;      // of --check-cpu: the first difference; empty: all equal
};

// Of the pipeline's present products. `counted`: the counting trace ran.
FrameReport reportFrame(Session& session, uint32_t frame, bool counted);

// The statistics table of the last frame; rows of a name (empty: of the row before) and a text.
Table reportTable(const Session& session, const RenderReport& report);
void printReport(std::FILE* out, const Session& session, const RenderReport& report);

// More than these many rays that graze an edge are not explained by rounding.
inline constexpr size_t kMostExactDifferences = 5;

// How many rays agree with the exact hits, and each that does not.
void printExact(std::FILE* out, const ExactComparison& exact, uint32_t frameWidth);

// The whole report; keys as the command line names things.
nlohmann::ordered_json reportJson(const Session& session, const RenderReport& report);

// Parts that other commands' results have too.
nlohmann::ordered_json deviceJson(const Session& session);
nlohmann::ordered_json sceneJson(const Session& session);
nlohmann::ordered_json gridJson(const GridParameters& grid);

// Writes results to --json; nothing when it was not given. Throws Error.
void writeJson(const Options& options, const nlohmann::ordered_json& results);

}  // namespace gridscope
