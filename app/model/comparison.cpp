// See comparison.h.
#include "app/model/comparison.h"

#include <algorithm>

#include "app/base/text.h"
#include "app/frame/changes.h"
#include "app/session/settings_table.h"
#include "views/view.h"

namespace gridscope {

namespace {

// What a view reads is there, or costs no wait.
bool isCheap(const View& view, const FrameSnapshot& frame) {
  switch (view.need) {
    case ViewNeed::nothing: return true;
    case ViewNeed::truth:
    case ViewNeed::triangleCosts: return frame.truths != nullptr;
    case ViewNeed::cellRays: return frame.cellRays != nullptr;
    case ViewNeed::stability:
    case ViewNeed::cellUpdates: return false;
  }
  return false;
}

bool sameFrame(const FrameSnapshot& a, const FrameSnapshot& b) {
  return a.request.settings && b.request.settings && !changesBetween(a.request, b.request).any() && a.traceNumber == b.traceNumber;
}

std::string timeText(const FrameSnapshot& frame) {
  if (frame.scene && frame.scene->captureFrames > 0) return printed("frame %u", frame.request.frame);
  return printed("time %.3g s", frame.request.timeSeconds);
}

}  // namespace

void keepFrame(WindowModel& model) {
  CompareState& compare = model.comparison;
  compare.kept = model.frame;
  compare.with = CompareState::With::frame;
  compare.flip = false;
  model.layout = ViewportLayout::compare;
  compare.completing = !viewsToKeep(model).empty();
}

std::set<std::string> viewsToKeep(const WindowModel& model) {
  std::set<std::string> names;
  const CompareState& compare = model.comparison;
  if (!compare.kept) return names;
  for (const View& view : allViews()) {
    const std::string name(view.name);
    if (isCheap(view, *compare.kept) && !compare.kept->views.contains(name)) names.insert(name);
  }
  return names;
}

void completeKept(WindowModel& model, const std::shared_ptr<const FrameSnapshot>& frame) {
  CompareState& compare = model.comparison;
  if (!compare.completing || !compare.kept) return;
  if (frame->stale || !frame->hits) return;
  if (!sameFrame(*compare.kept, *frame)) {
    compare.completing = false;
    return;
  }
  auto kept = std::make_shared<FrameSnapshot>(*compare.kept);
  for (const auto& [name, image] : frame->views) kept->views.try_emplace(name, image);
  compare.kept = std::move(kept);
  compare.completing = !viewsToKeep(model).empty();
}

bool comparesFrames(const WindowModel& model) {
  return model.layout == ViewportLayout::compare && model.comparison.with == CompareState::With::frame;
}

std::string frameLabel(const FrameSnapshot& frame, const FrameSnapshot& beside, size_t most) {
  if (!frame.scene || !frame.request.settings) return "";
  const bool another = !beside.scene || beside.scene->path != frame.scene->path;
  std::string label = another ? frame.scene->name : "";
  const auto add = [&](const std::string& text) { label += (label.empty() ? "" : ", ") + text; };
  if (!beside.request.settings) return label;
  if (!another && (frame.request.timeSeconds != beside.request.timeSeconds || frame.request.frame != beside.request.frame))
    add(timeText(frame));
  if (!another && frame.request.edits != beside.request.edits) add(printed("%zu instances edited", frame.request.edits.size()));
  const std::vector<SettingText> own = settingTexts(*frame.request.settings), other = settingTexts(*beside.request.settings);
  size_t differ = 0;
  for (size_t i = 0; i < own.size(); ++i) {
    if (own[i].value == other[i].value || ++differ > most) continue;
    const std::string name = own[i].option.substr(2);
    add(name == "camera" ? "another camera" : name + " " + own[i].value);
  }
  if (differ > most) add(printed("%zu more", differ - most));
  return label;
}

uint32_t pixelInSize(uvec2 pixel, uvec2 size, uvec2 other) {
  const uvec2 moved = glm::min(uvec2((vec2(pixel) + 0.5f) / vec2(size) * vec2(other)), other - 1u);
  return moved.y * other.x + moved.x;
}

}  // namespace gridscope
