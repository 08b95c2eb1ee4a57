// See check_report.h.
#include "app/check_report.h"

#include <algorithm>

#include "app/explain_report.h"
#include "app/text.h"

namespace gridscope {

namespace {

using Json = nlohmann::ordered_json;

std::string wordOf(const Invariant& invariant) { return !invariant.whyNot.empty() ? "-" : invariant.holds() ? "ok" : "FAULT"; }

std::string stageName(const CheckedStage& stage, const CheckReport& report) {
  return report.stages.back().frame == 0 ? stage.stage : printed("%s %u", stage.stage.c_str(), stage.frame);
}

// References tried: what was stored, and what was refused as far as the grid counts it.
uint64_t triedIn(const GridTotals& grid) { return grid.stored() + grid.refused(); }

Json stageJson(const CheckedStage& stage) {
  Json json{{"stage", stage.stage}, {"frame", stage.frame}};
  for (const Invariant& invariant : stage.invariants) {
    Json& one = json["invariants"][invariant.key] = {{"name", invariant.name}, {"count", invariant.count}};
    if (invariant.whyNot.empty()) one["holds"] = invariant.holds();
    else one["whyNot"] = invariant.whyNot;
    if (!invariant.holds()) one["fault"] = invariant.fault;
  }
  return json;
}

Json stabilityJson(const Stability& stability, uint64_t rays) {
  return {{"builds", stability.builds}, {"occupied", stability.occupied}, {"setDiffers", stability.setDiffers},
          {"orderDiffers", stability.orderDiffers}, {"rays", rays}, {"raysChange", stability.raysChange}};
}

void printStability(std::FILE* out, const Stability& stability, const RayTotals& rays) {
  std::fprintf(out, "%-12s%u builds: %s of %s occupied cells hold other references, %s the same in another order; %s of %s rays end differently\n",
               "stability", stability.builds, grouped(stability.setDiffers).c_str(), grouped(stability.occupied).c_str(),
               grouped(stability.orderDiffers).c_str(), grouped(stability.raysChange).c_str(), grouped(rays.count).c_str());
}

}  // namespace

size_t CheckReport::broken() const {
  size_t count = 0;
  for (const CheckedStage& stage : stages) count += size_t(std::ranges::count_if(stage.invariants, [](const Invariant& one) { return !one.holds(); }));
  return count;
}

void printCheck(std::FILE* out, const Session& session, const CheckReport& report) {
  std::fprintf(out, "%s: %s\n", session.scene().name.c_str(), gridText(session.pipeline().parameters().grid).c_str());
  Table table("llll");
  for (const CheckedStage& stage : report.stages)
    for (const Invariant& invariant : stage.invariants)
      table.add({stageName(stage, report), invariant.name, wordOf(invariant), invariant.whyNot.empty() ? invariant.fault : invariant.whyNot});
  table.print(out);

  const GridStatistics& cells = report.grid.statistics;
  if (session.pipeline().parameters().grid.reserved == 2)
    std::fprintf(out, "%-12s%s tried, %s stored, %s refused (%s)\n", "references", grouped(triedIn(report.grid)).c_str(), grouped(report.grid.stored()).c_str(),
                 grouped(report.grid.refused()).c_str(), percentOf(report.grid.refused(), triedIn(report.grid)).c_str());
  else
    std::fprintf(out, "%-12s%s stored; what was refused is not counted\n", "references", grouped(report.grid.stored()).c_str());
  std::fprintf(out, "%-12s%s occupied, %s saturated (%s)\n", "cells", grouped(cells.occupied).c_str(), grouped(cells.saturated).c_str(),
               percentOf(cells.saturated, cells.occupied).c_str());
  if (report.stability) printStability(out, *report.stability, report.rays);
  if (report.truth)
    std::fprintf(out, "%-12s%s of %s rays (%s)\n", "wrong", grouped(report.truth->wrong()).c_str(), grouped(report.truth->rays).c_str(),
                 percentOf(report.truth->wrong(), report.truth->rays).c_str());
  if (report.broken() == 0) std::fprintf(out, "%-12severything that applies holds\n", "check");
  else std::fprintf(out, "%-12s%zu broken\n", "check", report.broken());
}

Json checkJson(const Session& session, const CheckReport& report) {
  const GridStatistics& cells = report.grid.statistics;
  Json json = deviceJson(session);
  json["scene"] = sceneJson(session);
  json["grid"] = gridJson(session.pipeline().parameters().grid);
  json["broken"] = report.broken();
  for (const CheckedStage& stage : report.stages) json["stages"].push_back(stageJson(stage));
  json["references"]["stored"] = report.grid.stored();
  if (session.pipeline().parameters().grid.reserved == 2) {
    json["references"]["tried"] = triedIn(report.grid);
    json["references"]["refused"] = report.grid.refused();
  }
  json["cells"] = {{"occupied", cells.occupied}, {"saturated", cells.saturated}, {"maxDemand", cells.maxDemand}};
  json["rays"] = report.rays.count;
  json["hits"] = {{"triangle", report.rays.triangleHits}, {"voxel", report.rays.voxelHits}, {"miss", report.rays.misses}};
  if (report.stability) json["stability"] = stabilityJson(*report.stability, report.rays.count);
  if (report.truth) addTruthTotals(json, *report.truth);
  return json;
}

}  // namespace gridscope
