// What is selected: pixel, step of its ray, cell, slot, triangle, instance. Panels change it through these functions alone, so that
// everything that shows a selection follows, and back and forward go through what was selected before. No ImGui here.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/trace/trace.h"

namespace gridscope {

// What the inspector shows: what was selected last.
enum class Selected { nothing, pixel, step, cell, triangle, instance };

struct Selection {
  Selected last = Selected::nothing;
  std::optional<uint32_t> pixel;  // of the frame; its ray is recorded
  uint32_t step = 0;              // of the recorded ray
  std::optional<ivec3> cell;
  std::optional<uint32_t> slot;       // of that cell
  std::optional<uint32_t> reference;  // triangle
  std::optional<uint32_t> instance;   // of the scene
  bool operator==(const Selection&) const = default;
};

class SelectionHistory {
 public:
  const Selection& now() const { return entries_[at_]; }

  void selectPixel(uint32_t pixel);  // step 0 of its ray
  void selectStep(uint32_t step);    // steps of one ray make one entry of the history
  void selectCell(ivec3 cell, std::optional<uint32_t> slot = {});
  void selectTriangle(uint32_t reference);
  void selectInstance(uint32_t sceneInstance);
  void clear();
  void change(const std::function<Selection(const Selection&)>& carry);  // all that was selected, where what it names has other numbers now

  bool canGoBack() const { return at_ > 0; }
  bool canGoForward() const { return at_ + 1 < entries_.size(); }
  void goBack() { at_ -= canGoBack() ? 1 : 0; }
  void goForward() { at_ += canGoForward() ? 1 : 0; }

 private:
  void enter(const Selection& selection);

  std::vector<Selection> entries_{1};
  size_t at_ = 0;
};

}  // namespace gridscope
