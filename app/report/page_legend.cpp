// See page_legend.h.
#include "app/report/page_legend.h"

#include <algorithm>

#include "app/base/text.h"
#include "views/drawing.h"
#include "views/legend.h"

namespace gridscope {

namespace {

std::string hexOf(const vec3& colour) {
  const uint32_t bytes = packBytes(colour);  // red first
  return printed("#%02X%02X%02X", bytes & 255u, bytes >> 8 & 255u, bytes >> 16 & 255u);
}

// The colours of a view's bar: of its marks where it counts what is marked.
std::string rampOf(const View& view) {
  constexpr int kStops = 16;
  const bool marked = !view.marks.empty() && view.range == ViewRange::automatic;
  std::string stops;
  for (int i = 0; i <= kStops; ++i) {
    const float x = float(i) / kStops;
    stops += "," + hexOf(marked ? markedColour(x, uvec2(0, 0)) : colourMap(kColourMapViridis, x));
  }
  return "linear-gradient(to right" + stops + ")";
}

std::string barHtml(const View& view, const ViewPicture& shown) {
  const float low = shown.range[0], high = shown.range[1];
  const std::vector<float> ticks = tickValues(low, high, 5);
  float step = high - low;
  for (size_t i = 1; i < ticks.size(); ++i) step = std::min(step, ticks[i] - ticks[i - 1]);
  std::string html = "<div class=\"ramp\"><i style=\"background:" + rampOf(view) + "\"></i><div>";
  for (float tick : ticks)
    html += printed("<span style=\"left:%.1f%%\">", 100.0 * double((tick - low) / std::max(high - low, 1e-30f))) +
            markupText(tickText(tick, step) + (shown.beyond && tick == high ? "+" : "")) + "</span>";
  return html + "</div></div><span class=\"unit\">" + markupText(view.unit) + "</span>";
}

// What is drawn beside the words, so that colour never stands alone.
std::string swatchSvg(const Meaning& meaning) {
  const std::string fill = printed(" fill=\"#%06X\"", meaning.colour), stroke = printed(" fill=\"none\" stroke=\"#%06X\"", meaning.colour);
  std::string shape;
  switch (meaning.swatch) {
    case Swatch::square: shape = "<rect width=\"12\" height=\"12\" rx=\"2\"" + fill + "/>"; break;
    case Swatch::diamond: shape = "<path d=\"M6 0L12 6L6 12L0 6Z\"" + fill + "/>"; break;
    case Swatch::ring: shape = "<circle cx=\"6\" cy=\"6\" r=\"4.5\" stroke-width=\"2\"" + stroke + "/>"; break;
    case Swatch::dot: shape = "<circle cx=\"6\" cy=\"6\" r=\"3.5\"" + fill + "/>"; break;
    case Swatch::line: shape = "<path d=\"M0 6H12\" stroke-width=\"3\" stroke-dasharray=\"3 2\"" + stroke + "/>"; break;
    case Swatch::hatch:
      shape = "<rect width=\"12\" height=\"12\" rx=\"2\"" + fill +
              "/><path d=\"M0 6L6 0M0 12L12 0M6 12L12 6\" stroke=\"#14171B\" stroke-width=\"1.5\"/>";
      break;
  }
  return "<svg viewBox=\"0 0 12 12\" width=\"12\" height=\"12\" aria-hidden=\"true\">" + shape + "</svg>";
}

}  // namespace

std::string legendHtml(const View& view, const ViewPicture& shown) {
  const std::vector<Meaning> meanings = viewMeanings(view);
  std::string html;
  if (view.range != ViewRange::none) html += barHtml(view, shown);
  for (const Meaning& meaning : meanings) html += "<span class=\"meaning\">" + swatchSvg(meaning) + markupText(meaning.words) + "</span>";
  if (!shown.note.empty()) html += "<span class=\"note\">" + markupText(shown.note) + "</span>";
  return html;
}

}  // namespace gridscope
