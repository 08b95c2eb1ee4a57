// See page.h.
#include "app/report/page.h"

#include <map>
#include <string_view>

#include "core/base/embed.h"
#include "core/base/error.h"
#include "views/drawing.h"

EMBED(gridscope_page_html, GRIDSCOPE_PAGE ".html");
EMBED(gridscope_page_css, GRIDSCOPE_PAGE ".css");
EMBED(gridscope_page_js, GRIDSCOPE_PAGE ".js");

namespace gridscope {

static std::string_view bytesBetween(const unsigned char* begin, const unsigned char* end) {
  return {reinterpret_cast<const char*>(begin), size_t(end - begin)};
}

// The template with {{name}} replaced, in one pass: what comes in is not looked at again.
static std::string filled(std::string_view text, const std::map<std::string_view, std::string>& parts) {
  std::string result;
  for (size_t open = text.find("{{"); open != std::string_view::npos; open = text.find("{{")) {
    const size_t close = text.find("}}", open);
    CHECK(close != std::string_view::npos);
    const auto part = parts.find(text.substr(open + 2, close - open - 2));
    CHECK(part != parts.end());
    result.append(text.substr(0, open)).append(part->second);
    text.remove_prefix(close + 2);
  }
  return result.append(text);
}

std::string pageHtml(const ReportPage& page) {
  std::string navigation, sections = page.tiles;
  for (const PageSection& section : page.sections) {
    navigation += "<a href=\"#" + section.id + "\">" + markupText(section.title) + "</a>";
    sections += "<section id=\"" + section.id + "\" aria-labelledby=\"" + section.id + "-title\"><h2 id=\"" + section.id + "-title\">" +
                markupText(section.title) + "</h2><div class=\"body\">\n" + section.html + "</div></section>\n";
  }
  return filled(bytesBetween(gridscope_page_html, gridscope_page_html_end),
                {{"title", markupText(page.title)},
                 {"heading", markupText(page.title)},
                 {"lead", markupText(page.lead)},
                 {"navigation", navigation},
                 {"sections", sections},
                 {"footer", markupText(page.footer)},
                 {"css", std::string(bytesBetween(gridscope_page_css, gridscope_page_css_end))},
                 {"js", std::string(bytesBetween(gridscope_page_js, gridscope_page_js_end))}});
}

}  // namespace gridscope
