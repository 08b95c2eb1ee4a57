// The tables of a report's page that say which rays are wrong, why, and what cost them; see page_sections.h.
#include <algorithm>

#include "app/base/text.h"
#include "app/report/page_html.h"
#include "app/report/page_sections.h"
#include "core/capture/compare.h"
#include "shaders/shared/views/truth_colours.h"

namespace gridscope {

namespace {

constexpr size_t kMostRows = 10;

double shareOf(uint64_t part, uint64_t whole) { return whole == 0 ? 0.0 : double(part) / double(whole); }

std::string nameOr(const std::vector<std::string>& names, uint32_t index, const char* kind) {
  return index < names.size() && !names[index].empty() ? names[index] : printed("%s %u", kind, index);
}

std::string verdictTable(const TruthTotals& totals) {
  PageTable table("Verdicts", "nrrbl", {"verdict", "rays", "share", "", ""});
  auto add = [&](const std::string& name, uint64_t count, uint32_t colour, const std::string& about) {
    table.add({PageCell::named(name, cssColour(colour)), grouped(count), percentOf(count, totals.rays),
               PageCell::bar(shareOf(count, totals.rays), cssColour(colour)), about});
  };
  add("agrees, hit", totals.agreeHit, kColourTriangleHit, "a triangle hit at the exact distance");
  add("agrees, miss", totals.agreeMiss, kColourMiss, "nothing is there and nothing was hit");
  for (uint32_t verdict = kVerdictHole; verdict < kVerdictCount; ++verdict)
    add(std::string(verdictName(verdict).title), totals.verdicts[verdict], verdictColour(verdict), std::string(verdictName(verdict).about));
  table.add({"wrong", grouped(totals.wrong()), percentOf(totals.wrong(), totals.rays), PageCell::bar(shareOf(totals.wrong(), totals.rays)),
             "hole + voxel wrong + too far + too near"},
            true);
  return table.html();
}

std::string causeTable(const TruthTotals& totals) {
  PageTable table("Causes: the first event along the ray that made it differ", "nrrbl", {"cause", "rays", "of those that differ", "", ""});
  std::vector<uint32_t> causes;
  for (uint32_t cause = kCauseNone + 1; cause < kCauseCount; ++cause)
    if (totals.causes[cause] > 0) causes.push_back(cause);
  std::ranges::stable_sort(causes, [&](uint32_t a, uint32_t b) { return totals.causes[a] > totals.causes[b]; });
  for (uint32_t cause : causes) {
    const std::string colour = cssColour(causeColour(cause));
    table.add({PageCell::named(std::string(causeName(cause).title), colour), grouped(totals.causes[cause]),
               percentOf(totals.causes[cause], totals.differ()), PageCell::bar(shareOf(totals.causes[cause], totals.differ()), colour),
               std::string(causeName(cause).about)});
  }
  return table.html("No ray differs from the exact answer.");
}

std::string proofTable(const ProofTotals& proofs) {
  PageTable table("Proofs: each ray traced again without that event alone", "nrrrrbrr",
                  {"cause", "rays", "confirmed alone", "as a chain", "not confirmed", "confirmed", "control alone", "control"});
  const auto add = [&](const PageCell& name, const ProofTotals::Count& count, bool marked) {
    const uint64_t confirmed = count.alone + count.chain;
    table.add({name, grouped(count.total), grouped(count.alone), grouped(count.chain), grouped(count.total - confirmed),
               PageCell::bar(shareOf(confirmed, count.total)), percentOf(count.controlConfirmed, count.controlTotal),
               percentOf(count.controlChained, count.controlTotal)},
              marked);
  };
  for (uint32_t cause = kCauseNone + 1; cause < kCauseCount; ++cause)
    if (proofs.causes[cause].total > 0)
      add(PageCell::named(std::string(causeName(cause).title), cssColour(causeColour(cause))), proofs.causes[cause], false);
  add(PageCell("together"), proofs.sum(), true);
  return table.html() +
         paragraph(
             "A chain: without the first event the ray differs again with a later one, which is removed too, and so on; the longest has " +
             grouped(proofs.mostLinks) +
             " links. Control: the event of another ray of the same cause removed first, and the share of rays that this alone, or as a "
             "chain by the same rules, makes agree.");
}

// Meshes or instances: which cost the most rays.
std::string groupTable(const char* caption, const std::vector<GroupLoss>& groups, const std::vector<std::string>& names, const char* kind,
                       uint64_t rays) {
  PageTable table(caption, "lrrbrrrr", {kind, "rays", "of all", "", "by lost references", "triangles", "references lost", "of tried"});
  const std::vector<size_t> worst = worstOf(groups, kMostRows);
  for (size_t i : worst) {
    const GroupLoss& group = groups[i];
    table.add({nameOr(names, group.index, kind), grouped(group.rays), percentOf(group.rays, rays),
               PageCell::bar(shareOf(group.rays, groups[worst[0]].rays)), grouped(group.lostRays), grouped(group.triangles),
               grouped(group.lost), percentOf(group.lost, group.stored + group.lost)});
  }
  return table.html("None cost a ray.");
}

std::string cellTable(const Ledger& ledger, uint64_t rays) {
  PageTable table("The ten cells that cost the most rays", "nrrbrrr", {"cell", "rays", "of all", "", "tried", "stored", "refused"});
  const std::vector<size_t> worst = worstOf(ledger.cells, kMostRows);
  for (size_t i : worst) {
    const CellLoss& cell = ledger.cells[i];
    table.add({cellText(cell.cell), grouped(cell.rays), percentOf(cell.rays, rays),
               PageCell::bar(shareOf(cell.rays, ledger.cells[worst[0]].rays)), grouped(cell.tried), grouped(cell.stored),
               grouped(cell.refused)});
  }
  return table.html("None cost a ray.");
}

// Instances of one file often share a name: their mesh's goes with it.
std::vector<std::string> instanceNames(const PageFrame& frame) {
  std::vector<std::string> names = frame.names.instances;
  std::vector<bool> done(names.size(), false);
  for (const InstanceSource& source : frame.explained.frame.scene->sources) {
    if (source.sceneInstance >= names.size() || done[source.sceneInstance]) continue;
    done[source.sceneInstance] = true;
    std::string& name = names[source.sceneInstance];
    const std::string mesh = nameOr(frame.names.meshes, source.mesh, "mesh");
    if (name != mesh) name = nameOr(names, source.sceneInstance, "instance") + " (" + mesh + ")";
  }
  return names;
}

std::string worstTable(const PageFrame& frame) {
  const ExplainReport& explained = frame.explained;
  const Comparison how{"", "", *explained.frame.scene, &frame.names};
  PageTable table("The worst rays: whose ends are farthest off", "nrnnl",
                  {"pixel", "cell edges off", "verdict", "cause", "surface that should have been hit"});
  for (uint32_t ray : explained.worst) {
    const RayTruth& truth = explained.frame.truths[ray];
    table.add({PageCell::pixel(printed("%u,%u", ray % explained.width, ray / explained.width)),
               printed("%.3g", double(distanceOff(explained.frame, ray))),
               PageCell::named(std::string(verdictName(truth.verdict).title), cssColour(verdictColour(truth.verdict))),
               PageCell::named(std::string(causeName(truth.cause).title), cssColour(causeColour(truth.cause))),
               truth.exactReference == kNoReference ? "none" : referenceText(how, truth.exactReference)});
  }
  return table.html("No ray is wrong.");
}

}  // namespace

std::string verdictsHtml(const PageFrame& frame) {
  const TruthTotals& totals = frame.explained.frame.totals;
  const std::string proofs =
      frame.explained.proofs
          ? proofTable(*frame.explained.proofs)
          : "<p class=\"dim\">So many causes are not proven without being asked: --verify takes each away and traces the ray again.</p>\n";
  return "<div class=\"columns\"><div>" + verdictTable(totals) + "</div><div>" + causeTable(totals) + "</div></div>\n" + proofs;
}

std::string costsHtml(const PageFrame& frame) {
  const Ledger& ledger = frame.explained.ledger;
  const uint64_t rays = frame.explained.frame.totals.rays;
  return "<div class=\"columns\"><div>" +
         groupTable("The ten meshes that cost the most rays", ledger.meshes, frame.names.meshes, "mesh", rays) + "</div><div>" +
         groupTable("The ten instances that cost the most rays", ledger.instances, instanceNames(frame), "instance", rays) + "</div><div>" +
         cellTable(ledger, rays) + "</div><div>" + worstTable(frame) + "</div></div>\n";
}

}  // namespace gridscope
