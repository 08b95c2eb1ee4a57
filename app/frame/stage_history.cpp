// See stage_history.h.
#include "app/frame/stage_history.h"

#include <vector>

#include "app/frame/plot_scale.h"

namespace gridscope {

namespace {

struct Changes {
  std::vector<std::string> list;

  void number(const char* name, double before, double after) {
    if (before != after) list.push_back(std::string(name) + " " + plotNumber(before) + " \u2192 " + plotNumber(after));
  }
  void choice(bool differs, const std::string& text) {
    if (differs) list.push_back(text);
  }
};

}  // namespace

std::string settingsChange(const FrameSettings& before, const FrameSettings& after) {
  Changes changes;
  changes.number("capacity", before.grid.capacity, after.grid.capacity);
  changes.number("cells", before.grid.cells, after.grid.cells);
  changes.number("cell edge", before.grid.cellEdge, after.grid.cellEdge);
  changes.number("enlargement", before.grid.enlargement, after.grid.enlargement);
  changes.choice(before.grid.overlap != after.grid.overlap, after.grid.overlap == kOverlapExact ? "overlap exact" : "overlap plane");
  changes.choice(before.grid.insertion != after.grid.insertion, after.grid.insertion == kInsertionSorted ? "sorted" : "first come");
  changes.choice(before.grid.builder != after.grid.builder, after.grid.builder == Builder::compute ? "builder compute" : "builder raster");
  changes.choice(before.grid.numberBy != after.grid.numberBy,
                 after.grid.numberBy == NumberBy::area ? "numbered by area" : "numbered by file");
  changes.choice(before.grid.update != after.grid.update, after.grid.update == UpdateMode::all ? "update all" : "update moved");
  changes.choice(before.trace.traversal != after.trace.traversal, after.trace.traversal == kTraversalDda ? "dda" : "segments");
  changes.number("ahead", before.trace.ahead, after.trace.ahead);
  changes.number("back", before.trace.back, after.trace.back);
  changes.number("gate", before.trace.gate, after.trace.gate);
  changes.choice(before.trace.gapFill != after.trace.gapFill, after.trace.gapFill ? "gaps filled" : "gaps left");
  changes.number("width", before.width, after.width);
  changes.number("roughness", before.bounce.roughness, after.bounce.roughness);
  if (changes.list.empty()) return {};
  return changes.list.front() + (changes.list.size() > 1 ? " and more" : "");
}

void StageHistory::note(const FrameSnapshot& frame) {
  if (frame.traceNumber == traceNumber_ || frame.stale || !frame.request.settings) return;
  traceNumber_ = frame.traceNumber;
  StageMoment moment{.times = frame.times};
  if (settings_) moment.change = settingsChange(*settings_, *frame.request.settings);
  settings_ = frame.request.settings;
  moments_.push_back(std::move(moment));
  if (moments_.size() > kMost) moments_.pop_front();
}

}  // namespace gridscope
