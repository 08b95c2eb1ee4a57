// A drawing as SVG; see drawing.h.
#include <cmath>
#include <cstdio>

#include "shaders/shared/views/palette.h"
#include "views/drawing.h"

namespace gridscope {
namespace {

struct NamedColour {
  uint32_t colour;
  const char* property;
};

constexpr NamedColour kNamed[] = {{kColourText, "--text"},
                                  {kColourDim, "--dim"},
                                  {kColourLine, "--line"},
                                  {kColourPanel, "--panel"},
                                  {kColourWindow, "--window"},
                                  {kColourTriangleHit, "--hit"},
                                  {kColourVoxelHit, "--voxel-hit"},
                                  {kColourMiss, "--miss"},
                                  {kColourSaturated, "--saturated"},
                                  {kColourTested, "--tested"},
                                  {kColourRevisit, "--revisit"},
                                  {kColourHole, "--hole"},
                                  {kColourVoxelRight, "--voxel-right"},
                                  {kColourVoxelWrong, "--voxel-wrong"},
                                  {kColourTooFar, "--too-far"},
                                  {kColourTooNear, "--too-near"}};

// Two decimals are a hundredth of a pixel; what is not finite must not reach a file.
std::string number(float value) {
  char text[48];
  std::snprintf(text, sizeof text, "%.2f", std::isfinite(value) ? double(value) : 0.0);
  return text;
}

class SvgWriter {
 public:
  explicit SvgWriter(bool themed) : themed_(themed) {}

  std::string write(const Drawing& drawing) {
    const std::string width = std::to_string(drawing.width), height = std::to_string(drawing.height);
    text_ = std::string("<svg") + (themed_ ? "" : " xmlns=\"http://www.w3.org/2000/svg\"") + " viewBox=\"0 0 " + width + " " + height +
            "\" width=\"" + width + "\" height=\"" + height + "\" role=\"img\"><title>" + markupText(drawing.title) + "</title>\n";
    if (!themed_) text_ += "<rect width=\"" + width + "\" height=\"" + height + "\"" + fill(drawing.background) + "/>\n";
    for (const DrawnShape& shape : drawing.shapes) std::visit([this](const auto& one) { add(one); }, shape);
    return std::move(text_ += "</svg>\n");
  }

 private:
  std::string paint(const char* attribute, uint32_t colour) const {
    char hex[16];
    std::snprintf(hex, sizeof hex, "#%06X", colour & 0xFFFFFFu);
    const char* property = themed_ ? colourProperty(colour) : nullptr;
    if (property) return std::string(" style=\"") + attribute + ":var(" + property + "," + hex + ")\"";
    return std::string(" ") + attribute + "=\"" + hex + "\"";
  }
  std::string fill(uint32_t colour) const { return paint("fill", colour); }

  // An element with a title inside, or none.
  void element(const std::string& start, const char* name, const std::string& title) {
    if (title.empty())
      text_ += start + "/>\n";
    else
      text_ += start + "><title>" + markupText(title) + "</title></" + name + ">\n";
  }

  void add(const DrawnBox& box) {
    element("<rect x=\"" + number(box.corner.x) + "\" y=\"" + number(box.corner.y) + "\" width=\"" + number(box.width) + "\" height=\"" +
                number(box.height) + "\"" + fill(box.colour),
            "rect", box.title);
  }

  void add(const DrawnLine& line) {
    text_ += "<polyline fill=\"none\" stroke-width=\"" + number(line.width) + "\"" + paint("stroke", line.colour);
    if (line.dashed) text_ += " stroke-dasharray=\"4 3\"";
    text_ += " points=\"";
    for (const DrawingPoint& point : line.points) text_ += number(point.x) + "," + number(point.y) + " ";
    text_ += "\"/>\n";
  }

  void add(const DrawnMark& mark) {
    const std::string x = number(mark.centre.x), y = number(mark.centre.y), r = number(mark.radius);
    const std::string opacity = mark.opacity < 1.0f ? " opacity=\"" + number(mark.opacity) + "\"" : "";
    const std::string side = number(2.0f * mark.radius);
    const std::string corner = " x=\"" + number(mark.centre.x - mark.radius) + "\" y=\"" + number(mark.centre.y - mark.radius) +
                               "\" width=\"" + side + "\" height=\"" + side + "\"";
    switch (mark.shape) {
      case MarkShape::circle:
        return element("<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"" + r + "\"" + fill(mark.colour) + opacity, "circle", mark.title);
      case MarkShape::ring:
        return element("<circle fill=\"none\" stroke-width=\"2\" cx=\"" + x + "\" cy=\"" + y + "\" r=\"" + r + "\"" +
                           paint("stroke", mark.colour) + opacity,
                       "circle", mark.title);
      case MarkShape::square: return element("<rect" + corner + fill(mark.colour) + opacity, "rect", mark.title);
      case MarkShape::diamond:
        return element("<rect" + corner + " transform=\"rotate(45 " + x + " " + y + ")\"" + fill(mark.colour) + opacity, "rect",
                       mark.title);
    }
  }

  void add(const DrawnText& text) {
    static constexpr const char* kAnchors[] = {"start", "middle", "end"};
    const char* family = text.style.font == Font::mono ? "'JetBrains Mono',ui-monospace,monospace" : "Inter,system-ui,sans-serif";
    text_ += "<text x=\"" + number(text.place.x) + "\" y=\"" + number(text.place.y) + "\" font-size=\"" + number(text.style.size) +
             "\" font-family=\"" + family + "\" text-anchor=\"" + kAnchors[int(text.anchor)] + "\"" + fill(text.style.colour) + ">" +
             markupText(text.text) + "</text>\n";
  }

  bool themed_;
  std::string text_;
};

// Bytes of the code point that `text` begins with; 0: no valid UTF-8, or one that XML does not allow.
size_t codePointBytes(std::string_view text) {
  const auto byte = [&](size_t i) { return i < text.size() ? uint8_t(text[i]) : uint8_t(0); };
  const uint8_t first = byte(0);
  if (first < 0x80) return first >= 0x20 ? first != 0x7F : first == '\t' || first == '\n' || first == '\r';
  const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  uint32_t code = first & (0xFFu >> (length + 1));
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool forbidden =
      (code >= 0xD800 && code < 0xE000) || code == 0xFFFE || code == 0xFFFF || code > 0x10FFFF || (code >= 0x80 && code < 0xA0);
  return overlong || forbidden ? 0 : length;
}

}  // namespace

const char* colourProperty(uint32_t colour) {
  for (const NamedColour& named : kNamed)
    if (named.colour == colour) return named.property;
  return nullptr;
}

std::string markupText(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const size_t bytes = codePointBytes(text);
    switch (bytes == 1 ? text.front() : ' ') {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      default: result += bytes == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(0, bytes);
    }
    text.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  return result;
}

std::string svgOf(const Drawing& drawing, bool themed) { return SvgWriter(themed).write(drawing); }

}  // namespace gridscope
