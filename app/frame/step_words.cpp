// See step_words.h.
#include "app/frame/step_words.h"

#include <algorithm>
#include <array>

#include "app/base/text.h"
#include "shaders/shared/trace/triangle_test.h"
#include "shaders/shared/views/palette.h"

namespace gridscope {

StepOutcome stepOutcome(const RayRecord& record, uint32_t step) {
  const StepRecord& at = record.steps[step];
  if (at.outcome == kStepOutside) return StepOutcome::outside;
  if (at.outcome == kStepRevisit) return StepOutcome::revisit;
  if (at.outcome == kStepEmpty) return StepOutcome::empty;
  const auto isHit = [](const TestRecord& test) { return test.verdict == kTestHit; };
  if (std::any_of(at.tests.begin(), at.tests.end(), isHit)) return StepOutcome::hit;
  if (record.hit.kind == kHitVoxel && step + 1 == record.steps.size()) return StepOutcome::voxelHit;
  // A walk that already has a hit fills no gaps, nor holds any back.
  const auto hasHit = [&](const StepRecord& before) { return std::any_of(before.tests.begin(), before.tests.end(), isHit); };
  const bool foundBefore = std::any_of(record.steps.begin(), record.steps.begin() + step, hasHit);
  return at.saturated && !foundBefore ? StepOutcome::held : StepOutcome::tested;
}

const StepLook& stepLook(StepOutcome kind) {
  static constexpr std::array<StepLook, kStepOutcomeCount> kLooks{{{"outside the grid", kColourDim, StepShape::cross},
                                                                   {"revisit", kColourRevisit, StepShape::ring},
                                                                   {"empty", kColourEmpty, StepShape::dot},
                                                                   {"tested, no hit", kColourTested, StepShape::square},
                                                                   {"saturated, gate held", kColourSaturated, StepShape::hatchedSquare},
                                                                   {"triangle hit", kColourTriangleHit, StepShape::filledSquare},
                                                                   {"voxel hit", kColourVoxelHit, StepShape::diamond}}};
  return kLooks[static_cast<size_t>(kind)];
}

std::string testWord(const TestRecord& test) {
  switch (test.verdict) {
    case kTestHit: return "hit";
    case kTestParallel: return "parallel";
    case kTestOutside: return "outside";
    case kTestBefore: return test.t < 0.0f ? "behind" : "before window";
    case kTestBeyond: return "past end";
    case kTestAlpha: return printed("alpha %u", test.alphaByte);
    case kTestFarther: return "farther";
    default: return "unknown";
  }
}

uint32_t testColour(uint32_t verdict) {
  switch (verdict) {
    case kTestHit: return kColourTriangleHit;
    case kTestBefore:
    case kTestBeyond:
    case kTestFarther: return kColourTested;
    case kTestAlpha: return kColourGate;
    default: return kColourEmpty;
  }
}

std::string plainText(const Sentence& sentence) {
  std::string text;
  for (const SentencePart& part : sentence) text += part.text;
  return text;
}

std::string cellNumbers(ivec3 cell) { return printed("(%d, %d, %d)", cell.x, cell.y, cell.z); }

}  // namespace gridscope
