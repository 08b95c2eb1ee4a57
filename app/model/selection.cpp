// See selection.h.
#include "app/model/selection.h"

namespace gridscope {

// Entries that can be gone back to.
static constexpr size_t kMostEntries = 200;

void SelectionHistory::enter(const Selection& selection) {
  if (selection == now()) return;
  const bool sameRay = selection.last == Selected::step && now().last == Selected::step && selection.pixel == now().pixel;
  entries_.resize(at_ + 1);
  if (sameRay) {
    entries_[at_] = selection;
    return;
  }
  entries_.push_back(selection);
  if (entries_.size() > kMostEntries) entries_.erase(entries_.begin());
  at_ = entries_.size() - 1;
}

void SelectionHistory::selectPixel(uint32_t pixel) {
  Selection next = now();
  next.last = Selected::pixel;
  if (next.pixel != pixel) next.step = 0;
  next.pixel = pixel;
  enter(next);
}

void SelectionHistory::selectStep(uint32_t step) {
  if (!now().pixel) return;
  Selection next = now();
  next.last = Selected::step;
  next.step = step;
  enter(next);
}

void SelectionHistory::selectCell(ivec3 cell, std::optional<uint32_t> slot) {
  Selection next = now();
  next.last = Selected::cell;
  next.cell = cell;
  next.slot = slot;
  enter(next);
}

void SelectionHistory::selectTriangle(uint32_t reference) {
  Selection next = now();
  next.last = Selected::triangle;
  next.reference = reference;
  enter(next);
}

void SelectionHistory::selectInstance(uint32_t sceneInstance) {
  Selection next = now();
  next.last = Selected::instance;
  next.instance = sceneInstance;
  enter(next);
}

void SelectionHistory::clear() { enter(Selection{}); }

void SelectionHistory::change(const std::function<Selection(const Selection&)>& carry) {
  for (Selection& entry : entries_) entry = carry(entry);
}

}  // namespace gridscope
