// See log.h.
#include "app/ui/shell/log.h"

#include <cstring>

#include "app/base/text.h"
#include "app/model/flow.h"
#include "app/model/held_ray.h"

namespace gridscope {

namespace {

void note(WindowModel& model, std::string text) { model.say(LogLine::Kind::note, std::move(text)); }

void logScene(WindowModel& model, LoggedState& logged) {
  const FrameSnapshot& frame = *model.frame;
  if (logged.scene != frame.scene->path || logged.loads != frame.request.source.loadCount) note(model, "Loaded " + frame.scene->name);
  logged.scene = frame.scene->path;
  logged.loads = frame.request.source.loadCount;
  const GridTotals& totals = frame.totals;
  if (!totals.occupancyHistogram.empty() && (std::memcmp(&totals.statistics, &logged.totals.statistics, sizeof(GridStatistics)) != 0 ||
                                             totals.occupancyHistogram.size() != logged.totals.occupancyHistogram.size())) {
    note(model, printed("Grid: stored %s, refused %s, saturated %s", grouped(totals.stored()).c_str(), grouped(totals.refused()).c_str(),
                        grouped(totals.statistics.saturated).c_str()));
    logged.totals = totals;
  }
}

void logFrame(WindowModel& model, LoggedState& logged) {
  const FrameSnapshot& frame = *model.frame;
  if (frame.traceNumber != logged.traceNumber) {
    logged.traceNumber = frame.traceNumber;
    note(model, printed("Traced frame %u", frame.request.frame));
  }
  if (frame.truths.get() != logged.truths) {
    logged.truths = frame.truths.get();
    const TruthTotals& t = frame.truthTotals;
    if (frame.truths)
      note(model,
           printed("Truth: %s rays, %s agree, %s wrong, %s voxel right", grouped(t.rays).c_str(), grouped(t.agreeHit + t.agreeMiss).c_str(),
                   grouped(t.wrong()).c_str(), grouped(t.verdicts[kVerdictVoxelRight]).c_str()));
  }
  if (frame.proofs.get() != logged.proofs) {
    logged.proofs = frame.proofs.get();
    if (frame.proofs) {
      const ProofTotals::Count sum = frame.proofs->sum();
      note(model, printed("Proof: %s of %s causes confirmed, %s alone", grouped(sum.alone + sum.chain).c_str(), grouped(sum.total).c_str(),
                          grouped(sum.alone).c_str()));
    }
  }
}

const char* outcomeWord(const StepRecord& step) {
  switch (step.outcome) {
    case kStepOutside: return "outside the grid";
    case kStepRevisit: return "same cell as before";
    case kStepEmpty: return "empty";
    default: return step.saturated ? "read, saturated" : "read";
  }
}

void logRay(WindowModel& model, LoggedState& logged) {
  const auto& record = model.frame->record;
  const uint32_t width = model.frame->request.settings->width;
  // The same ray with its truth or its proof is no news.
  const bool another = record && (record->pixel != logged.recordedPixel || model.frame->traceNumber != logged.recordedTrace);
  if (another) {
    logged.recordedPixel = record->pixel;
    logged.recordedTrace = model.frame->traceNumber;
    logged.stepPixel.reset();
    note(model, printed("Recorded pixel %u,%u: %zu steps, %s", record->pixel % width, record->pixel / width, record->record.steps.size(),
                        record->equalsFrame ? "equals the frame's hit" : "differs from the frame's hit"));
  }
  if (!record) logged.recordedPixel.reset();
}

void logStep(WindowModel& model, LoggedState& logged) {
  const std::shared_ptr<const RecordedRay> ray = rayIsHeld(model) ? shownRay(model) : model.frame->record;
  if (!ray || ray->pixel != model.selected().pixel || model.selected().step >= ray->record.steps.size()) return;
  if (logged.stepPixel == ray->pixel && logged.step == model.selected().step) return;
  logged.stepPixel = ray->pixel;
  logged.step = model.selected().step;
  const StepRecord& step = ray->record.steps[logged.step];
  note(model, printed("Step %u of %zu: cell %d,%d,%d, %s, %zu tests", logged.step, ray->record.steps.size() - 1, step.cell.x, step.cell.y,
                      step.cell.z, outcomeWord(step), step.tests.size()));
}

void logHeld(WindowModel& model, LoggedState& logged) {
  const bool held = rayIsHeld(model);
  if (held == logged.held) return;
  logged.held = held;
  if (held) note(model, "The ray is held while the camera moves");
}

void logSelection(WindowModel& model, LoggedState& logged) {
  const std::optional<ivec3> cell = model.selected().cell;
  if (cell == logged.cell) return;
  logged.cell = cell;
  if (!cell || !model.frame->grid || !gridContains(model.frame->grid->parameters, *cell)) return;
  const CellFacts facts = cellFacts(*model.frame->grid, *cell);
  note(model, printed("Selected cell %d,%d,%d: stored %u, refused %u", cell->x, cell->y, cell->z, facts.stored,
                      facts.staticRefused + facts.dynamicRefused));
}

}  // namespace

void logChanges(WindowModel& model, LoggedState& logged) {
  std::string views;
  for (const std::string& view : shownViews(model)) views += (views.empty() ? "" : ", ") + view;
  if (views != logged.views) note(model, "View " + (logged.views = views));
  if (model.shaderFault != logged.shaderFault) {
    logged.shaderFault = model.shaderFault;
    model.say(model.shaderFault.empty() ? LogLine::Kind::note : LogLine::Kind::error,
              model.shaderFault.empty() ? "Shaders are current" : "Shaders: " + model.shaderFault);
  }
  if (!model.frame || !model.frame->scene || !model.frame->request.settings) return;
  logScene(model, logged);
  logFrame(model, logged);
  logRay(model, logged);
  logHeld(model, logged);
  logStep(model, logged);
  logSelection(model, logged);
}

}  // namespace gridscope
