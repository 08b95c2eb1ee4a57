// Draws legends. Everything is placed left to right in rows and wraps when a row is full; nothing is drawn over the picture.
#include "views/legend.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "core/base/error.h"
#include "shaders/shared/views/palette.h"
#include "shaders/shared/views/truth_colours.h"
#include "views/fonts.h"

namespace gridscope {

static const Meaning kMeanings[] = {
    {"triangle hit", "triangle hit", kColourTriangleHit, Swatch::square},
    {"voxel hit", "voxel hit (gap filled)", kColourVoxelHit, Swatch::diamond},
    {"miss", "miss", kColourMiss, Swatch::square},
    {"saturated", "saturated: refused 1 or more", kColourSaturated, Swatch::hatch},
    {"none refused", "none refused", kColourLine, Swatch::square},
    {"tested", "tested, no hit", kColourTested, Swatch::square},
    {"revisit", "revisit", kColourRevisit, Swatch::ring},
    {"empty", "empty", kColourEmpty, Swatch::dot},
    {"hole", "hole", kColourHole, Swatch::square},
    {"voxel right", "voxel right", kColourVoxelRight, Swatch::diamond},
    {"voxel wrong", "voxel wrong", kColourVoxelWrong, Swatch::diamond},
    {"too far", "too far", kColourTooFar, Swatch::square},
    {"too near", "too near", kColourTooNear, Swatch::square},
    {"gate", "gate", kColourGate, Swatch::line},
    {"refused", "refused", kColourSaturated, Swatch::hatch},
    {"stepped over", "stepped over", causeColour(kCauseSteppedOver), Swatch::square},
    {"segment end", "segment end", causeColour(kCauseSegmentEnd), Swatch::square},
    {"accepted early", "accepted early", causeColour(kCauseAcceptedEarly), Swatch::square},
    {"filled early", "filled early", causeColour(kCauseFilledEarly), Swatch::diamond},
    {"alpha", "alpha", causeColour(kCauseAlpha), Swatch::dot},
    {"self-hit", "self-hit", causeColour(kCauseSelfHit), Swatch::square},
    {"outside", "outside the grid", causeColour(kCauseOutside), Swatch::square},
    {"left out", "left out", causeColour(kCauseLeftOut), Swatch::square},
    {"stale", "stale", causeColour(kCauseStale), Swatch::ring},
    {"not inserted", "not inserted", causeColour(kCauseNotInserted), Swatch::diamond},
    {"segment limit", "segment limit", causeColour(kCauseSegmentLimit), Swatch::line},
    {"numeric", "numeric", causeColour(kCauseNumeric), Swatch::dot},
    {"ray changes", "the ray's result changes", kColourRayChanges, Swatch::diamond},
    {"set differs", "the cell holds other references", kColourSetDiffers, Swatch::square},
    {"order differs", "the same in another order", kColourOrderDiffers, Swatch::line},
    {"filled", "filled: the instance's colour", kColourDim, Swatch::square},
    {"cleared", "only cleared: hatched", kColourDim, Swatch::line},
    {"cleared dark", "only cleared: darker", kColourEmpty, Swatch::dot},
    {"kept", "holds what it held: dim", kColourLine, Swatch::square},
};

// Pixels.
static constexpr int kPadding = 10;
static constexpr int kRow = 18;       // height of a row of text
static constexpr int kBaseline = 13;  // of a text in its row
static constexpr int kBarHeight = 10;
static constexpr int kTickRow = 20;  // height of the ticks and their numbers
static constexpr int kSwatchSize = 11;
static constexpr int kGap = 16;           // between things in a row
static constexpr int kShortestBar = 160;  // beside swatches
static constexpr int kWidestBar = 360;
static constexpr int kTwoColumns = 840;  // from this width on, the caller's lines stand on the right

static constexpr TextStyle kTitle{.font = Font::sans, .size = 14.0f, .colour = kColourText};
static constexpr TextStyle kWords{.font = Font::sans, .size = 13.0f, .colour = kColourText};
static constexpr TextStyle kQuiet{.font = Font::sans, .size = 13.0f, .colour = kColourDim};
static constexpr TextStyle kNumber{.font = Font::mono, .size = 12.0f, .colour = kColourText};

const Meaning* findMeaning(std::string_view name) {
  const Meaning* found = std::ranges::find(kMeanings, name, &Meaning::name);
  return found == std::end(kMeanings) ? nullptr : found;
}

std::vector<Meaning> viewMeanings(const View& view) {
  std::vector<Meaning> meanings;
  for (std::string_view rest = view.marks; !rest.empty();) {
    size_t comma = std::min(rest.find(", "), rest.size());
    const Meaning* meaning = findMeaning(rest.substr(0, comma));
    CHECK(meaning != nullptr);
    meanings.push_back(*meaning);
    rest.remove_prefix(std::min(comma + 2, rest.size()));
  }
  return meanings;
}

std::vector<float> tickValues(float low, float high, int most) {
  std::vector<float> values{low};
  double span = static_cast<double>(high) - low;
  if (!(span > 0.0) || !std::isfinite(span)) return values;

  // Capacities are mostly multiples of 8: quarters read better there.
  if (low == 0.0f && most >= 5 && span <= 4096.0 && std::fmod(span, 8.0) == 0.0 && std::fmod(span, 20.0) != 0.0)
    return {0.0f, high / 4.0f, high / 2.0f, high * 0.75f, high};

  // The smallest step of 1, 2 or 5 times a power of ten that leaves no more than `most`.
  double step = std::pow(10.0, std::floor(std::log10(span / std::max(most - 1, 1))));
  while (span / step > most - 1) {
    double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    step *= mantissa < 1.5 ? 2.0 : mantissa < 3.0 ? 2.5 : 2.0;
  }

  // Ticks nearer to an end than half a step would print over its number.
  for (double k = std::ceil(low / step); k * step < high; k += 1.0)
    if (k * step - low > 0.6 * step && high - k * step > 0.6 * step) values.push_back(static_cast<float>(k * step));
  values.push_back(high);
  return values;
}

std::string tickText(float value, float step) {
  int decimals = step > 0.0f && step < 1.0f ? std::min(static_cast<int>(std::ceil(-std::log10(step) - 1e-4f)), 6) : 0;
  if (decimals == 0 && value != std::floor(value) && std::abs(value) < 100.0f) decimals = 1;
  char digits[64];
  std::snprintf(digits, sizeof digits, "%.*f", decimals, static_cast<double>(value));
  std::string text = digits;
  size_t whole = std::min(text.find('.'), text.size());
  size_t first = text[0] == '-' ? 1 : 0;
  for (size_t i = whole; i > first + 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

static int widthOf(std::string_view text, const TextStyle& style) { return static_cast<int>(std::ceil(textWidth(text, style))); }

static int swatchWidth(const Meaning& meaning) { return kSwatchSize + 6 + widthOf(meaning.words, kWords); }

namespace {

// Draws into a strip that grows downwards: a pen moves right in its row and wraps.
class Strip {
 public:
  Strip(uint32_t width, int left, int right) : picture_(makePicture(width, 1, kColourLine)), left_(left), right_(right), x_(left) {}

  int width() const { return right_ - left_; }
  Picture take() { return reserve(y_ + kPadding - 2), std::move(picture_); }

  // Moves the pen to a new row, `height` below the last.
  void newRow(int height) { x_ = left_, y_ += height; }
  void gap() { x_ += kGap; }

  // Draws a text in the pen's row, shortened to what is left of it.
  void text(std::string_view text, const TextStyle& style) {
    reserve(y_ + kRow);
    std::string shorter = shortenText(text, static_cast<float>(right_ - x_), style);
    drawText(picture_, shorter, static_cast<float>(x_), y_ + kBaseline, style);
    x_ += widthOf(shorter, style);
  }

  // Words that wrap; a word wider than the row is shortened. `alignRight`: rows end at the right edge.
  void paragraph(std::string_view words, const TextStyle& style, bool alignRight) {
    while (!words.empty()) {
      std::string row = takeRow(words, style);
      if (alignRight) x_ = right_ - widthOf(row, style);
      text(row, style);
      newRow(kRow);
    }
  }

  void swatch(const Meaning& meaning) {
    if (x_ > left_ && x_ + swatchWidth(meaning) > right_) newRow(kRow);
    reserve(y_ + kRow);
    for (int row = 0; row < kSwatchSize; ++row)
      for (int column = 0; column < kSwatchSize; ++column)
        if (insideSwatch(meaning.swatch, column, row)) setPixel(x_ + column, y_ + 3 + row, swatchColour(meaning, column, row));
    x_ += kSwatchSize + 6;
    text(meaning.words, kWords);
    x_ += kGap;
  }

  // A bar of colours, `colourAt(x, pixel)` with x from 0 to 1, with ticks and numbers below. Leaves the pen behind it, in its row.
  template <typename ColourAt>
  void bar(const Legend& legend, int barWidth, ColourAt colourAt) {
    reserve(y_ + kBarHeight + 4 + kTickRow);
    for (int row = 0; row < kBarHeight; ++row)
      for (int i = 0; i < barWidth; ++i) {
        uvec2 pixel(static_cast<uint32_t>(x_ + i), static_cast<uint32_t>(y_ + 4 + row));
        setPixel(x_ + i, y_ + 4 + row, colourAt((static_cast<float>(i) + 0.5f) / static_cast<float>(barWidth), pixel));
      }
    ticks(legend, barWidth);
    x_ += barWidth + kGap;
  }

 private:
  // Makes the strip at least `height` high: a line on top, panel below.
  void reserve(int height) {
    if (height <= static_cast<int>(picture_.height)) return;
    picture_ = setBelow(picture_, makePicture(picture_.width, static_cast<uint32_t>(height) - picture_.height, kColourPanel));
  }

  void setPixel(int x, int y, vec3 colour) {
    if (x < 0 || y < 0 || x >= static_cast<int>(picture_.width) || y >= static_cast<int>(picture_.height)) return;
    uint32_t bytes = packBytes(colour);
    uint8_t* pixel = &picture_.rgba[4 * (static_cast<size_t>(y) * picture_.width + static_cast<size_t>(x))];
    for (int channel = 0; channel < 3; ++channel) pixel[channel] = static_cast<uint8_t>(bytes >> (8 * channel));
  }

  // The words that fit into a row, taken off `words`.
  std::string takeRow(std::string_view& words, const TextStyle& style) const {
    size_t end = 0;
    for (size_t next = 0; next < words.size();) {
      size_t space = std::min(words.find(' ', next), words.size());
      if (textWidth(words.substr(0, space), style) > static_cast<float>(width())) break;
      end = space;
      next = space + 1;
    }
    if (end == 0) end = std::min(words.find(' '), words.size());
    std::string row = shortenText(words.substr(0, end), static_cast<float>(width()), style);
    words.remove_prefix(std::min(end + 1, words.size()));
    return row;
  }

  void ticks(const Legend& legend, int barWidth) {
    float low = legend.range[0];
    float high = legend.range[1];
    std::vector<float> values = tickValues(low, high, std::max(barWidth / 48, 2));
    float step = high - low;
    for (size_t i = 1; i < values.size(); ++i) step = std::min(step, values[i] - values[i - 1]);
    for (float value : values) {
      float place = high > low ? (value - low) / (high - low) : 0.0f;
      int column = x_ + static_cast<int>(place * static_cast<float>(barWidth - 1) + 0.5f);
      for (int row = 0; row < 3; ++row) setPixel(column, y_ + 4 + kBarHeight + row, unpackColour(kColourDim));
      std::string number = tickText(value, step) + (legend.beyond && value == high ? "+" : "");
      float size = textWidth(number, kNumber);
      float start = std::clamp(static_cast<float>(column) - 0.5f * size, static_cast<float>(x_), static_cast<float>(x_ + barWidth) - size);
      drawText(picture_, number, start, y_ + 4 + kBarHeight + 15, kNumber);
    }
  }

  static bool insideSwatch(Swatch swatch, int column, int row) {
    int x = std::abs(2 * column - kSwatchSize + 1);
    int y = std::abs(2 * row - kSwatchSize + 1);
    int squared = x * x + y * y;
    if (swatch == Swatch::diamond) return x + y <= kSwatchSize;
    if (swatch == Swatch::ring) return squared <= 110 && squared >= 36;
    if (swatch == Swatch::dot) return squared <= 40;
    if (swatch == Swatch::line) return y <= 2 && column % 5 < 3;
    return true;
  }

  static vec3 swatchColour(const Meaning& meaning, int column, int row) {
    if (meaning.swatch != Swatch::hatch) return unpackColour(meaning.colour);
    return markedColour(1.0f, uvec2(static_cast<uint32_t>(column), static_cast<uint32_t>(row)));
  }

  Picture picture_;
  int left_;
  int right_;
  int x_;
  int y_ = 7;
};

// A view that marks what it counts, rather than what is beyond the capacity, shows the marks' colours in its bar.
bool countsMarks(const View& view) { return !view.marks.empty() && view.range == ViewRange::automatic; }

// Title, bar and swatches: what the view itself says.
void drawView(Strip& strip, const Legend& legend) {
  const View& view = *legend.view;
  std::string title = std::string(view.title) + (legend.note.empty() ? "" : " \u00b7 " + legend.note);
  strip.paragraph(title, kTitle, false);
  std::vector<Meaning> meanings = viewMeanings(view);
  if (view.range == ViewRange::none && meanings.empty()) return strip.paragraph(view.about, kQuiet, false);

  // The bar leaves room for its unit, and for the swatches where it stays long enough.
  int needed = widthOf(view.unit, kQuiet) + kGap;
  int swatches = 0;
  for (const Meaning& meaning : meanings) swatches += swatchWidth(meaning) + kGap;
  if (view.range != ViewRange::none) {
    int room = strip.width() - needed - kGap;
    bool oneRow = room - swatches >= kShortestBar;
    int barWidth = std::clamp(oneRow ? room - swatches : room, std::min(strip.width(), kShortestBar / 2), kWidestBar);
    bool marks = countsMarks(view);
    strip.bar(legend, barWidth, [&](float x, uvec2 pixel) { return marks ? markedColour(x, pixel) : colourMap(legend.colourMap, x); });
    strip.text(view.unit, kQuiet);
    strip.gap();
    if (!oneRow || meanings.empty()) strip.newRow(kBarHeight + 4 + kTickRow);
    for (const Meaning& meaning : meanings) strip.swatch(meaning);
    if (!meanings.empty()) strip.newRow(oneRow ? kBarHeight + 4 + kTickRow : kRow);
    return;
  }
  for (const Meaning& meaning : meanings) strip.swatch(meaning);
  strip.newRow(kRow);
}

}  // namespace

// Copies the rows of `part` into `whole` from a row on, columns from `left` on.
static void paste(Picture& whole, const Picture& part, uint32_t top, uint32_t left) {
  for (uint32_t row = 0; row < part.height && top + row < whole.height; ++row) {
    auto from = part.rgba.begin() + static_cast<ptrdiff_t>(4) * (static_cast<ptrdiff_t>(row) * part.width + left);
    auto to = whole.rgba.begin() + static_cast<ptrdiff_t>(4) * (static_cast<ptrdiff_t>(top + row) * whole.width + left);
    std::copy_n(from, static_cast<ptrdiff_t>(4) * (part.width - left), to);
  }
}

Picture drawLegend(const Legend& legend, uint32_t width) {
  int right = std::max(static_cast<int>(width) - kPadding, kPadding + 1);

  // Narrow: everything in one column.
  if (width < kTwoColumns) {
    Strip strip(width, kPadding, right);
    drawView(strip, legend);
    for (const std::string& line : legend.lines) strip.paragraph(line, kQuiet, false);
    return strip.take();
  }

  // Wide: the caller's lines in the right half.
  int middle = static_cast<int>(width) / 2;
  Strip left(width, kPadding, middle - kPadding);
  drawView(left, legend);
  Strip lines(width, middle + kPadding, right);
  for (const std::string& line : legend.lines) lines.paragraph(line, kQuiet, true);
  Picture leftPicture = left.take();
  Picture linesPicture = lines.take();
  uint32_t height = std::max(linesPicture.height, leftPicture.height);
  Picture strip = setBelow(leftPicture, makePicture(width, height - leftPicture.height, kColourPanel));
  paste(strip, linesPicture, 0, static_cast<uint32_t>(middle));
  return strip;
}

Picture setBelow(const Picture& picture, const Picture& strip) {
  CHECK_EQ(picture.width, strip.width);
  Picture both = picture;
  both.height += strip.height;
  both.rgba.insert(both.rgba.end(), strip.rgba.begin(), strip.rgba.end());
  return both;
}

}  // namespace gridscope
