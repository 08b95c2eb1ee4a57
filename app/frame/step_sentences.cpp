// The sentences of step_facts.h: why a cell was or was not read, why the ray went on or stopped, and the whole step with links.
#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/frame/step_facts.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

namespace {

using Link = SentencePart::Link;

SentencePart words(std::string text) { return {.text = std::move(text)}; }
SentencePart cellLink(ivec3 cell) { return {.text = cellNumbers(cell), .link = Link::cell, .cell = cell}; }

std::string counted(uint64_t count, const char* one, const char* many) { return grouped(count) + " " + (count == 1 ? one : many); }

bool isLast(const RecordedRay& ray, const StepFacts& facts) { return facts.index + 1 == ray.record.steps.size(); }

// "triangle 9,467 of curtain_green", with links.
void addTriangle(Sentence& sentence, const FrameSnapshot& frame, uint32_t reference) {
  const TriangleName name = nameTriangle(frame.scene->numbered, reference);
  sentence.push_back(words("triangle "));
  sentence.push_back({.text = grouped(name.triangle), .link = Link::triangle, .number = reference});
  sentence.push_back(words(" of "));
  sentence.push_back({.text = meshName(*frame.scene, name.mesh), .link = Link::instance, .number = name.sceneInstance});
}

// Why the gap was not filled.
std::string heldWords(const FrameSnapshot& frame, const StepFacts& facts) {
  if (frame.parameters.trace.gapFill == 0) return "gap-filling is switched off";
  return printed("gap-filling opens at %.2f cells from the launch plane, this is %.2f", facts.gate, facts.travel);
}

std::string endWords(const RecordedRay& ray) {
  switch (ray.record.hit.kind) {
    case kHitMiss: return "The ray left the grid without a hit.";
    case kHitLimit: return "The ray had taken the most segments allowed: it ends as a miss.";
    case kHitTriangle: return printed("The nearest hit, at t %.4g, lies before what is left of the ray: it ends there.", ray.record.hit.t);
    default: return "The ray ends here.";
  }
}

// Where the true surface lies beside the end of the ray; empty when it is not known.
std::string exactWords(const FrameSnapshot& frame, const RecordedRay& ray) {
  if (!ray.exact) return "";
  if (ray.exact->kind != kHitTriangle) return " In truth there is no surface.";
  const float cells = (ray.exact->t - ray.record.hit.t) / frame.parameters.grid.cellEdge;
  if (std::abs(cells) <= kAgreement) return " The true surface is the same.";
  return printed(" The true surface lies %.2f cells %s.", std::abs(cells), cells > 0.0f ? "behind" : "before");
}

void explainSaturated(Sentence& sentence, const FrameSnapshot& frame, const StepFacts& facts) {
  sentence.push_back(words(" is saturated"));
  if (gridAbilities(frame.parameters.grid).countsRefusals)
    sentence.push_back(words(printed(": %s tried, %s stored", counted(facts.stored + facts.refused, "reference", "references").c_str(),
                                     grouped(facts.stored).c_str())));
  const auto wouldHit =
      std::find_if(facts.refusedTests.begin(), facts.refusedTests.end(), [](const RefusedFacts& refused) { return refused.wouldHit; });
  if (wouldHit != facts.refusedTests.end()) {
    sentence.push_back(words("; "));
    addTriangle(sentence, frame, wouldHit->test.reference);
    sentence.push_back({.text = " was refused", .colour = kColourSaturated});
    sentence.push_back(words(" and would be hit"));
  } else if (facts.refusedKnown) {
    sentence.push_back(words("; none of those refused would be hit here"));
  }
}

}  // namespace

std::string meshName(const SceneFacts& scene, uint32_t mesh) {
  return mesh < scene.names.meshes.size() && !scene.names.meshes[mesh].empty() ? scene.names.meshes[mesh] : printed("mesh %u", mesh);
}

std::string instanceName(const SceneFacts& scene, uint32_t sceneInstance) {
  return sceneInstance < scene.names.instances.size() && !scene.names.instances[sceneInstance].empty()
             ? scene.names.instances[sceneInstance]
             : printed("instance %u", sceneInstance);
}

std::string hitWords(const Hit& hit) {
  switch (hit.kind) {
    case kHitNoRay: return "no ray";
    case kHitTriangle: return printed("triangle hit at t %.6g", hit.t);
    case kHitVoxel: return printed("voxel hit at t %.6g", hit.t);
    case kHitLimit: return "miss, at the most segments";
    default: return "miss";
  }
}

std::string whyRead(const RecordedRay& ray, const StepFacts& facts) {
  switch (facts.kind) {
    case StepOutcome::outside:
      return isLast(ray, facts) ? "Not read: it starts outside the grid." : "Not read: it starts before the ray enters the grid.";
    case StepOutcome::revisit: return "Not read: the same cell as the one visited last.";
    case StepOutcome::empty: return "Read once: its first slot is blank, there is nothing to test.";
    default:
      return printed("Read: its first slot is in use, %s.", facts.tests.size() == 1
                                                                ? "one reference was tested"
                                                                : printed("all %zu references were tested", facts.tests.size()).c_str());
  }
}

std::string whyWent(const FrameSnapshot& frame, const RecordedRay& ray, const StepFacts& facts) {
  const bool last = isLast(ray, facts);
  switch (facts.kind) {
    case StepOutcome::hit:
      return last ? printed("Stopped: the nearest hit of the cell, at t %.4g, is the ray's.", facts.best->t)
                  : "Went on: the hit lies behind this cell, a nearer one may follow.";
    case StepOutcome::voxelHit:
      return printed("Stopped: no triangle hit in a saturated cell and the gate is open, so the gap is filled at t %.4g.",
                     ray.record.hit.t);
    case StepOutcome::held:
      return (last ? "Stopped: " + endWords(ray) + " Before that, " : "Went on without a hit: ") + heldWords(frame, facts) + ".";
    default: break;
  }
  if (last) return "Stopped: " + endWords(ray);
  return facts.kind == StepOutcome::tested ? "Went on: no triangle was hit, and nothing was filled." : "Went on: nothing to hit here.";
}

Sentence explainStep(const FrameSnapshot& frame, const RecordedRay& ray, const StepFacts& facts) {
  const StepLook& look = stepLook(facts.kind);
  Sentence sentence{{.text = std::string(look.word) + ": ", .colour = look.colour}};
  sentence.front().text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front().text[0])));
  if (facts.kind == StepOutcome::outside) {
    sentence.push_back(words(isLast(ray, facts) ? endWords(ray) : "this segment starts before the ray enters the grid; nothing is read."));
    return sentence;
  }

  // The cell, and what became of it.
  sentence.push_back(words("cell "));
  sentence.push_back(cellLink(facts.cell));
  switch (facts.kind) {
    case StepOutcome::revisit: sentence.push_back(words(" is the one visited last, so it is not read again.")); break;
    case StepOutcome::empty: sentence.push_back(words("'s first slot is blank: one read, and the ray goes on.")); break;
    case StepOutcome::tested:
      sentence.push_back(
          words(printed(" holds %s; the ray hits none within t %.4g to %.4g", counted(facts.stored, "reference", "references").c_str(),
                        facts.window.x, std::min(facts.window.y, 1e9f))));
      sentence.push_back(words(facts.saturated ? ", and a hit is known already." : ", and the cell refused nothing."));
      break;
    case StepOutcome::held:
      explainSaturated(sentence, frame, facts);
      sentence.push_back(words(". Not filled: " + heldWords(frame, facts) + "."));
      break;
    case StepOutcome::hit:
      sentence.push_back(words(" holds "));
      addTriangle(sentence, frame, facts.best->reference);
      sentence.push_back(words(printed(", hit at t %.4g.", facts.best->t)));
      break;
    default: explainSaturated(sentence, frame, facts); sentence.push_back(words("."));
  }
  if (isLast(ray, facts)) {
    const bool ends = facts.kind == StepOutcome::hit || facts.kind == StepOutcome::voxelHit;
    sentence.push_back(
        words(ends ? exactWords(frame, ray) : " " + endWords(ray) + (ray.record.hit.kind == kHitTriangle ? exactWords(frame, ray) : "")));
  }
  return sentence;
}

}  // namespace gridscope
