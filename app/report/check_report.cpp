// See check_report.h.
#include "app/report/check_report.h"

#include <algorithm>

#include "app/base/text.h"
#include "app/report/explain_report.h"

namespace gridscope {

namespace {

using Json = nlohmann::ordered_json;

std::string wordOf(const Invariant& invariant) { return !invariant.whyNot.empty() ? "-" : invariant.holds() ? "ok" : "FAULT"; }

std::string stageName(const CheckedStage& stage, const CheckReport& report) {
  return report.stages.back().frame == 0 ? stage.stage : printed("%s %u", stage.stage.c_str(), stage.frame);
}

bool countsRefused(const Session& session) { return gridAbilities(session.pipeline().parameters().grid).countsRefusals; }

// References tried: what was stored, and what was refused as far as the grid counts it.
uint64_t triedIn(const GridTotals& grid) { return grid.stored() + grid.refused(); }

void addFigures(Json& json, const Session& session, const CheckedFrame& frame) {
  addGridTotals(json, frame.grid, countsRefused(session));
  json["rays"] = frame.rays.count;
  json["hits"] = {{"triangle", frame.rays.triangleHits}, {"voxel", frame.rays.voxelHits}, {"miss", frame.rays.misses}};
  if (frame.foreignHits) json["foreignHits"] = *frame.foreignHits;
  if (frame.truth) addTruthTotals(json, *frame.truth);
}

Json stageJson(const CheckedStage& stage) {
  Json json{{"stage", stage.stage}, {"frame", stage.frame}};
  for (const Invariant& invariant : stage.invariants) {
    Json& one = json["invariants"][invariant.key] = {{"name", invariant.name}, {"count", invariant.count}};
    if (invariant.whyNot.empty())
      one["holds"] = invariant.holds();
    else
      one["whyNot"] = invariant.whyNot;
    if (!invariant.holds()) one["fault"] = invariant.fault;
  }
  return json;
}

Json stabilityJson(const Stability& stability, uint64_t rays) {
  return {{"builds", stability.builds},
          {"occupied", stability.occupied},
          {"setDiffers", stability.setDiffers},
          {"orderDiffers", stability.orderDiffers},
          {"rays", rays},
          {"raysChange", stability.raysChange}};
}

void printStability(std::FILE* out, const Stability& stability, const RayTotals& rays) {
  std::fprintf(
      out, "%-12s%u builds: %s of %s occupied cells hold other references, %s the same in another order; %s of %s rays end differently\n",
      "stability", stability.builds, grouped(stability.setDiffers).c_str(), grouped(stability.occupied).c_str(),
      grouped(stability.orderDiffers).c_str(), grouped(stability.raysChange).c_str(), grouped(rays.count).c_str());
}

void printFigures(std::FILE* out, const Session& session, const CheckedFrame& frame) {
  const GridStatistics& cells = frame.grid.statistics;
  if (countsRefused(session))
    std::fprintf(out, "%-12s%s tried, %s stored, %s refused (%s)\n", "references", grouped(triedIn(frame.grid)).c_str(),
                 grouped(frame.grid.stored()).c_str(), grouped(frame.grid.refused()).c_str(),
                 percentOf(frame.grid.refused(), triedIn(frame.grid)).c_str());
  else
    std::fprintf(out, "%-12s%s stored; what was refused is not counted\n", "references", grouped(frame.grid.stored()).c_str());
  std::fprintf(out, "%-12s%s occupied, %s saturated (%s)\n", "cells", grouped(cells.occupied).c_str(), grouped(cells.saturated).c_str(),
               percentOf(cells.saturated, cells.occupied).c_str());
  if (frame.foreignHits.value_or(0) > 0) std::fprintf(out, "%-12s%s\n", "hits", foreignHitsText(*frame.foreignHits).c_str());
  if (frame.truth)
    std::fprintf(out, "%-12s%s of %s rays (%s)\n", "wrong", grouped(frame.truth->wrong()).c_str(), grouped(frame.truth->rays).c_str(),
                 percentOf(frame.truth->wrong(), frame.truth->rays).c_str());
}

// A line a frame.
void printFrames(std::FILE* out, const Session& session, const std::vector<CheckedFrame>& frames) {
  Table table("rrrrrrr");
  table.add({"frame", "stored", "refused", "saturated", "foreign hits", "wrong", ""});
  for (size_t i = 0; i < frames.size(); ++i) {
    const CheckedFrame& frame = frames[i];
    table.add({std::to_string(i), grouped(frame.grid.stored()), countsRefused(session) ? grouped(frame.grid.refused()) : "-",
               grouped(frame.grid.statistics.saturated), frame.foreignHits ? grouped(*frame.foreignHits) : "-",
               frame.truth ? grouped(frame.truth->wrong()) : "-", frame.truth ? percentOf(frame.truth->wrong(), frame.truth->rays) : ""});
  }
  table.print(out);
}

}  // namespace

size_t CheckReport::broken() const {
  size_t count = 0;
  for (const CheckedStage& stage : stages)
    count += size_t(std::ranges::count_if(stage.invariants, [](const Invariant& one) { return !one.holds(); }));
  return count;
}

void printCheck(std::FILE* out, const Session& session, const CheckReport& report) {
  std::fprintf(out, "%s: %s\n", session.scene().name.c_str(), gridText(session.pipeline().parameters().grid).c_str());
  Table table("llll");
  for (const CheckedStage& stage : report.stages)
    for (const Invariant& invariant : stage.invariants)
      table.add(
          {stageName(stage, report), invariant.name, wordOf(invariant), invariant.whyNot.empty() ? invariant.fault : invariant.whyNot});
  table.print(out);

  if (report.frames.size() == 1)
    printFigures(out, session, report.frames.front());
  else
    printFrames(out, session, report.frames);
  if (report.stability) printStability(out, *report.stability, report.frames.back().rays);
  if (report.broken() == 0)
    std::fprintf(out, "%-12severything that applies holds\n", "check");
  else
    std::fprintf(out, "%-12s%zu broken\n", "check", report.broken());
}

Json checkJson(const Session& session, const CheckReport& report, size_t frame) {
  Json json = deviceJson(session);
  json["scene"] = sceneJson(session);
  json["grid"] = gridJson(session.pipeline().parameters().grid);
  json["broken"] = report.broken();
  json["stages"] = Json::array();
  for (const CheckedStage& stage : report.stages) json["stages"].push_back(stageJson(stage));
  addFigures(json, session, report.frames[frame]);
  if (report.stability) json["stability"] = stabilityJson(*report.stability, report.frames.back().rays.count);
  if (report.frames.size() == 1) return json;
  for (const CheckedFrame& one : report.frames) addFigures(json["frames"].emplace_back(), session, one);
  return json;
}

}  // namespace gridscope
