// See invariants_place.h.
#include "core/grid/invariants_place.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <mutex>
#include <optional>

#include "core/base/parallel.h"

namespace gridscope {

namespace {

// What is wrong with a cell.
struct Fault {
  ivec3 cell;
  const char* text;  // with one %08X: the reference
  uint32_t reference;
};

// What a cell should take, in rising order: statics come first, dynamic references only once they were added.
std::span<const uint32_t> wantedNow(const PlaceInput& input, ivec3 cell) {
  const std::span<const uint32_t> wanted = input.demand.wanted(cell);
  if (input.dynamicAdded) return wanted;
  return wanted.first(size_t(std::ranges::lower_bound(wanted, firstDynamicReference(input.grid.parameters)) - wanted.begin()));
}

std::optional<Fault> findMisplaced(const PlaceInput& input, ivec3 cell) {
  const GridParameters& grid = input.grid.parameters;
  const uint32_t firstDynamic = firstDynamicReference(grid);
  const std::span<const uint32_t> wanted = wantedNow(input, cell);
  std::vector<uint32_t> held = storedIn(input.grid, cell);
  if (wanted.empty() && held.empty()) return std::nullopt;
  std::ranges::sort(held);
  for (uint32_t reference : held)
    if (reference < firstDynamic && !std::ranges::binary_search(wanted, reference))
      return Fault{cell, "holds 0x%08X, which does not overlap it", reference};

  // What must be there: of sorted insertion, or where there is room, the smallest; else as many, and no dynamic one in a static one's place.
  const size_t room = size_t(grid.capacity);
  const bool exact = grid.insertion == kInsertionSorted || wanted.size() <= room;
  const auto lacks = [&](uint32_t reference) { return !std::ranges::binary_search(held, reference); };
  if (exact) {
    const std::span<const uint32_t> due = wanted.first(std::min(wanted.size(), room));
    if (const auto missing = std::ranges::find_if(due, lacks); missing != due.end())
      return Fault{cell, "lacks 0x%08X, which overlaps it", *missing};
    return std::nullopt;
  }
  const auto isStatic = [&](uint32_t reference) { return reference < firstDynamic; };
  const size_t staticsDue = std::min(room, size_t(std::ranges::count_if(wanted, isStatic)));
  if (held.size() >= room && size_t(std::ranges::count_if(held, isStatic)) >= staticsDue) return std::nullopt;
  return Fault{cell, "lacks 0x%08X, which overlaps it, though it had room", *std::ranges::find_if(wanted, lacks)};
}

std::optional<Fault> findStale(const PlaceInput& input, ivec3 cell) {
  const uint32_t firstDynamic = firstDynamicReference(input.grid.parameters);
  for (uint32_t reference : storedIn(input.grid, cell)) {
    if (reference < firstDynamic) continue;
    if (!input.dynamicAdded) return Fault{cell, "holds the dynamic 0x%08X before the first update", reference};
    if (!input.demand.wants(cell, reference)) return Fault{cell, "holds the dynamic 0x%08X, which does not overlap it now", reference};
  }
  return std::nullopt;
}

// Asks every cell, and fills in how many break the invariant and the first of them.
template <typename Find>
Invariant test(Invariant invariant, const PlaceInput& input, Find find) {
  const ivec3 count = input.grid.parameters.cellCount;
  std::mutex mutex;
  std::optional<Fault> first;
  forRanges(size_t(count.z), 1, [&](size_t begin, size_t end) {
    for (ivec3 cell(0, 0, int(begin)); cell.z < int(end); ++cell.z)
      for (cell.y = 0; cell.y < count.y; ++cell.y)
        for (cell.x = 0; cell.x < count.x; ++cell.x) {
          const std::optional<Fault> fault = find(input, cell);
          if (!fault) continue;
          std::lock_guard lock(mutex);
          ++invariant.count;
          const auto place = [](const ivec3& c) { return std::array{c.z, c.y, c.x}; };
          if (!first || place(cell) < place(first->cell)) first = fault;
        }
  });
  if (!first) return invariant;
  std::array<char, 128> what, line;
  std::snprintf(what.data(), what.size(), first->text, first->reference);
  std::snprintf(line.data(), line.size(), "%llu cell%s; the first, (%d, %d, %d), ", static_cast<unsigned long long>(invariant.count),
                invariant.count == 1 ? "" : "s", first->cell.x, first->cell.y, first->cell.z);
  invariant.fault = std::string(line.data()) + what.data();
  return invariant;
}

}  // namespace

Invariant testPlacement(const PlaceInput& input) {
  return test({.key = "placed", .name = "each triangle is where the overlap test puts it"}, input, findMisplaced);
}

Invariant testStale(const PlaceInput& input) { return test({.key = "nothingStale", .name = "nothing stale"}, input, findStale); }

}  // namespace gridscope
