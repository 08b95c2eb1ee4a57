// See pixel_story.h.
#include "app/report/pixel_story.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/base/text.h"
#include "app/report/story_writer.h"
#include "core/truth/cause.h"
#include "core/truth/reason.h"

namespace gridscope {

namespace {

// The slots of a cell are told by mesh, the most first; more meshes than these are summed up.
constexpr size_t kMostMeshesTold = 5;

std::string edgesText(float edges) { return printed("%.3g cell edges", double(edges)); }

// Tells one pixel.
struct Teller {
  const StoryInput& input;
  StoryWriter& story;
  const TruthInput& truth = input.truth;
  const Grid& grid = truth.trace.grid;
  const RayTruth& told = input.told;

  float inEdges(float length) const { return length / grid.parameters.cellEdge; }

  void tellSurface() {
    if (input.exact.kind != kHitTriangle) return void(story.text("There is no surface on the ray's way.").end());
    story.text("The nearest surface is ").triangle(input.exact.reference).text(", ").number(edgesText(inEdges(input.exact.t)));
    const ivec3 home = hitCell(grid.parameters, input.ray, input.exact);
    if (gridContains(grid.parameters, home))
      story.text(" along the ray, in ").cell(home).text(".").end();
    else
      story.text(" along the ray, outside the grid.").end();
  }

  void tellEnd() {
    if (input.traced.kind == kHitTriangle || input.traced.kind == kHitVoxel) {
      story.text(input.traced.kind == kHitVoxel ? "The ray ends with a voxel hit, painted with " : "The ray hits ");
      story.triangle(input.traced.reference);
      story.text(", ").number(edgesText(inEdges(input.traced.t))).text(" along the ray");
      if (input.exact.kind == kHitTriangle && told.verdict != kVerdictAgrees)
        story.text(": ").number(edgesText(std::abs(told.error))).text(told.error < 0.0f ? " too near" : " too far");
      story.text(".").end();
    } else {
      const bool limit = input.traced.kind == kHitLimit;
      story.text(limit ? "The limit of segments ends the ray." : "The ray meets nothing and leaves the grid.").end();
    }
  }

  // "holds 16 references: 9 of tuft, 7 of wall".
  void tellSlots(ivec3 cell) {
    const std::vector<uint32_t> stored = storedIn(grid, cell);
    const std::vector<uint32_t> refused = refusedBy(grid, truth.demand, cell);
    story.text("That cell was asked to take ").number(grouped(stored.size() + refused.size())).text(" references, holds ");
    story.number(grouped(stored.size())).text(" and refused ").number(grouped(refused.size())).text(".");
    std::map<std::string, std::pair<uint32_t, uint32_t>> meshes;  // name: a reference, how many
    for (uint32_t reference : stored) {
      auto& [first, count] = meshes[meshText(truth.trace.scene, input.names, reference)];
      first = count++ == 0 ? reference : first;
    }
    std::vector<std::pair<uint32_t, uint32_t>> counts;
    for (const auto& [name, entry] : meshes) counts.push_back(entry);
    std::ranges::stable_sort(counts, [](const auto& a, const auto& b) { return a.second > b.second; });
    for (size_t i = 0; i < std::min(counts.size(), kMostMeshesTold); ++i)
      story.text(i == 0 ? " Its slots hold " : ", ").number(grouped(counts[i].second)).text(" of ").mesh(counts[i].first);
    if (counts.size() > kMostMeshesTold) story.text(printed(" and triangles of %zu more meshes", counts.size() - kMostMeshesTold));
    story.text(counts.empty() ? "" : ".").end();
  }

  void tellCut(ivec3 cell) {
    const vec2 stay = cellStay(grid.parameters, input.ray, cell);
    const float edge = grid.parameters.cellEdge;
    const int before = int(std::floor(stay.x / edge)), after = before + 1;
    const ivec3 from = gridCell(grid.parameters, rayPoint(input.ray, float(before) * edge));
    const ivec3 to = gridCell(grid.parameters, rayPoint(input.ray, float(after) * edge));
    story.text("The ray is in that cell for ").number(edgesText(inEdges(std::max(stay.y - stay.x, 0.0f)))).text(" only: ");
    story.step(before, from)
        .text(" starts before it in ")
        .cell(from)
        .text(", ")
        .step(after, to)
        .text(" behind it in ")
        .cell(to)
        .text(".")
        .end();
  }

  // How far the ray was from its launching surface, beside the gate.
  void tellGate() {
    const RayRecord record = recordRay(truth.trace, input.ray);
    const auto isTold = [&](const StepRecord& one) { return one.segment == told.segment && one.cell == told.cell; };
    const auto step = std::ranges::find_if(record.steps, isTold);
    if (step == record.steps.end()) return;
    story.text("There the ray was ").number(edgesText(inEdges(step->travel)));
    story.text(" from the plane of the surface that it left; gaps are filled beyond ");
    story.number(edgesText(inEdges(truth.trace.parameters.gate))).text(".").end();
  }

  void tellCause() {
    story.text("Cause: ").text(std::string(causeName(told.cause).title)).text(". ").text(std::string(causeName(told.cause).about));
    const TruthReason reason = reasonOf(truth, input.ray, told);
    if (!reason.about.empty()) story.text(" ").text(std::string(reason.about));
    if (gridContains(grid.parameters, told.cell)) story.text(" It took place in ").cell(told.cell);
    if (told.segment >= 0) story.text(gridContains(grid.parameters, told.cell) ? ", " : " It took place in ").step(told.segment, told.cell);
    if (told.reference != kNoReference) story.text(", and is about ").triangle(told.reference);
    story.text(told.segment >= 0 || gridContains(grid.parameters, told.cell) || told.reference != kNoReference ? "." : "").end();
    if (!gridContains(grid.parameters, told.cell)) return;
    if (told.cause == kCauseSteppedOver) return tellCut(told.cell);
    if (told.cause == kCauseGate) tellGate();
    tellSlots(told.cell);
  }

  // Without the links.
  static std::string proofText(const Proof& proof) {
    const char* end = proof.foreign ? "the ray ends as the frame's hit does" : "the ray agrees";
    const char* other = proof.foreign ? "the ray does not end as the frame's hit does" : "the ray does not agree";
    const char* taken = proof.foreign ? "with that rule changed" : "without that event";
    const char* all = proof.foreign ? "rules changed" : "events taken away";
    const size_t links = proof.links.size();
    if (proof.confirmed && links == 1) return printed("Proof: traced again %s alone, %s", taken, end);
    if (proof.confirmed) return printed("Proof: with these %zu %s, one after the other, %s", links, all, end);
    return links == 1 ? printed("Not confirmed: traced again %s, %s", taken, other)
                      : printed("Not confirmed: with these %zu %s %s", links, all, other);
  }

  void tellProof() {
    if (!input.proof || input.proof->links.empty()) return;
    const std::vector<TruthEvent>& links = input.proof->links;
    story.text(proofText(*input.proof));
    if (links.size() == 1 && input.proof->confirmed) return void(story.text(".").end());
    for (size_t i = 0; i < links.size(); ++i) {
      story.text(i == 0 ? ": " : "; ").text(std::string(causeName(links[i].cause).title));
      if (gridContains(grid.parameters, links[i].cell)) story.text(" in ").cell(links[i].cell);
    }
    story.text(".").end();
  }
};

}  // namespace

bool isTriangleOf(const NumberedScene& scene, uint32_t reference) {
  return referenceInstance(reference) < scene.instanceCount() &&
         referenceTriangle(reference) < scene.instances[referenceInstance(reference)].triangleCount;
}

std::string meshText(const NumberedScene& scene, const CaptureNames& names, uint32_t reference) {
  if (referenceInstance(reference) >= scene.instanceCount()) return printed("0x%08X", reference);
  const uint32_t mesh = scene.sources[referenceInstance(reference)].mesh;
  if (mesh < names.meshes.size() && !names.meshes[mesh].empty()) return names.meshes[mesh];
  return printed("mesh %u", mesh);
}

std::vector<StoryPart> tellVerdict(const StoryInput& input) {
  StoryWriter story(input);
  const std::string title(verdictName(input.told.verdict).title);
  story.text(printed("Pixel (%u, %u): ", input.pixel % input.width, input.pixel / input.width)).text(title);
  if (input.told.cause == kCauseNone) return story.text(". ").text(std::string(verdictName(input.told.verdict).about)).end().take();
  story.text(", ").text(std::string(causeName(input.told.cause).title));
  if (gridContains(input.truth.trace.grid.parameters, input.told.cell)) story.text(" in ").cell(input.told.cell);
  if (input.told.exactReference != kNoReference) story.text("; the surface is ").triangle(input.told.exactReference);
  return story.text(".").end().take();
}

std::vector<StoryPart> tellPixel(const StoryInput& input) {
  StoryWriter story(input);
  Teller teller{input, story};
  std::vector<StoryPart> parts = tellVerdict(input);
  if (input.told.verdict == kVerdictNoRay) return parts;
  teller.tellSurface();
  teller.tellEnd();
  if (input.told.cause != kCauseNone) teller.tellCause();
  teller.tellProof();
  for (StoryPart& part : story.take()) parts.push_back(std::move(part));
  return parts;
}

std::string plainText(const std::vector<StoryPart>& parts) {
  std::string text;
  for (const StoryPart& part : parts) text += part.text;
  return text;
}

}  // namespace gridscope
