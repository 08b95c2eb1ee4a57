// Which values on show are of a request before, because their stages run again. No ImGui here.
#pragma once

#include "app/window_model.h"

namespace gridscope {

struct StaleValues {
  bool grid = false;                   // cells, references, totals
  bool rays = false;                   // hits, verdicts
  bool steps = false;                  // of the selected ray; one that is held is never stale
};

StaleValues staleValues(const WindowModel& model);

}  // namespace gridscope
