// Panels that are drawn elsewhere.
#include "app/window_panels.h"

namespace gridscope {

void drawTuner(WindowModel&) {}

}  // namespace gridscope
