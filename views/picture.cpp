// Ranges, enlargement and the legend's place; colours are element.h's and palette.h's.
#include "views/picture.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/pipeline/pipeline.h"
#include "shaders/shared/grid/slice.h"
#include "shaders/shared/views/element_colour.h"
#include "views/legend.h"

namespace gridscope {

// A layer of few cells is set into a picture wide enough for its legend, pixels.
static constexpr uint32_t kNarrowestLegend = 320;

// All finite values of the elements.
static std::vector<float> finiteValues(std::span<const ViewElement> elements) {
  std::vector<float> values;
  for (const ViewElement& element : elements) {
    if (element.kind != kElementValue && element.kind != kElementMarked) continue;
    float value = uintBitsToFloat(element.payload);
    if (std::isfinite(value)) values.push_back(value);
  }
  return values;
}

// The smallest value that 99 % of the values do not exceed.
static float percentile99(std::vector<float> values) {
  auto place = values.begin() + static_cast<ptrdiff_t>((values.size() * 99 + 99) / 100 - 1);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

ValueRange viewRange(const View& view, std::span<const ViewElement> elements, uint32_t capacity) {
  if (view.range == ViewRange::none) return {0.0f, 1.0f};
  if (view.range == ViewRange::capacity) return {0.0f, static_cast<float>(std::max(capacity, 1u))};
  std::vector<float> values = finiteValues(elements);
  if (values.empty()) return {0.0f, 1.0f};
  if (view.range == ViewRange::automatic) return {0.0f, std::max(percentile99(std::move(values)), 1.0f)};
  auto [low, high] = std::ranges::minmax(values);
  return {low, high > low ? high : low + std::max(1.0f, 1e-3f * std::abs(low))};
}

// The whole factor that brings a layer nearest to the frame's size, a quarter too large at most, and never above 4,096 pixels.
static uint32_t enlargement(uint32_t width, uint32_t height, const ViewPictureSettings& settings) {
  uint32_t factor = std::min(settings.frameWidth * 5 / 4 / width, settings.frameHeight * 5 / 4 / height);
  return std::clamp(factor, 1u, std::max(4096u / std::max(width, height), 1u));
}

static Picture colourElements(std::span<const ViewElement> elements, uint32_t width, uint32_t height, uint32_t factor, ValueRange range,
                              uint32_t map) {
  Picture picture = makePicture(width * factor, height * factor, kColourWindow);
  uint8_t* out = picture.rgba.data();
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x, out += 4) {
      const ViewElement& element = elements[size_t{y / factor} * width + x / factor];
      uint32_t bytes = packBytes(elementColour(element, range[0], range[1], map, uvec2(x, y)));
      for (int channel = 0; channel < 3; ++channel) out[channel] = static_cast<uint8_t>(bytes >> (8 * channel));
    }
  return picture;
}

// A picture in the middle of a wider one.
static Picture centred(const Picture& picture, uint32_t width) {
  if (picture.width >= width) return picture;
  Picture wide = makePicture(width, picture.height, kColourWindow);
  size_t left = (width - picture.width) / 2;
  for (size_t row = 0; row < picture.height; ++row)
    std::copy_n(&picture.rgba[4 * row * picture.width], size_t{4} * picture.width, &wide.rgba[4 * (row * width + left)]);
  return wide;
}

static std::string sliceNote(const ViewPictureSettings& settings) {
  const char axes[] = "xyz";
  std::string note = std::string("layer ") + axes[settings.sliceAxis] + " " + std::to_string(settings.sliceIndex);
  if (settings.sliceCount > 0) note += " of " + std::to_string(settings.sliceCount);
  note += std::string(" \u00b7 ") + axes[sliceColumnAxis(settings.sliceAxis)] + " to the right, " + axes[sliceRowAxis(settings.sliceAxis)];
  return note + (settings.sliceAxis == 1 ? " down" : " up");
}

ViewPicture makeViewPicture(const View& view, std::span<const ViewElement> elements, uint32_t width, uint32_t height,
                            const ViewPictureSettings& settings) {
  CHECK_EQ(elements.size(), size_t{width} * height);
  CHECK_LT(0u, elements.size());
  bool isSlice = view.scope == ViewScope::slice;

  ViewPicture result;
  result.range = settings.range ? *settings.range : viewRange(view, elements, settings.capacity);
  uint32_t factor = isSlice ? enlargement(width, height, settings) : 1;
  result.picture = colourElements(elements, width, height, factor, result.range, settings.colourMap);
  result.beyond = std::ranges::any_of(finiteValues(elements), [&](float value) { return value > result.range[1]; });
  if (isSlice) result.note = sliceNote(settings);
  if (!settings.legend) return result;

  Legend legend{.view = &view,
                .range = result.range,
                .beyond = result.beyond,
                .colourMap = settings.colourMap,
                .note = result.note,
                .lines = settings.lines};
  if (isSlice) result.picture = centred(result.picture, kNarrowestLegend);
  result.picture = setBelow(result.picture, drawLegend(legend, result.picture.width));
  return result;
}

Picture plainView(Pipeline& pipeline, const char* name) {
  const View& view = *findView(name);
  const Pipeline::ViewImage image = pipeline.view(name, {}, view.needsGrid);
  const FrameSettings& settings = pipeline.settings();
  return makeViewPicture(view, image.elements, image.width, image.height,
                         {.legend = false,
                          .capacity = uint32_t(pipeline.parameters().grid.capacity),
                          .frameWidth = settings.width,
                          .frameHeight = settings.height})
      .picture;
}

}  // namespace gridscope
