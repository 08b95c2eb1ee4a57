// See ledger.h.
#include "core/truth/ledger.h"

#include <algorithm>
#include <map>

namespace gridscope {

namespace {

// The triangle that a ray's fault is charged to: the one that it should have hit; where there is none, the one that the event is about.
uint32_t chargedReference(const RayTruth& truth) { return truth.exactReference != kNoReference ? truth.exactReference : truth.reference; }

// Was the ray's surface lost for want of a slot?
bool byLostReference(const RayTruth& truth) { return truth.cause == kCauseRefused || truth.cause == kCauseGate; }

bool differs(const RayTruth& truth) { return truth.verdict != kVerdictNoRay && truth.verdict != kVerdictAgrees; }

// Losses of all triangles by world triangle, from the cells' slots and what was wanted of them; and the cells'.
struct Losses {
  const TruthInput& input;
  std::vector<CellLoss> cells;
  std::vector<TriangleLoss> triangles;

  explicit Losses(const TruthInput& truthInput) : input(truthInput) {
    const NumberedScene& scene = input.trace.scene;
    triangles.resize(scene.triangleCount);
    for (uint32_t i = 0; i < scene.instanceCount(); ++i)
      for (uint32_t k = 0; k < scene.instances[i].triangleCount; ++k)
        triangles[scene.instances[i].firstWorldTriangle + k].reference = makeReference(i, k);
  }

  // Null for a reference to no triangle of the scene: a damaged grid's.
  TriangleLoss* find(uint32_t reference) {
    const NumberedScene& scene = input.trace.scene;
    if (referenceInstance(reference) >= scene.instanceCount()) return nullptr;
    const Instance& instance = scene.instances[referenceInstance(reference)];
    if (referenceTriangle(reference) >= instance.triangleCount) return nullptr;
    return &triangles[instance.firstWorldTriangle + referenceTriangle(reference)];
  }

  void addCell(ivec3 cell) {
    const std::vector<uint32_t> stored = storedIn(input.trace.grid, cell);
    const std::vector<uint32_t> refused = refusedBy(input.trace.grid, input.demand, cell);
    if (stored.empty() && refused.empty()) return;
    for (uint32_t reference : stored)
      if (TriangleLoss* loss = find(reference)) ++loss->stored;
    for (uint32_t reference : refused)
      if (TriangleLoss* loss = find(reference)) ++loss->lost;
    cells.push_back({.cell = cell,
                     .tried = uint32_t(stored.size() + refused.size()),
                     .stored = uint32_t(stored.size()),
                     .refused = uint32_t(refused.size())});
  }

  void addAllCells() {
    const ivec3 count = input.trace.grid.parameters.cellCount;
    ivec3 cell;
    for (cell.z = 0; cell.z < count.z; ++cell.z)
      for (cell.y = 0; cell.y < count.y; ++cell.y)
        for (cell.x = 0; cell.x < count.x; ++cell.x) addCell(cell);
  }

  void chargeRays(std::span<const RayTruth> truths) {
    const GridParameters& grid = input.trace.grid.parameters;
    std::map<size_t, uint32_t> raysOfCell;
    for (const RayTruth& truth : truths) {
      if (!differs(truth)) continue;
      if (gridContains(grid, truth.cell)) ++raysOfCell[idOfCell(grid, truth.cell)];
      if (TriangleLoss* loss = find(chargedReference(truth))) {
        loss->rays += 1;
        loss->lostRays += byLostReference(truth) ? 1 : 0;
      }
    }
    for (CellLoss& loss : cells) {
      const auto found = raysOfCell.find(idOfCell(grid, loss.cell));
      if (found != raysOfCell.end()) loss.rays = found->second;
    }
  }
};

// Which of the two kinds of group, by a number that each of the grid's instances has.
using GroupNumber = uint32_t (*)(const InstanceSource& source);

std::vector<GroupLoss> sumGroups(const Losses& losses, std::span<const RayTruth> truths, GroupNumber numberOf) {
  const NumberedScene& scene = losses.input.trace.scene;
  std::map<uint32_t, GroupLoss> groups;
  for (uint32_t i = 0; i < scene.instanceCount(); ++i) {
    GroupLoss& group = groups[numberOf(scene.sources[i])];
    group.index = numberOf(scene.sources[i]);
    group.triangles += scene.instances[i].triangleCount;
    for (uint32_t k = 0; k < scene.instances[i].triangleCount; ++k) {
      const TriangleLoss& loss = losses.triangles[scene.instances[i].firstWorldTriangle + k];
      group.stored += loss.stored;
      group.lost += loss.lost;
      group.rays += loss.rays;
      group.lostRays += loss.lostRays;
    }
  }
  for (const RayTruth& truth : truths) {
    const uint32_t instance = referenceInstance(chargedReference(truth));
    if (differs(truth) && instance < scene.instanceCount()) ++groups[numberOf(scene.sources[instance])].verdicts[truth.verdict];
  }
  std::vector<GroupLoss> list;
  for (auto& [number, group] : groups) list.push_back(std::move(group));
  return list;
}

// The rays that lost references cost, by group and cell.
std::map<std::pair<uint32_t, size_t>, uint32_t> lostRaysByCell(const Losses& losses, std::span<const RayTruth> truths,
                                                               GroupNumber numberOf) {
  const TraceInput& trace = losses.input.trace;
  std::map<std::pair<uint32_t, size_t>, uint32_t> rays;
  for (const RayTruth& truth : truths) {
    const uint32_t instance = referenceInstance(chargedReference(truth));
    if (!byLostReference(truth) || instance >= trace.scene.instanceCount() || !gridContains(trace.grid.parameters, truth.cell)) continue;
    ++rays[{numberOf(trace.scene.sources[instance]), idOfCell(trace.grid.parameters, truth.cell)}];
  }
  return rays;
}

bool costsMore(const GroupCell& a, const GroupCell& b) { return a.rays != b.rays ? a.rays > b.rays : a.lost > b.lost; }

// Where each group's references were lost: cell by cell, keeping the worst few of each group.
void placeLosses(const Losses& losses, std::span<const RayTruth> truths, GroupNumber numberOf, std::vector<GroupLoss>& groups) {
  const TraceInput& trace = losses.input.trace;
  const auto rays = lostRaysByCell(losses, truths, numberOf);
  for (const CellLoss& cell : losses.cells) {
    if (cell.refused == 0) continue;
    std::map<uint32_t, GroupCell> here;
    for (uint32_t reference : refusedBy(trace.grid, losses.input.demand, cell.cell))
      ++here[numberOf(trace.scene.sources[referenceInstance(reference)])].lost;
    for (auto& [number, lost] : here) {
      const auto cost = rays.find({number, idOfCell(trace.grid.parameters, cell.cell)});
      lost.cell = cell.cell;
      lost.rays = cost == rays.end() ? 0 : cost->second;
      std::vector<GroupCell>& where = std::ranges::lower_bound(groups, number, {}, &GroupLoss::index)->where;
      where.insert(std::ranges::upper_bound(where, lost, costsMore), lost);
      if (where.size() > kMostGroupCells) where.pop_back();
    }
  }
}

std::vector<GroupLoss> listGroups(const Losses& losses, std::span<const RayTruth> truths, GroupNumber numberOf) {
  std::vector<GroupLoss> groups = sumGroups(losses, truths, numberOf);
  placeLosses(losses, truths, numberOf, groups);
  return groups;
}

template <typename Loss>
std::vector<size_t> worst(std::span<const Loss> losses, size_t count) {
  std::vector<size_t> order;
  for (size_t i = 0; i < losses.size(); ++i)
    if (losses[i].rays > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return losses[a].rays > losses[b].rays; });
  order.resize(std::min(order.size(), count));
  return order;
}

}  // namespace

Ledger makeLedger(const TruthInput& input, std::span<const RayTruth> truths) {
  Losses losses(input);
  losses.addAllCells();
  losses.chargeRays(truths);
  Ledger ledger;
  ledger.instances = listGroups(losses, truths, [](const InstanceSource& source) { return source.sceneInstance; });
  ledger.meshes = listGroups(losses, truths, [](const InstanceSource& source) { return source.mesh; });
  ledger.cells = std::move(losses.cells);
  ledger.triangles = std::move(losses.triangles);
  return ledger;
}

std::vector<size_t> worstOf(std::span<const CellLoss> cells, size_t count) { return worst(cells, count); }
std::vector<size_t> worstOf(std::span<const TriangleLoss> triangles, size_t count) { return worst(triangles, count); }
std::vector<size_t> worstOf(std::span<const GroupLoss> groups, size_t count) { return worst(groups, count); }

}  // namespace gridscope
