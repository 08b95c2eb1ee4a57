// From a view's elements to a picture with its legend.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/image_file.h"
#include "shaders/shared/base/view_element.h"
#include "views/view.h"

namespace gridscope {

class Pipeline;

using ValueRange = std::array<float, 2>;  // low, high; low < high

struct ViewPictureSettings {
  std::optional<ValueRange> range;  // replaces the view's own
  uint32_t colourMap = kColourMapViridis;
  bool legend = true;
  uint32_t capacity = 0;           // of the grid, for ViewRange::capacity
  std::vector<std::string> lines;  // of the legend: scene and settings, what is refused first

  // For views of a layer of cells.
  uint32_t frameWidth = 0;  // pixels of the frame; the layer is drawn about as large
  uint32_t frameHeight = 0;
  int sliceAxis = 1;  // 0 x, 1 y, 2 z
  int sliceIndex = 0;
  int sliceCount = 0;  // layers along that axis
};

struct ViewPicture {
  Picture picture;
  ValueRange range;     // that was used
  bool beyond = false;  // some values are above it
  std::string note;     // of a layer of cells, which one and which way it lies
};

// The view's own range for these elements: always finite, low < high.
ValueRange viewRange(const View& view, std::span<const ViewElement> elements, uint32_t capacity);

// `elements`: width x height of them, row by row, first row at the top.
ViewPicture makeViewPicture(const View& view, std::span<const ViewElement> elements, uint32_t width, uint32_t height,
                            const ViewPictureSettings& settings);

// A view of the pipeline's present products, without legend.
Picture plainView(Pipeline& pipeline, const char* name);

}  // namespace gridscope
