// The explanation of a frame as JSON; see explain_report.h.
#include "app/report/explain_report.h"

#include "core/scene/numbering.h"
#include "core/truth/reason.h"

namespace gridscope {

using Json = nlohmann::ordered_json;

namespace {

// Rows of "meshes", "instances" and "cells" in the JSON.
constexpr size_t kMostRows = 10;

Json cellJson(ivec3 cell) { return Json::array({cell.x, cell.y, cell.z}); }

std::string nameOf(const std::vector<std::string>& names, uint32_t index) { return index < names.size() ? names[index] : ""; }

// The cells that lost its references.
Json whereJson(const GroupLoss& group) {
  Json list = Json::array();
  for (const GroupCell& cell : group.where) list.push_back({{"cell", cellJson(cell.cell)}, {"lost", cell.lost}, {"rays", cell.rays}});
  return list;
}

Json groupsJson(std::span<const GroupLoss> groups, const std::vector<std::string>& names) {
  Json list = Json::array();
  for (size_t i : worstOf(groups, kMostRows)) {
    const GroupLoss& group = groups[i];
    Json verdicts;
    for (uint32_t verdict = kVerdictHole; verdict < kVerdictCount; ++verdict)
      verdicts[std::string(verdictName(verdict).key)] = group.verdicts[verdict];
    list.push_back({{"index", group.index},
                    {"name", nameOf(names, group.index)},
                    {"rays", group.rays},
                    {"stored", group.stored},
                    {"lost", group.lost},
                    {"lostRays", group.lostRays},
                    {"triangles", group.triangles},
                    {"verdicts", verdicts},
                    {"where", whereJson(group)}});
  }
  return list;
}

Json worstCellsJson(const Ledger& ledger) {
  Json list = Json::array();
  for (size_t i : worstOf(ledger.cells, kMostRows)) {
    const CellLoss& cell = ledger.cells[i];
    list.push_back(
        {{"cell", cellJson(cell.cell)}, {"rays", cell.rays}, {"tried", cell.tried}, {"stored", cell.stored}, {"refused", cell.refused}});
  }
  return list;
}

Json rayJson(const ExplainReport& report, uint32_t ray) {
  const RayTruth& truth = report.frame.truths[ray];
  return {{"pixel", {ray % report.width, ray / report.width}},
          {"verdict", verdictName(truth.verdict).key},
          {"cause", causeName(truth.cause).key},
          {"off", distanceOff(report.frame, ray)},
          {"cell", cellJson(truth.cell)},
          {"reference", truth.reference},
          {"exactReference", truth.exactReference},
          {"exactT", truth.exactT},
          {"segment", truth.segment}};
}

void addProofs(Json& json, const ProofTotals& proofs) {
  const ProofTotals::Count sum = proofs.sum();
  Json controls, chains;
  for (uint32_t cause = kCauseRefused; cause < kCauseCount; ++cause) {
    const ProofTotals::Count& count = proofs.causes[cause];
    json["confirmed"][std::string(causeName(cause).key)] = {count.alone, count.chain, count.total};
    controls[std::string(causeName(cause).key)] = {count.controlConfirmed, count.controlTotal};
    chains[std::string(causeName(cause).key)] = {count.controlChained, count.controlTotal};
  }
  json["confirmedShare"] = sum.total == 0 ? 1.0 : double(sum.alone + sum.chain) / double(sum.total);
  json["aloneShare"] = sum.total == 0 ? 1.0 : double(sum.alone) / double(sum.total);
  const auto share = [&](uint64_t confirmed) { return sum.controlTotal == 0 ? 0.0 : double(confirmed) / double(sum.controlTotal); };
  json["control"] = {
      {"confirmed", sum.controlConfirmed}, {"total", sum.controlTotal}, {"share", share(sum.controlConfirmed)}, {"causes", controls}};
  json["controlChain"] = {
      {"confirmed", sum.controlChained}, {"total", sum.controlTotal}, {"share", share(sum.controlChained)}, {"causes", chains}};
  json["mostLinks"] = proofs.mostLinks;
  json["notConfirmed"] = proofs.notConfirmed.size();
}

// References of a cell, each with what a person calls it.
Json referencesJson(std::span<const uint32_t> references, const NumberedScene& scene, const CaptureNames& names) {
  Json list = Json::array();
  for (uint32_t reference : references) {
    Json one = {{"reference", reference}, {"mesh", meshText(scene, names, reference)}};
    if (isTriangleOf(scene, reference)) one["triangle"] = nameTriangle(scene, reference).triangle;
    list.push_back(std::move(one));
  }
  return list;
}

Json proofJson(const Proof& proof) {
  Json json = {{"confirmed", proof.confirmed}, {"foreign", proof.foreign}, {"links", Json::array()}};
  for (const TruthEvent& link : proof.links)
    json["links"].push_back(
        {{"cause", causeName(link.cause).key}, {"cell", cellJson(link.cell)}, {"reference", link.reference}, {"segment", link.segment}});
  return json;
}

}  // namespace

Json pixelJson(const ExplainReport& report, const CaptureNames& names, const ToldRay& ray) {
  const FrameTruth& frame = report.frame;
  const RayTruth& truth = frame.truths[ray.pixel];
  Json json = {{"x", ray.pixel % report.width}, {"y", ray.pixel / report.width}, {"story", plainText(ray.story)}};
  json.update(rayJson(report, ray.pixel));
  const TruthReason reason = reasonOf(frame.input(), frame.rays[ray.pixel], truth);
  if (!reason.key.empty()) json["reason"] = {{"key", reason.key}, {"about", reason.about}};
  if (gridContains(frame.grid.parameters, truth.cell)) {
    json["slots"] = referencesJson(storedIn(frame.grid, truth.cell), *frame.scene, names);
    json["refused"] = referencesJson(refusedBy(frame.grid, frame.demand, truth.cell), *frame.scene, names);
  }
  if (ray.proof && truth.cause != kCauseNone) json["proof"] = proofJson(*ray.proof);
  return json;
}

void addTruthTotals(Json& json, const TruthTotals& totals) {
  json["wrong"] = totals.wrong();
  json["agree"] = {{"hit", totals.agreeHit}, {"miss", totals.agreeMiss}};
  for (uint32_t verdict = kVerdictHole; verdict < kVerdictCount; ++verdict)
    json["verdicts"][std::string(verdictName(verdict).key)] = totals.verdicts[verdict];
  for (uint32_t cause = kCauseRefused; cause < kCauseCount; ++cause)
    json["causes"][std::string(causeName(cause).key)] = totals.causes[cause];
}

void addGridTotals(Json& json, const GridTotals& grid, bool countsRefused) {
  const GridStatistics& cells = grid.statistics;
  const auto counted = [&](uint64_t count) { return countsRefused ? Json(count) : Json(nullptr); };
  json["references"] = {
      {"tried", counted(grid.stored() + grid.refused())}, {"stored", grid.stored()}, {"refused", counted(grid.refused())}};
  json["cells"] = {{"occupied", cells.occupied}, {"saturated", cells.saturated}, {"maxDemand", counted(cells.maxDemand)}};
}

Json explainJson(const ExplainReport& report, const CaptureNames& names) {
  Json json = {{"rays", report.frame.totals.rays}};
  addTruthTotals(json, report.frame.totals);
  if (report.proofs) addProofs(json, *report.proofs);
  if (report.foreignHits) json["foreignHits"] = *report.foreignHits;
  addGridTotals(json, report.grid, report.countsRefused);
  json["worstMeshes"] = groupsJson(report.ledger.meshes, names.meshes);
  json["worstInstances"] = groupsJson(report.ledger.instances, names.instances);
  json["worstCells"] = worstCellsJson(report.ledger);
  json["worstRays"] = Json::array();
  for (uint32_t ray : report.worst) json["worstRays"].push_back(rayJson(report, ray));
  json["timesMs"] = {{"explain", report.explainMs}, {"prove", report.proveMs}};
  return json;
}

}  // namespace gridscope
