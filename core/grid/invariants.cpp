// What must hold of a grid after every stage, and the sums over its cells.
#include "core/grid/invariants.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/error.h"
#include "core/grid/slots.h"

namespace gridscope {

namespace {

// A cell's slots and what it refused, as plain values.
struct CellContent {
  ivec3 cell{};
  std::vector<uint32_t> slots;  // all `capacity` of them
  int stored = 0;               // slots before the first blank
  uint32_t staticRefused = 0;   // with one reserved texel: its flag
  uint32_t dynamicRefused = 0;
  bool full() const { return stored == int(slots.size()); }
};

// Reads a row of cells along x. Slots in the order in which they lie in memory: a row of many slots is much larger than a cache.
void readRow(const Grid& grid, int y, int z, std::vector<CellContent>& row) {
  const GridParameters& parameters = grid.parameters;
  const SlotReader reader(grid);
  row.resize(size_t(parameters.cellCount.x));
  for (int x = 0; x < parameters.cellCount.x; ++x) row[x].cell = ivec3(x, y, z), row[x].slots.resize(size_t(parameters.capacity));
  auto readSlot = [&](int x, int slot) { row[x].slots[slot] = reader.slotLoad(gridTexel(parameters, row[x].cell, slot)); };
  if (parameters.stretchAxis == 0) {
    for (int x = 0; x < parameters.cellCount.x; ++x)
      for (int slot = 0; slot < parameters.capacity; ++slot) readSlot(x, slot);
  } else {
    for (int slot = 0; slot < parameters.capacity; ++slot)
      for (int x = 0; x < parameters.cellCount.x; ++x) readSlot(x, slot);
  }

  for (CellContent& content : row) {
    content.stored = int(std::find(content.slots.begin(), content.slots.end(), kBlank) - content.slots.begin());
    content.staticRefused = parameters.reserved >= 1 ? reader.slotLoad(gridRefusedTexel(parameters, content.cell, false)) : 0;
    content.dynamicRefused = parameters.reserved == 2 ? reader.slotLoad(gridRefusedTexel(parameters, content.cell, true)) : 0;
  }
}

template <typename Visit>
void forCellContents(const Grid& grid, Visit visit) {
  std::vector<CellContent> row;
  for (int z = 0; z < grid.parameters.cellCount.z; ++z)
    for (int y = 0; y < grid.parameters.cellCount.y; ++y) {
      readRow(grid, y, z, row);
      for (const CellContent& content : row) visit(content);
    }
}

bool isSaturated(const GridParameters& grid, const CellContent& content) {
  if (grid.reserved == 0) return content.full();
  return content.staticRefused != 0 || content.dynamicRefused != 0;
}

// The first slot that breaks a rule; -1: none.
int slotBehindBlank(const CellContent& content) {
  for (size_t slot = size_t(content.stored); slot < content.slots.size(); ++slot)
    if (content.slots[slot] != kBlank) return int(slot);
  return -1;
}

int slotOutOfOrder(const GridParameters& grid, const CellContent& content) {
  const uint32_t firstDynamic = firstDynamicReference(grid);
  for (int slot = 1; slot < content.stored; ++slot) {
    const uint32_t before = content.slots[slot - 1], reference = content.slots[slot];
    if (before >= firstDynamic && reference < firstDynamic) return slot;
    if (grid.insertion == kInsertionSorted && reference < before) return slot;
  }
  return -1;
}

int slotRepeated(const CellContent& content) {
  if (content.stored < 2) return -1;
  std::vector<uint32_t> sorted(content.slots.begin(), content.slots.begin() + content.stored);
  std::sort(sorted.begin(), sorted.end());
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
  if (twin == sorted.end()) return -1;
  const auto first = std::find(content.slots.begin(), content.slots.end(), *twin);
  return int(std::find(first + 1, content.slots.end(), *twin) - content.slots.begin());
}

int slotOutOfRange(const NumberedScene& scene, const CellContent& content) {
  for (size_t slot = 0; slot < content.slots.size(); ++slot) {
    const uint32_t reference = content.slots[slot];
    if (reference == kBlank) continue;
    const uint32_t instance = referenceInstance(reference);
    if (instance >= scene.instanceCount() || referenceTriangle(reference) >= scene.instances[instance].triangleCount) return int(slot);
  }
  return -1;
}

// A refusal needs a full cell; a static one, which came before everything dynamic, a cell full of static references.
int slotContradictingRefusal(const GridParameters& grid, const CellContent& content) {
  if (grid.reserved == 0) return -1;
  if ((content.staticRefused != 0 || content.dynamicRefused != 0) && !content.full()) return content.stored;
  if (grid.reserved != 2 || content.staticRefused == 0) return -1;
  for (int slot = 0; slot < content.stored; ++slot)
    if (content.slots[slot] >= firstDynamicReference(grid)) return slot;
  return -1;
}

// Counts the cells that break one rule, and remembers the first.
struct Rule {
  const char* key;
  const char* name;
  const char* text;
  uint64_t count = 0;
  ivec3 cell{};
  int slot = 0;
  uint32_t reference = 0;

  void note(const CellContent& content, int badSlot) {
    if (badSlot < 0) return;
    if (count++ == 0) cell = content.cell, slot = badSlot, reference = content.slots[badSlot];
  }
  Invariant outcome() const {
    if (count == 0) return {.key = key, .name = name};
    std::array<char, 256> line;
    std::snprintf(line.data(), line.size(), "%llu cell%s %s; the first is (%d, %d, %d): slot %d holds 0x%08X",
                  static_cast<unsigned long long>(count), count == 1 ? "" : "s", text, cell.x, cell.y, cell.z, slot, reference);
    return {.key = key, .name = name, .count = count, .fault = line.data()};
  }
};

std::string sumLine(uint64_t stored, uint64_t refused, uint64_t tried) {
  return "stored " + std::to_string(stored) + " + refused " + std::to_string(refused) + " is not tried " + std::to_string(tried);
}

}  // namespace

GridTotals countGrid(const Grid& grid) {
  GridTotals totals;
  totals.occupancyHistogram.resize(size_t(grid.parameters.capacity) + 1);
  GridStatistics& sums = totals.statistics;
  forCellContents(grid, [&](const CellContent& content) {
    const bool counts = grid.parameters.reserved == 2;  // otherwise refusals are known to exist, not how many
    const auto end = content.slots.begin() + content.stored;
    const uint32_t dynamic =
        uint32_t(std::count_if(content.slots.begin(), end, [&](uint32_t r) { return r >= firstDynamicReference(grid.parameters); }));
    sums.dynamicStored += dynamic;
    sums.staticStored += uint32_t(content.stored) - dynamic;
    sums.staticRefused += counts ? content.staticRefused : 0;
    sums.dynamicRefused += counts ? content.dynamicRefused : 0;
    sums.occupied += content.stored > 0 ? 1 : 0;
    sums.saturated += isSaturated(grid.parameters, content) ? 1 : 0;
    sums.maxDemand = std::max(sums.maxDemand, uint32_t(content.stored) + (counts ? content.staticRefused + content.dynamicRefused : 0));
    totals.occupancyHistogram[size_t(content.stored)] += 1;
  });
  return totals;
}

std::vector<Invariant> testCells(const Grid& grid, const NumberedScene& scene, const uint64_t* tried) {
  const GridParameters& parameters = grid.parameters;
  const bool sorted = parameters.insertion == kInsertionSorted;
  Rule blanks{"noBlankBefore", "no blank before a reference", "hold a reference behind a blank"};
  Rule order{"staticFirst", sorted ? "references rise, static before dynamic" : "static before dynamic",
             sorted ? "hold references that do not rise" : "hold a static reference behind a dynamic one"};
  Rule twins{"noDuplicate", "no duplicate", "hold a reference twice"};
  Rule range{"inRange", "references in range", "hold a reference to no triangle of the scene"};
  Rule refusals{"refusedWhenFull", "only full cells refuse", "refused a reference that a slot had room for"};
  uint64_t stored = 0, refused = 0;
  forCellContents(grid, [&](const CellContent& content) {
    blanks.note(content, slotBehindBlank(content));
    order.note(content, slotOutOfOrder(parameters, content));
    twins.note(content, slotRepeated(content));
    range.note(content, slotOutOfRange(scene, content));
    refusals.note(content, slotContradictingRefusal(parameters, content));
    stored += uint64_t(content.stored);
    refused += uint64_t(content.staticRefused) + content.dynamicRefused;
  });

  std::vector<Invariant> outcomes;
  for (const Rule* rule : {&blanks, &order, &twins, &range, &refusals}) outcomes.push_back(rule->outcome());
  if (parameters.reserved == 0) outcomes.back().whyNot = "the grid has no reserved texels that would say what was refused";

  // Devices count what they try in 32 bits.
  Invariant sum{.key = "sum", .name = "stored + refused = tried"};
  if (parameters.reserved != 2)
    sum.whyNot = "the grid does not count what it refuses";
  else if (tried == nullptr)
    sum.whyNot = "nobody counted what was tried";
  else if (uint32_t(stored + refused) != uint32_t(*tried))
    sum.count = 1, sum.fault = sumLine(stored, refused, *tried);
  outcomes.push_back(sum);
  return outcomes;
}

std::vector<std::string> checkInvariants(const Grid& grid, const NumberedScene& scene, const uint64_t* tried) {
  std::vector<std::string> lines;
  for (const Invariant& invariant : testCells(grid, scene, tried))
    if (!invariant.holds()) lines.push_back(invariant.fault);
  return lines;
}

}  // namespace gridscope
