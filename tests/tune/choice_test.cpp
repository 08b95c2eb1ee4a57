// The choice among a sweep's settings: the front, the rule, what noise may not decide, the flags to paste; and the sweep's text forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "app/report/tune_report.h"
#include "core/tune/choice.h"

namespace gridscope {
namespace {

struct RowValues {
  uint64_t bytes;
  uint64_t wrong;
  double ms;
  double spread = 0.0;  // slowest - fastest run
};

TuneRow rowOf(const RowValues& values) {
  TuneRow row;
  row.bytes = values.bytes;
  row.rays = 1000;
  row.verdicts[kVerdictHole] = values.wrong;
  row.verdicts[kVerdictAgrees] = 1000 - values.wrong;
  row.traceMs = {values.ms - 0.5 * values.spread, values.ms, values.ms + 0.5 * values.spread};
  return row;
}

std::vector<TuneRow> rowsOf(const std::vector<RowValues>& values) {
  std::vector<TuneRow> rows;
  for (const RowValues& one : values) rows.push_back(rowOf(one));
  return rows;
}

TuneRow refusedRow() {
  TuneRow row;
  row.refusal = "the device, \"small\", can't hold it";
  return row;
}

std::vector<bool> frontOf(std::vector<TuneRow> rows) {
  markFront(rows);
  std::vector<bool> front;
  for (const TuneRow& row : rows) front.push_back(row.front);
  return front;
}

TEST(TuneChoice, WrongCountsHolesWrongVoxelsAndWrongDistancesButNotVoxelRight) {
  TuneRow row;
  row.verdicts[kVerdictAgrees] = 100000;
  row.verdicts[kVerdictHole] = 1;
  row.verdicts[kVerdictVoxelWrong] = 10;
  row.verdicts[kVerdictVoxelRight] = 10000;
  row.verdicts[kVerdictTooFar] = 100;
  row.verdicts[kVerdictTooNear] = 1000;
  EXPECT_EQ(row.wrong(), 1111u);
}

TEST(TuneChoice, FewestWrongRaysWithinTheLimitsAreRecommended) {
  const auto rows = rowsOf({{100, 50, 10.0}, {100, 40, 10.0}, {200, 20, 12.5}, {201, 5, 10.0}, {100, 4, 12.6}, {50, 60, 1.0}});
  EXPECT_EQ(recommend(rows), 2u);  // the fourth takes too much memory, the fifth too long
}

TEST(TuneChoice, TheOwnSettingStaysWhenNothingIsBetter) {
  EXPECT_EQ(recommend(rowsOf({{100, 50, 10.0}, {100, 50, 10.0}, {100, 51, 1.0}, {1, 60, 1.0}})), 0u);
  EXPECT_EQ(recommend(rowsOf({{100, 50, 10.0}})), 0u);
}

TEST(TuneChoice, EquallyManyWrongRaysTakeTheLeastMemoryThenTheFastest) {
  EXPECT_EQ(recommend(rowsOf({{100, 50, 10.0}, {90, 50, 12.0}, {90, 50, 11.0}})), 2u);
  EXPECT_EQ(recommend(rowsOf({{100, 50, 10.0}, {100, 50, 8.0}})), 1u);
}

TEST(TuneChoice, NoiseNeitherExcludesNorDecides) {
  // 12.9 ms is above 1.25 times 10 ms, but by less than the spread of its runs.
  EXPECT_EQ(recommend(rowsOf({{100, 50, 10.0}, {100, 40, 12.9, 0.6}})), 1u);
  EXPECT_EQ(recommend(rowsOf({{100, 50, 10.0}, {100, 40, 12.9, 0.1}})), 0u);
  // 9.9 ms is faster than 10 ms, but within the spread.
  EXPECT_EQ(recommend(rowsOf({{100, 50, 10.0, 0.4}, {100, 50, 9.9}})), 0u);
}

TEST(TuneChoice, WhatWasRefusedIsNeverChosenAndNeverOnTheFront) {
  std::vector<TuneRow> rows = rowsOf({{100, 50, 10.0}, {100, 60, 10.0}});
  rows.insert(rows.begin() + 1, refusedRow());
  EXPECT_EQ(recommend(rows), 0u);
  EXPECT_EQ(frontOf(rows), (std::vector<bool>{true, false, false}));
  EXPECT_EQ(frontAgainst(rows, memoryOf), (std::vector<size_t>{0}));
}

TEST(TuneChoice, TheFrontHoldsWhatNothingBeatsInAllThree) {
  //                                      best memory     dominated       fewest wrong    fastest
  EXPECT_EQ(frontOf(rowsOf({{50, 90, 10.0}, {60, 95, 11.0}, {100, 10, 10.0}, {100, 90, 2.0}})),
            (std::vector<bool>{true, false, true, true}));
}

TEST(TuneChoice, EqualSettingsAreBothOnTheFront) {
  EXPECT_EQ(frontOf(rowsOf({{50, 90, 10.0}, {50, 90, 10.0}})), (std::vector<bool>{true, true}));
}

TEST(TuneChoice, AFrontIsNeverEmpty) {
  // Times within their noise are the same: that must not let settings exclude each other in a ring.
  EXPECT_EQ(frontOf(rowsOf({{50, 90, 10.0, 2.0}, {50, 90, 11.0, 2.0}, {50, 90, 12.0, 2.0}})), (std::vector<bool>{true, true, true}));
  EXPECT_TRUE(frontOf({}).empty());
}

TEST(TuneChoice, FrontsOfTwoRiseInAmountAndFallInWrongRays) {
  const auto rows = rowsOf({{100, 50, 5.0}, {50, 60, 9.0}, {50, 55, 9.0}, {200, 50, 1.0}, {300, 10, 7.0}});
  EXPECT_EQ(frontAgainst(rows, memoryOf), (std::vector<size_t>{2, 0, 4}));
  EXPECT_EQ(frontAgainst(rows, traceTimeOf), (std::vector<size_t>{3, 4}));
}

TEST(TuneChoice, FlagsNameEveryThingThatTheSweepVaries) {
  TuneRow row;
  row.grid.cells = 192;
  row.grid.overlap = kOverlapExact;
  row.grid.numberBy = NumberBy::area;
  row.trace.ahead = 0.1f;
  EXPECT_EQ(tuneFlags(row),
            "--cells 192 --capacity 32 --overlap exact --number-by area --traversal segment --back 1 --ahead 0.1 --gate 1.75");
  row.trace.traversal = kTraversalDda;
  row.grid.cellEdge = 0.25f;
  EXPECT_EQ(tuneFlags(row), "--cell-edge 0.25 --capacity 32 --overlap exact --number-by area --traversal dda --gate 1.75");
}

TuneResult smallResult() {
  TuneResult result;
  result.rows = rowsOf({{100, 50, 10.0}, {120, 40, 10.0}});
  result.rows.push_back(refusedRow());
  result.recommended = 1;
  markFront(result.rows);
  return result;
}

// Commas outside of quotes.
size_t fieldCount(const std::string& line) {
  bool inQuotes = false;
  size_t fields = 1;
  for (char c : line) {
    if (c == '"')
      inQuotes = !inQuotes;
    else if (c == ',' && !inQuotes)
      ++fields;
  }
  return fields;
}

TEST(TuneReport, EveryLineOfTheCsvHasTheHeadersFields) {
  const std::string csv = tuneCsv(smallResult());
  std::vector<std::string> lines;
  for (size_t begin = 0, end; (end = csv.find("\r\n", begin)) != std::string::npos; begin = end + 2)
    lines.push_back(csv.substr(begin, end - begin));
  ASSERT_EQ(lines.size(), 4u);
  for (const std::string& line : lines) EXPECT_EQ(fieldCount(line), fieldCount(lines[0])) << line;
  EXPECT_NE(lines[3].find("\"the device, \"\"small\"\", can't hold it\""), std::string::npos) << lines[3];
}

TEST(TuneReport, JsonHoldsEverySettingAndTheRecommendation) {
  const nlohmann::ordered_json json = tuneJson(smallResult());
  ASSERT_EQ(json["settings"].size(), 3u);
  EXPECT_EQ(json["own"]["wrong"], 50);
  EXPECT_EQ(json["recommended"]["index"], 1);
  EXPECT_EQ(json["recommended"]["wrong"], 40);
  EXPECT_EQ(json["settings"][0]["verdicts"]["hole"], 50);
  EXPECT_TRUE(json["settings"][2].contains("refusal"));
  EXPECT_FALSE(json["settings"][2].contains("bytes"));
}

std::string printedTune(const TuneResult& result) {
  char* text = nullptr;
  size_t size = 0;
  std::FILE* out = open_memstream(&text, &size);
  printTune(out, result);
  std::fclose(out);
  std::string whole(text, size);
  std::free(text);
  return whole;
}

TEST(TuneReport, SaysWhenTheRecommendationLiesAtTheEndOfWhatWasTried) {
  TuneResult result = smallResult();
  result.rows = rowsOf({{100, 50, 10.0}, {100, 45, 10.0}, {100, 40, 10.0}});
  result.rows[1].trace.gate = 2.0f, result.rows[2].trace.gate = 4.0f;
  result.rows[1].trace.back = 0.5f, result.rows[0].trace.back = 1.5f;
  result.recommended = 2;
  const std::string text = printedTune(result);
  EXPECT_NE(text.find("--gate 4 is the most tried; --gate-axis can go on from there"), std::string::npos) << text;
  EXPECT_EQ(text.find("--back 1 is"), std::string::npos) << text;
  EXPECT_EQ(text.find("--ahead"), text.rfind("--ahead")) << "one value only, in the flags: " << text;
}

TEST(TuneReport, SaysWhenTimesScatteredMoreThanTheRuleAllows) {
  TuneResult result = smallResult();
  EXPECT_EQ(printedTune(result).find("scattered"), std::string::npos);
  result.rows[0].traceMs = {8.0, 10.0, 14.0};
  EXPECT_NE(printedTune(result).find("times scattered by 60 % of the own setting's"), std::string::npos) << printedTune(result);
}

}  // namespace
}  // namespace gridscope
