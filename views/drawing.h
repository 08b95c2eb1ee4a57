// A drawing as a value: a list of shapes, and two ways to show it: as SVG and as a picture, from the same numbers.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/image_file.h"
#include "views/fonts.h"

namespace gridscope {

// In pixels; x to the right, y downwards, (0, 0) is the drawing's upper left corner.
struct DrawingPoint {
  float x = 0.0f;
  float y = 0.0f;
};

enum class MarkShape { circle, square, ring, diamond };
enum class TextAnchor { start, middle, end };  // which part of the text stands at its place

struct DrawnLine {
  std::vector<DrawingPoint> points;  // one after the other; two or more
  uint32_t colour = 0;               // 0xRRGGBB; likewise below
  float width = 1.0f;
  bool dashed = false;
};

struct DrawnBox {
  DrawingPoint corner;  // upper left
  float width = 0.0f;
  float height = 0.0f;
  uint32_t colour = 0;
  std::string title;  // said when the mouse rests on it (SVG); may be empty
};

struct DrawnMark {
  MarkShape shape = MarkShape::circle;
  DrawingPoint centre;
  float radius = 4.0f;
  uint32_t colour = 0;
  float opacity = 1.0f;
  std::string title;  // as DrawnBox::title
};

struct DrawnText {
  std::string text;    // UTF-8
  DrawingPoint place;  // on the baseline
  TextStyle style;
  TextAnchor anchor = TextAnchor::start;
};

using DrawnShape = std::variant<DrawnBox, DrawnLine, DrawnMark, DrawnText>;

struct Drawing {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t background = 0;
  std::string title;               // what it shows, in a sentence: for those who can't see it
  std::vector<DrawnShape> shapes;  // later ones over earlier ones
};

// Adds all shapes of `part`, moved by `at`.
void place(Drawing& drawing, const Drawing& part, DrawingPoint at);

// A whole SVG element. `themed`: for a page that sets --text, --dim, --line, --panel and the meanings' colours as custom properties: a
// colour of the palette then names its property, so that the drawing follows the page's theme; other
// colours stay as they are, and what is behind it is the page.
std::string svgOf(const Drawing& drawing, bool themed = false);

// The same as pixels, `scale` of them to one of the drawing's.
Picture pictureOf(const Drawing& drawing, float scale = 1.0f);

// The custom property of a palette's colour, "--hole" say; nullptr when it has none.
const char* colourProperty(uint32_t colour);

// Text for XML and HTML, in elements and in attributes: & < > " ' become entities, what is no UTF-8 and control characters become U+FFFD.
std::string markupText(std::string_view text);

}  // namespace gridscope
