// How the window looks: fonts, the colours of the dark and the light theme, ImGui's sizes.
#pragma once

#include "app/ui/widgets/widgets.h"

namespace gridscope {

// Fills ImGui's font atlas at a UI scale; the backend must make its font texture anew after.
void loadWindowFonts(float uiScale);

// Sets ImGui's colours and sizes.
void applyTheme(Theme theme, float uiScale);

}  // namespace gridscope
