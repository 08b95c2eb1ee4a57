// See pixel_brief.h.
#include "app/report/pixel_brief.h"

#include <algorithm>
#include <cmath>

#include "app/report/story_writer.h"
#include "core/truth/cause.h"
#include "core/truth/reason.h"

namespace gridscope {

namespace {

std::string cellsText(float cells) { return printed(cells < 10.0f ? "%.2f cells" : "%.1f cells", double(cells)); }

struct BriefTeller {
  const StoryInput& input;
  StoryWriter& story;
  const RayTruth& told = input.told;
  const Grid& grid = input.truth.trace.grid;
  RayRecord record = recordRay(input.truth.trace, input.ray);

  float inCells(float length) const { return length / grid.parameters.cellEdge; }
  bool surface() const { return input.exact.kind == kHitTriangle; }
  bool inGrid() const { return gridContains(grid.parameters, told.cell); }

  // "nave vault, triangle 5,388".
  StoryWriter& named(uint32_t reference) { return story.mesh(reference).text(", ").triangleAlone(reference); }

  void tellAgreement() {
    if (surface())
      story.text("The reflection shows "), named(input.exact.reference).text(", as it should.");
    else
      story.text("The reflection shows no surface, as it should: none lies on the ray's way.");
  }

  void tellShould() {
    if (surface())
      story.text("The reflection should show "), named(input.exact.reference).text(". ");
    else
      story.text("The reflection should show no surface: none lies on the ray's way. ");
  }

  // "53 references tried, 32 stored".
  void tellCounts() {
    const size_t stored = storedIn(grid, told.cell).size(), refused = refusedBy(grid, input.truth.demand, told.cell).size();
    story.number(grouped(stored + refused)).text(" references tried, ").number(grouped(stored)).text(" stored. ");
  }

  void tellRefused() {
    story.text("That triangle was ").refusedWord().text(" by ").cell(told.cell).text(": ");
    tellCounts();
  }

  void tellGate() {
    tellRefused();
    const auto step =
        std::ranges::find_if(record.steps, [&](const StepRecord& one) { return one.segment == told.segment && one.cell == told.cell; });
    if (step == record.steps.end()) return;
    story.text("Its gap was not filled: the ray was only ")
        .number(cellsText(inCells(step->travel)))
        .text(" from the surface that it left, and the gate is ");
    story.number(cellsText(inCells(input.truth.trace.parameters.gate))).text(". ");
  }

  void tellFilledEarly() {
    story.text(surface() ? "Before it lies " : "On its way lies ").cell(told.cell).text(", which is full: ");
    tellCounts();
  }

  void tellSteppedOver() {
    const vec2 stay = cellStay(grid.parameters, input.ray, told.cell);
    const int before = int(std::floor(inCells(stay.x)));
    const auto cellAt = [&](int segment) {
      return gridCell(grid.parameters, rayPoint(input.ray, float(segment) * grid.parameters.cellEdge));
    };
    story.text("No segment starts in its ")
        .cell(told.cell)
        .text(", where the ray is for ")
        .number(cellsText(inCells(std::max(stay.y - stay.x, 0.0f))));
    story.text(" only: ")
        .step(before, cellAt(before))
        .text(" starts before it, ")
        .step(before + 1, cellAt(before + 1))
        .text(" behind it. ");
  }

  void tellAcceptedEarly() {
    story.text("Before it ").step(told.segment, told.cell).text(" accepted a hit of ").cell(told.cell).text(" that lies farther on. ");
  }

  void tellOther() {
    const TruthReason reason = reasonOf(input.truth, input.ray, told);
    story.text(std::string(reason.about.empty() ? causeName(told.cause).about : reason.about)).text(" ");
    if (inGrid()) story.text("It took place in ").cell(told.cell).text(". ");
  }

  void tellWhy() {
    switch (inGrid() ? told.cause : kCauseNone) {
      case kCauseRefused: return tellRefused();
      case kCauseGate: return tellGate();
      case kCauseFilledEarly: return tellFilledEarly();
      case kCauseSteppedOver: return tellSteppedOver();
      case kCauseAcceptedEarly: return tellAcceptedEarly();
      default: return tellOther();
    }
  }

  // "0.19 cells before the surface"; nothing where there is none.
  void tellDistance(const char* between) {
    if (surface())
      story.text(between).number(cellsText(std::abs(told.error))).text(told.error < 0.0f ? " before the surface" : " behind the surface");
    story.text(".");
  }

  void tellEnd() {
    if (input.traced.kind == kHitVoxel && !record.steps.empty()) {
      const StepRecord& last = record.steps.back();
      story.stepTitle(last.segment, last.cell).text(surface() ? " filled the gap" : " filled a gap where nothing is");
      return tellDistance(" ");
    }
    if (input.traced.kind == kHitTriangle) {
      story.text("The ray hit "), named(input.traced.reference);
      return tellDistance(", ");
    }
    story.text(input.traced.kind == kHitLimit ? "The limit of segments ended the ray." : "The ray met nothing and left the grid.");
  }
};

}  // namespace

std::vector<StoryPart> tellBriefly(const StoryInput& input) {
  StoryWriter story(input);
  if (input.told.verdict == kVerdictNoRay) return story.text("The pixel has no ray.").take();
  BriefTeller teller{.input = input, .story = story};
  if (input.told.cause == kCauseNone) {
    teller.tellAgreement();
  } else {
    teller.tellShould();
    teller.tellWhy();
    teller.tellEnd();
  }
  return story.take();
}

const char* proofWords(uint32_t cause) {
  switch (cause) {
    case kCauseRefused:
    case kCauseNotInserted:
    case kCauseLeftOut: return "With the triangle added";
    case kCauseSteppedOver: return "With one more segment in that cell";
    case kCauseRevisit: return "With that segment not skipped";
    case kCauseSegmentEnd: return "With a longer segment in that cell";
    case kCauseAcceptedEarly: return "With that hit not accepted";
    case kCauseGate: return "With that gap filled";
    case kCauseFilledEarly: return "With that gap left open";
    case kCauseSegmentLimit: return "Without the limit of segments";
    default: return "Without this event";
  }
}

}  // namespace gridscope
