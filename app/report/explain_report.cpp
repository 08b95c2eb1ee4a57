// The explanation of a frame as text; see explain_report.h.
#include "app/report/explain_report.h"

#include "app/base/text.h"
#include "core/capture/compare.h"

namespace gridscope {

namespace {

constexpr size_t kMostRows = 10;  // of the tables of meshes and cells

void printVerdicts(std::FILE* out, const TruthTotals& totals) {
  Table table("lrrl");
  const auto add = [&](const std::string& name, uint64_t count, const std::string& about) {
    table.add({name, grouped(count), percentOf(count, totals.rays), about});
  };
  add("rays", totals.rays, "");
  add("agree, hit", totals.agreeHit, "");
  add("agree, miss", totals.agreeMiss, "");
  for (uint32_t verdict = kVerdictHole; verdict < kVerdictCount; ++verdict)
    add(std::string(verdictName(verdict).title), totals.verdicts[verdict], std::string(verdictName(verdict).about));
  add("wrong", totals.wrong(), "hole + voxel wrong + too far + too near");
  table.print(out);
}

std::vector<std::string> proofCells(const ProofTotals::Count& count) {
  return {grouped(count.alone), grouped(count.chain), grouped(count.total - count.alone - count.chain),
          percentOf(count.controlConfirmed, count.controlTotal), percentOf(count.controlChained, count.controlTotal)};
}

void printCauses(std::FILE* out, const ExplainReport& report) {
  const TruthTotals& totals = report.frame.totals;
  Table table(report.proofs ? "lrrrrrrr" : "lrrl");
  std::vector<std::string> head = {"cause", "rays", "of those that differ"};
  if (report.proofs) head.insert(head.end(), {"confirmed alone", "as a chain", "not confirmed", "control alone", "control"});
  table.add(head);
  for (uint32_t cause = kCauseRefused; cause < kCauseCount; ++cause) {
    if (totals.causes[cause] == 0) continue;
    std::vector<std::string> row = {std::string(causeName(cause).title), grouped(totals.causes[cause]),
                                    percentOf(totals.causes[cause], totals.differ())};
    if (!report.proofs)
      row.push_back(std::string(causeName(cause).about));
    else
      for (std::string& text : proofCells(report.proofs->causes[cause])) row.push_back(std::move(text));
    table.add(row);
  }
  std::vector<std::string> sum = {"together", grouped(totals.differ()), ""};
  if (report.proofs)
    for (std::string& text : proofCells(report.proofs->sum())) sum.push_back(std::move(text));
  table.add(sum);
  table.print(out);
  if (report.proofs) {
    const ProofTotals::Count proven = report.proofs->sum();
    std::fprintf(
        out,
        "%s of the causes confirmed, %s alone; the longest chain has %s links. Control: another ray's event of the same cause removed "
        "first, alone and then going on as a chain.\n",
        percentOf(proven.alone + proven.chain, proven.total).c_str(), percentOf(proven.alone, proven.total).c_str(),
        grouped(report.proofs->mostLinks).c_str());
  }
}

void printMeshes(std::FILE* out, const ExplainReport& report, const CaptureNames& names) {
  Table table("rlrlrrrr");
  table.add({"rays", "", "by lost references", "mesh", "triangles", "references", "lost", ""});
  for (size_t i : worstOf(report.ledger.meshes, kMostRows)) {
    const GroupLoss& mesh = report.ledger.meshes[i];
    const bool named = mesh.index < names.meshes.size() && !names.meshes[mesh.index].empty();
    table.add({grouped(mesh.rays), percentOf(mesh.rays, report.frame.totals.rays), grouped(mesh.lostRays),
               named ? names.meshes[mesh.index] : printed("mesh %u", mesh.index), grouped(mesh.triangles), grouped(mesh.stored + mesh.lost),
               grouped(mesh.lost), percentOf(mesh.lost, mesh.stored + mesh.lost)});
  }
  table.print(out);
}

void printCells(std::FILE* out, const ExplainReport& report) {
  Table table("rllrrr");
  table.add({"rays", "", "cell", "tried", "stored", "refused"});
  for (size_t i : worstOf(report.ledger.cells, kMostRows)) {
    const CellLoss& cell = report.ledger.cells[i];
    table.add({grouped(cell.rays), percentOf(cell.rays, report.frame.totals.rays), cellText(cell.cell), grouped(cell.tried),
               grouped(cell.stored), grouped(cell.refused)});
  }
  table.print(out);
}

void printWorst(std::FILE* out, const ExplainReport& report, const CaptureNames& names) {
  Table table("rllll");
  table.add({"edges off", "pixel", "verdict", "cause", "surface"});
  for (uint32_t ray : report.worst) {
    const RayTruth& truth = report.frame.truths[ray];
    const Comparison how{"", "", *report.frame.scene, &names};
    table.add({printed("%.3g", double(distanceOff(report.frame, ray))), printed("%u,%u", ray % report.width, ray / report.width),
               std::string(verdictName(truth.verdict).title), std::string(causeName(truth.cause).title),
               truth.exactReference == kNoReference ? "none" : referenceText(how, truth.exactReference)});
  }
  table.print(out);
}

}  // namespace

ToldRay tellRay(const ExplainReport& report, const CaptureNames& names, uint32_t pixel) {
  const FrameTruth& frame = report.frame;
  const TruthInput input = frame.input();
  ToldRay told{.pixel = pixel};
  if (report.proofs) told.proof = proveRay(input, frame.rays[pixel], frame.hits[pixel], frame.exact[pixel], frame.truths[pixel]);
  told.story = tellPixel({.truth = input,
                          .names = names,
                          .pixel = pixel,
                          .width = report.width,
                          .ray = frame.rays[pixel],
                          .traced = frame.hits[pixel],
                          .exact = frame.exact[pixel],
                          .told = frame.truths[pixel],
                          .proof = told.proof ? &*told.proof : nullptr});
  return told;
}

void printExplain(std::FILE* out, const ExplainReport& report, const CaptureNames& names) {
  printVerdicts(out, report.frame.totals);
  if (report.frame.totals.differ() == 0) return;
  std::fprintf(out, "\nWhy rays differ\n");
  printCauses(out, report);
  std::fprintf(out, "\nThe meshes that cost the most rays\n");
  printMeshes(out, report, names);
  std::fprintf(out, "\nThe cells that cost the most rays\n");
  printCells(out, report);
  if (report.worst.empty()) return;
  std::fprintf(out, "\nThe worst rays\n");
  printWorst(out, report, names);
}

}  // namespace gridscope
