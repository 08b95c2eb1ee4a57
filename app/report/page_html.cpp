// See page_html.h.
#include "app/report/page_html.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "core/base/error.h"
#include "views/drawing.h"

namespace gridscope {

static std::string markStyle(const std::string& colour) { return colour.empty() ? "" : " style=\"--mark:" + markupText(colour) + "\""; }

static std::string cellHtml(const PageCell& cell, char column) {
  if (cell.isBar) {
    const double percent = std::isfinite(cell.share) ? std::clamp(cell.share, 0.0, 1.0) * 100.0 : 0.0;
    const std::string mark = cell.colour.empty() ? "" : "--mark:" + markupText(cell.colour) + ";";
    return "<td class=\"bar\"><i style=\"" + mark + printed("width:%.1f%%", percent) + "\"></i></td>";
  }
  const std::string swatch = cell.colour.empty() ? "" : "<span class=\"swatch\"" + markStyle(cell.colour) + "></span>";
  const std::string pixel = cell.isPixel ? " data-pixel=\"" + markupText(cell.text) + "\"" : "";
  const std::string kind = column == 'r' ? " class=\"r\"" : column == 'n' ? " class=\"n\"" : "";
  return "<td" + kind + pixel + ">" + swatch + markupText(cell.text) + "</td>";
}

PageTable::PageTable(std::string caption, std::string columns, std::vector<std::string> names)
    : caption_(std::move(caption)), columns_(std::move(columns)) {
  CHECK_EQ(columns_.size(), names.size());
  for (size_t i = 0; i < names.size(); ++i)
    head_ += std::string("<th scope=\"col\"") + (columns_[i] == 'r' ? " class=\"r\">" : ">") + markupText(names[i]) + "</th>";
}

void PageTable::add(std::vector<PageCell> cells, bool marked) {
  CHECK_EQ(cells.size(), columns_.size());
  body_ += marked ? "<tr class=\"changed\">" : "<tr>";
  for (size_t i = 0; i < cells.size(); ++i) body_ += cellHtml(cells[i], columns_[i]);
  body_ += "</tr>\n";
  ++rows_;
}

std::string PageTable::html(std::string_view whenEmpty) const {
  if (empty())
    return (caption_.empty() ? "" : "<h3>" + markupText(caption_) + "</h3>") + "<p class=\"dim\">" + markupText(whenEmpty) + "</p>\n";
  std::string html = std::string("<div class=\"scroll\"><table") + (caption_.empty() ? "" : " class=\"sortable\"") + ">";
  if (!caption_.empty()) html += "<caption>" + markupText(caption_) + "</caption>";
  return html + "<thead><tr>" + head_ + "</tr></thead><tbody>\n" + body_ + "</tbody></table></div>\n";
}

std::string paragraph(std::string_view text) { return "<p>" + markupText(text) + "</p>\n"; }
std::string codeBlock(std::string_view text) { return "<pre><code>" + markupText(text) + "</code></pre>\n"; }

std::string pngDataUri(std::span<const std::byte> png) {
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string uri = "data:image/png;base64,";
  uri.reserve(uri.size() + (png.size() + 2) / 3 * 4);
  for (size_t i = 0; i < png.size(); i += 3) {
    const size_t count = std::min<size_t>(3, png.size() - i);
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < count ? uint32_t(png[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) uri += k <= count ? kDigits[(bits >> (18 - 6 * k)) & 63u] : '=';
  }
  return uri;
}

std::string cssColour(uint32_t colour) {
  const char* property = colourProperty(colour);
  const std::string hex = printed("#%06X", colour & 0xFFFFFFu);
  return property ? std::string("var(") + property + "," + hex + ")" : hex;
}

}  // namespace gridscope
