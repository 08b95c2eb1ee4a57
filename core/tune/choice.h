// Which of a sweep's settings are worth looking at, and which one to take.
//
// The rule: a setting is admissible when its grid takes at most twice the memory of the frame's own (the first row) and its trace at most
// 1.25 of its time. Of those the one with the fewest wrong rays is recommended; of equally many, the one with the least memory, then the
// fastest, then the first tried. Times are measured: two of them differ only when they are further apart than their spread (timeNoise), so
// noise neither excludes a setting nor decides for one. When no admissible setting has fewer wrong rays than the frame's own, and none as
// few for less memory or time, the frame's own stays.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/tune/tune.h"

namespace gridscope {

inline constexpr double kTuneMostMemory = 2.0;  // of the first row's
inline constexpr double kTuneMostTime = 1.25;   // of the first row's

// Milliseconds within which two trace times are the same: the larger of the rows' own spreads (slowest - fastest run), and no less than the
// median of all rows' spreads relative to their time.
double timeNoise(const TuneRow& a, const TuneRow& b, double relativeNoise);
double relativeNoise(std::span<const TuneRow> rows);  // 0.05: 5 % of a time

// Within the rule's limits of memory and time.
bool admissible(const TuneRow& row, const TuneRow& first, double relativeNoise);

// Index of the recommended row; rows[0], the frame's own, must be measured.
size_t recommend(std::span<const TuneRow> rows);

// Sets TuneRow::front: the Pareto front of memory, trace time and wrong rays.
void markFront(std::span<TuneRow> rows);

// The front of two: rows, by rising `amountOf`, each with fewer wrong rays than all before it. Rows that were not measured are left out.
std::vector<size_t> frontAgainst(std::span<const TuneRow> rows, double (*amountOf)(const TuneRow& row));
double memoryOf(const TuneRow& row);     // bytes
double traceTimeOf(const TuneRow& row);  // milliseconds, the median

// The options to paste: what the sweep varies, for either command line, "--cells 192 --capacity 32 --overlap exact ...".
std::string tuneFlags(const TuneRow& row);

// "192 cells, capacity 32, exact, by area; segment, back 1, ahead 0.75, gate 1.75".
std::string tuneTitle(const TuneRow& row);

}  // namespace gridscope
