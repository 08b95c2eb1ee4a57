// The strip below a view's picture that says how to read it: title, colour bar with ticks and unit, what hatch and swatches mean, and
// the lines that the caller adds.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/image_file.h"
#include "views/view.h"

namespace gridscope {

// How a meaning is drawn beside its word, so that colour never stands alone.
enum class Swatch { square, diamond, ring, dot, hatch, line };

// A colour with a fixed meaning. View::marks names meanings, separated by ", ".
struct Meaning {
  std::string_view name;   // as in View::marks
  std::string_view words;  // as a legend says it
  uint32_t colour;         // 0xRRGGBB
  Swatch swatch;
};

// nullptr when there is none of that name.
const Meaning* findMeaning(std::string_view name);

// The meanings that a view's marks name; a name without a meaning is our own mistake.
std::vector<Meaning> viewMeanings(const View& view);

struct Legend {
  const View* view = nullptr;
  std::array<float, 2> range{0.0f, 1.0f};  // low and high end of the colour bar
  bool beyond = false;                     // some values are above the range: the high end gets a "+"
  uint32_t colourMap = 0;                  // kColourMap...
  std::string note;                        // behind the title, "layer y 12 of 54" say; may be empty
  std::vector<std::string> lines;          // what the caller adds: scene and settings, what is refused first
};

// The strip alone, `width` pixels wide and as high as its content needs.
Picture drawLegend(const Legend& legend, uint32_t width);

// The strip set below a picture of the same width.
Picture setBelow(const Picture& picture, const Picture& strip);

// Values for ticks between two ends, both included, whole steps of 1, 2 or 5 times a power of ten in between; at most `most`.
std::vector<float> tickValues(float low, float high, int most);

// A number as a legend prints it: thousands with commas, decimals only where a step of `step` needs them.
std::string tickText(float value, float step);

}  // namespace gridscope
