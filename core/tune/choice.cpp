// See choice.h.
#include "core/tune/choice.h"

#include <algorithm>
#include <charconv>

namespace gridscope {
namespace {

double ownSpread(const TuneRow& row) { return row.traceMs.max - row.traceMs.min; }

// At least as good in all three, better in one; times within their noise are the same.
bool dominates(const TuneRow& a, const TuneRow& b, double noise) {
  const double faster = b.traceMs.median - a.traceMs.median, same = timeNoise(a, b, noise);
  if (a.wrong() > b.wrong() || a.bytes > b.bytes || faster < -same) return false;
  return a.wrong() < b.wrong() || a.bytes < b.bytes || faster > same;
}

// Should `row` be recommended rather than `best`?
bool better(const TuneRow& row, const TuneRow& best, double noise) {
  if (row.wrong() != best.wrong()) return row.wrong() < best.wrong();
  if (row.bytes != best.bytes) return row.bytes < best.bytes;
  return row.traceMs.median < best.traceMs.median - timeNoise(row, best, noise);
}

// The shortest text that reads as the same number.
std::string numberText(float value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string edgeOrCells(const TuneRow& row, const char* edge, const char* cells) {
  return row.grid.cellEdge > 0.0f ? edge + numberText(row.grid.cellEdge) : cells + std::to_string(row.grid.cells);
}

}  // namespace

double relativeNoise(std::span<const TuneRow> rows) {
  std::vector<double> spreads;
  for (const TuneRow& row : rows)
    if (row.measured() && row.traceMs.median > 0.0) spreads.push_back(ownSpread(row) / row.traceMs.median);
  return spreadOf(std::move(spreads)).median;
}

double timeNoise(const TuneRow& a, const TuneRow& b, double relativeNoise) {
  return std::max({ownSpread(a), ownSpread(b), relativeNoise * std::max(a.traceMs.median, b.traceMs.median)});
}

bool admissible(const TuneRow& row, const TuneRow& first, double relativeNoise) {
  if (!row.measured() || double(row.bytes) > kTuneMostMemory * double(first.bytes)) return false;
  return row.traceMs.median <= kTuneMostTime * first.traceMs.median + timeNoise(row, first, relativeNoise);
}

size_t recommend(std::span<const TuneRow> rows) {
  const double noise = relativeNoise(rows);
  size_t best = 0;
  for (size_t i = 1; i < rows.size(); ++i)
    if (admissible(rows[i], rows[0], noise) && better(rows[i], rows[best], noise)) best = i;
  return best;
}

void markFront(std::span<TuneRow> rows) {
  const double noise = relativeNoise(rows);
  for (TuneRow& row : rows) {
    auto beatsRow = [&](const TuneRow& other) { return other.measured() && dominates(other, row, noise); };
    row.front = row.measured() && std::ranges::none_of(rows, beatsRow);
  }
}

std::vector<size_t> frontAgainst(std::span<const TuneRow> rows, double (*amountOf)(const TuneRow& row)) {
  std::vector<size_t> order;
  for (size_t i = 0; i < rows.size(); ++i)
    if (rows[i].measured()) order.push_back(i);
  std::ranges::stable_sort(order, [&](size_t a, size_t b) {
    const double amountA = amountOf(rows[a]), amountB = amountOf(rows[b]);
    return amountA != amountB ? amountA < amountB : rows[a].wrong() < rows[b].wrong();
  });
  std::vector<size_t> front;
  for (size_t i : order)
    if (front.empty() || rows[i].wrong() < rows[front.back()].wrong()) front.push_back(i);
  return front;
}

double memoryOf(const TuneRow& row) { return double(row.bytes); }
double traceTimeOf(const TuneRow& row) { return row.traceMs.median; }

std::string tuneFlags(const TuneRow& row) {
  std::string flags = edgeOrCells(row, "--cell-edge ", "--cells ") + " --capacity " + std::to_string(row.grid.capacity) + " --overlap " +
                      overlapWord(row.grid.overlap) + " --number-by " + numberingWord(row.grid.numberBy);
  const bool segments = row.trace.traversal == kTraversalSegment;
  flags += segments ? " --traversal segment --back " + numberText(row.trace.back) + " --ahead " + numberText(row.trace.ahead)
                    : std::string(" --traversal dda");
  return flags + " --gate " + numberText(row.trace.gate);
}

std::string tuneTitle(const TuneRow& row) {
  std::string title = row.grid.cellEdge > 0.0f ? "cells of " + numberText(row.grid.cellEdge) : std::to_string(row.grid.cells) + " cells";
  title +=
      ", capacity " + std::to_string(row.grid.capacity) + ", " + overlapWord(row.grid.overlap) + ", by " + numberingWord(row.grid.numberBy);
  title += row.trace.traversal == kTraversalSegment
               ? "; segment, back " + numberText(row.trace.back) + ", ahead " + numberText(row.trace.ahead)
               : std::string("; dda");
  return title + ", gate " + numberText(row.trace.gate);
}

}  // namespace gridscope
