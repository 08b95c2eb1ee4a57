// Carries what is selected over to a frame of another numbering or another size: the same triangle under its new reference, the same place in
// the picture. What is gone is no longer selected. No ImGui here.
#pragma once

#include "app/frame/snapshot.h"
#include "app/model/selection.h"
#include "app/model/window_model.h"

namespace gridscope {

// The reference of a triangle that a person knows by that name; nothing: the scene does not hold it (any more).
std::optional<uint32_t> referenceOf(const NumberedScene& numbered, const TriangleName& name);

// Do references mean the same in both?
bool sameNumbering(const NumberedScene& a, const NumberedScene& b);

Selection carriedToNumbering(Selection selection, const NumberedScene& before, const NumberedScene& after);
Selection carriedToSize(Selection selection, uvec2 before, uvec2 after);
std::optional<PixelArea> carriedToSize(const std::optional<PixelArea>& area, uvec2 before, uvec2 after);

}  // namespace gridscope
