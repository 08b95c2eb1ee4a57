// A view's elements as the bytes of a picture, quickly: what the window shows. The same colours as views/picture.h makes. No ImGui here.
#pragma once

#include <cstdint>
#include <vector>

#include "core/pipeline/pipeline.h"
#include "views/picture.h"

namespace gridscope {

// RGBA, first row at the top. Values from range[0] to range[1] over the map.
std::vector<uint8_t> paintView(const Pipeline::ViewImage& image, ValueRange range, uint32_t colourMap);

// One element in words for a person: "17 cells", "-", with a grouping comma. `unit`: of the view.
std::string elementText(const ViewElement& element, std::string_view unit);

}  // namespace gridscope
