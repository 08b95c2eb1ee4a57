// See step_search.h.
#include "app/frame/step_search.h"

namespace gridscope {

namespace {

// Does the cell of a step hold references? A revisited one was looked into by the last step that was not a revisit.
bool cellHoldsReferences(const RayRecord& record, uint32_t step) {
  for (uint32_t i = step + 1; i-- > 0;)
    if (record.steps[i].outcome != kStepRevisit)
      return record.steps[i].outcome == kStepRead && record.steps[i].cell == record.steps[step].cell;
  return false;
}

bool isFound(const RayRecord& record, uint32_t step, StepSearch search) {
  const StepRecord& at = record.steps[step];
  switch (search) {
    case StepSearch::nonEmpty: return cellHoldsReferences(record, step);
    case StepSearch::tested: return !at.tests.empty();
    case StepSearch::saturated: return at.saturated;
    case StepSearch::revisit: return at.outcome == kStepRevisit;
    case StepSearch::voxelHit: return record.hit.kind == kHitVoxel && step + 1 == record.steps.size();
  }
  return false;
}

}  // namespace

std::optional<uint32_t> nextStep(const RayRecord& record, uint32_t from, StepSearch search, int direction) {
  const int64_t count = static_cast<int64_t>(record.steps.size());
  for (int64_t step = int64_t(from) + direction; step >= 0 && step < count; step += direction)
    if (isFound(record, static_cast<uint32_t>(step), search)) return static_cast<uint32_t>(step);
  return std::nullopt;
}

const char* noSuchStep(StepSearch search, int direction) {
  const bool later = direction > 0;
  switch (search) {
    case StepSearch::nonEmpty:
      return later ? "No later step starts in a cell that holds references" : "No earlier step starts in a cell that holds references";
    case StepSearch::tested: return later ? "No later step tests a triangle" : "No earlier step tests a triangle";
    case StepSearch::saturated: return later ? "No later step reads a saturated cell" : "No earlier step reads a saturated cell";
    case StepSearch::revisit:
      return later ? "No later step starts in the cell visited last" : "No earlier step starts in the cell visited last";
    case StepSearch::voxelHit: return "The ray does not end behind here with a voxel hit";
  }
  return "";
}

}  // namespace gridscope
