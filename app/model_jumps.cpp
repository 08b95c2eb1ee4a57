// The ways to the next step, ray and cell (model_flow.h).
#include <algorithm>

#include "app/model_flow.h"
#include "app/text.h"

namespace gridscope {

uint32_t stepCount(const WindowModel& model) {
  return model.frame && model.frame->record ? uint32_t(model.frame->record->record.steps.size()) : 0;
}

void goToStep(WindowModel& model, int64_t step) {
  const int64_t count = stepCount(model);
  if (count > 0) model.selection.selectStep(uint32_t(std::clamp<int64_t>(step, 0, count - 1)));
}

static bool isKind(const RecordedRay& record, uint32_t index, StepKind kind) {
  const StepRecord& step = record.record.steps[index];
  switch (kind) {
    case StepKind::nonEmpty: return step.outcome == kStepRead;
    case StepKind::tested: return !step.tests.empty();
    case StepKind::saturated: return step.saturated;
    case StepKind::revisit: return step.outcome == kStepRevisit;
    case StepKind::voxelHit: return record.record.hit.kind == kHitVoxel && index + 1 == record.record.steps.size();
  }
  return false;
}

std::optional<uint32_t> nextStep(const RecordedRay& record, uint32_t from, StepKind kind) {
  for (uint32_t index = from + 1; index < record.record.steps.size(); ++index)
    if (isKind(record, index, kind)) return index;
  return std::nullopt;
}

bool goToNextStep(WindowModel& model, StepKind kind) {
  if (stepCount(model) == 0) return false;
  const std::optional<uint32_t> next = nextStep(*model.frame->record, model.selected().step, kind);
  if (next) model.selection.selectStep(*next);
  return next.has_value();
}

void goToRay(WindowModel& model, int direction) {
  if (!model.frame || !model.frame->rays) return;
  const int64_t now = model.selected().pixel ? int64_t(*model.selected().pixel) : -1;
  if (!model.rayOrder.pixels.empty()) {
    const auto& order = model.rayOrder.pixels;
    const auto found = std::ranges::find(order, uint32_t(now));
    const int64_t place = found == order.end() ? (direction > 0 ? -1 : 0) : found - order.begin();
    const int64_t count = int64_t(order.size());
    model.selection.selectPixel(order[size_t((place + direction + count) % count)]);
    return;
  }
  const auto& rays = *model.frame->rays;
  const int64_t count = int64_t(rays.size());
  int64_t pixel = now;
  for (int64_t tried = 0; tried < count; ++tried) {
    pixel = (pixel + direction + count) % count;
    if (rays[size_t(pixel)].valid) return model.selection.selectPixel(uint32_t(pixel));
  }
}

void jumpTo(WindowModel& model, Jump jump) {
  if (!model.frame) return;
  model.request.truth = true;
  model.truthDeclined = false;
  if (!model.frame->truths) {
    model.pendingJump = jump;
    return model.showMessage("The truth of this frame is being told first");
  }
  const uint32_t wanted = jump == Jump::nextHole ? kVerdictHole : kVerdictVoxelWrong;
  const auto& truths = *model.frame->truths;
  const size_t begin = model.selected().pixel ? *model.selected().pixel + 1 : 0;
  for (size_t i = 0; i < truths.size(); ++i) {
    const size_t pixel = (begin + i) % truths.size();
    if (truths[pixel].verdict == wanted) return model.selection.selectPixel(uint32_t(pixel));
  }
  model.showMessage(std::string("No ray of this frame is a ") + (jump == Jump::nextHole ? "hole" : "wrong voxel hit"));
}

namespace {

struct FullCell {
  uint32_t wanted;
  uint64_t index;     // x fastest
};

// Saturated cells, those that want the most first.
std::vector<FullCell> saturatedCells(const Grid& grid) {
  const GridParameters& g = grid.parameters;
  std::vector<FullCell> cells;
  uint64_t index = 0;
  for (int z = 0; z < g.cellCount.z; ++z)
    for (int y = 0; y < g.cellCount.y; ++y)
      for (int x = 0; x < g.cellCount.x; ++x, ++index) {
        uint32_t refused = 0;
        for (int k = 0; k < g.reserved; ++k) refused += grid.at(gridTexel(g, ivec3(x, y, z), g.capacity + k));
        if (g.reserved == 0) refused = grid.at(gridTexel(g, ivec3(x, y, z), g.capacity - 1)) != kBlank;
        if (refused > 0) cells.push_back({uint32_t(g.capacity) + refused, index});
      }
  std::ranges::sort(cells, [](const FullCell& a, const FullCell& b) { return a.wanted != b.wanted ? a.wanted > b.wanted : a.index < b.index; });
  return cells;
}

ivec3 cellOfIndex(const GridParameters& grid, uint64_t index) {
  const uint64_t row = uint64_t(grid.cellCount.x), layer = row * uint64_t(grid.cellCount.y);
  return {int(index % row), int(index % layer / row), int(index / layer)};
}

}  // namespace

void goToNextSaturatedCell(WindowModel& model) {
  if (!model.frame || !model.frame->grid) return;
  const Grid& grid = *model.frame->grid;
  const std::vector<FullCell> cells = saturatedCells(grid);
  if (cells.empty()) return model.showMessage("No cell of this grid is saturated");
  size_t next = 0;
  if (const std::optional<ivec3> now = model.selected().cell)
    for (size_t i = 0; i < cells.size(); ++i)
      if (cellOfIndex(grid.parameters, cells[i].index) == *now) next = (i + 1) % cells.size();
  model.selection.selectCell(cellOfIndex(grid.parameters, cells[next].index));
}

}  // namespace gridscope
