// A drawing as pixels; see drawing.h. Every shape is a distance to its outline, which gives each pixel its share of the colour.
#include "views/drawing.h"

#include <algorithm>
#include <cmath>

namespace gridscope {
namespace {

class Painter {
 public:
  Painter(const Drawing& drawing, float scale)
      : scale_(scale),
        picture_(makePicture(std::max(1u, uint32_t(std::lround(float(drawing.width) * scale))),
                             std::max(1u, uint32_t(std::lround(float(drawing.height) * scale))), drawing.background)) {}

  Picture paint(const Drawing& drawing) {
    for (const DrawnShape& shape : drawing.shapes) std::visit([this](const auto& one) { add(one); }, shape);
    return std::move(picture_);
  }

 private:
  void blend(int x, int y, uint32_t colour, float share) {
    uint8_t* pixel = &picture_.rgba[(size_t(y) * picture_.width + size_t(x)) * 4];
    for (int channel = 0; channel < 3; ++channel) {
      const float value = float((colour >> (16 - 8 * channel)) & 255u);
      pixel[channel] = uint8_t(std::lround(float(pixel[channel]) + (value - float(pixel[channel])) * share));
    }
  }

  // Blends every pixel between two corners with the share that `coverage` gives its centre.
  template <class Coverage>
  void cover(DrawingPoint low, DrawingPoint high, uint32_t colour, Coverage coverage) {
    const auto inside = [](float value, uint32_t size) { return int(std::clamp(value, 0.0f, float(size))); };
    const int endX = inside(std::ceil(high.x), picture_.width), endY = inside(std::ceil(high.y), picture_.height);
    for (int y = inside(std::floor(low.y), picture_.height); y < endY; ++y)
      for (int x = inside(std::floor(low.x), picture_.width); x < endX; ++x) {
        const float share = coverage(float(x) + 0.5f, float(y) + 0.5f);
        if (share > 0.0f) blend(x, y, colour, std::min(share, 1.0f));
      }
  }

  void add(const DrawnBox& box) {
    const DrawingPoint low{box.corner.x * scale_, box.corner.y * scale_};
    const DrawingPoint high{low.x + box.width * scale_, low.y + box.height * scale_};
    cover(low, high, box.colour, [&](float x, float y) {
      const float across = std::min(x + 0.5f, high.x) - std::max(x - 0.5f, low.x);
      const float along = std::min(y + 0.5f, high.y) - std::max(y - 0.5f, low.y);
      return std::max(across, 0.0f) * std::max(along, 0.0f);
    });
  }

  void segment(DrawingPoint a, DrawingPoint b, const DrawnLine& line, float from) {
    const float half = 0.5f * line.width * scale_;
    const float dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    const DrawingPoint low{std::min(a.x, b.x) - half - 1.0f, std::min(a.y, b.y) - half - 1.0f};
    const DrawingPoint high{std::max(a.x, b.x) + half + 1.0f, std::max(a.y, b.y) + half + 1.0f};
    cover(low, high, line.colour, [&](float x, float y) {
      const float along = length > 0.0f ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length, 0.0f, length) : 0.0f;
      if (line.dashed && std::fmod((from + along) / scale_, 7.0f) > 4.0f) return 0.0f;
      const float nearestX = length > 0.0f ? a.x + dx * along / length : a.x, nearestY = length > 0.0f ? a.y + dy * along / length : a.y;
      return std::min(half + 0.5f - std::hypot(x - nearestX, y - nearestY), 2.0f * half);
    });
  }

  void add(const DrawnLine& line) {
    float from = 0.0f;
    for (size_t i = 1; i < line.points.size(); ++i) {
      const DrawingPoint a{line.points[i - 1].x * scale_, line.points[i - 1].y * scale_},
          b{line.points[i].x * scale_, line.points[i].y * scale_};
      segment(a, b, line, from);
      from += std::hypot(b.x - a.x, b.y - a.y);
    }
  }

  // How far outside of its outline a point lies, in pixels.
  static float outside(MarkShape shape, float dx, float dy, float radius) {
    switch (shape) {
      case MarkShape::circle: return std::hypot(dx, dy) - radius;
      case MarkShape::ring: return std::abs(std::hypot(dx, dy) - radius) - 1.0f;
      case MarkShape::square: return std::max(std::abs(dx), std::abs(dy)) - radius;
      case MarkShape::diamond: return (std::abs(dx) + std::abs(dy)) * 0.70710678f - radius;
    }
    return 1.0f;
  }

  void add(const DrawnMark& mark) {
    const DrawingPoint centre{mark.centre.x * scale_, mark.centre.y * scale_};
    const float radius = mark.radius * scale_, reach = 1.5f * radius + 2.0f;
    cover({centre.x - reach, centre.y - reach}, {centre.x + reach, centre.y + reach}, mark.colour, [&](float x, float y) {
      return std::clamp(0.5f - outside(mark.shape, x - centre.x, y - centre.y, radius), 0.0f, 1.0f) * mark.opacity;
    });
  }

  void add(const DrawnText& text) {
    TextStyle style = text.style;
    style.size *= scale_;
    const float width = textWidth(text.text, style);
    const float shift = text.anchor == TextAnchor::start ? 0.0f : text.anchor == TextAnchor::middle ? 0.5f * width : width;
    drawText(picture_, text.text, text.place.x * scale_ - shift, int(std::lround(text.place.y * scale_)), style);
  }

  float scale_;
  Picture picture_;
};

void move(DrawnBox& box, DrawingPoint by) { box.corner = {box.corner.x + by.x, box.corner.y + by.y}; }
void move(DrawnMark& mark, DrawingPoint by) { mark.centre = {mark.centre.x + by.x, mark.centre.y + by.y}; }
void move(DrawnText& text, DrawingPoint by) { text.place = {text.place.x + by.x, text.place.y + by.y}; }
void move(DrawnLine& line, DrawingPoint by) {
  for (DrawingPoint& point : line.points) point = {point.x + by.x, point.y + by.y};
}

}  // namespace

void place(Drawing& drawing, const Drawing& part, DrawingPoint at) {
  for (DrawnShape shape : part.shapes) {
    std::visit([&](auto& one) { move(one, at); }, shape);
    drawing.shapes.push_back(std::move(shape));
  }
}

Picture pictureOf(const Drawing& drawing, float scale) { return Painter(drawing, scale).paint(drawing); }

}  // namespace gridscope
