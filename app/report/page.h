// The page that a report is: one file that needs nothing else, neither network nor script. Its parts lie beside this file as page.html,
// .css and .js and travel inside the program.
#pragma once

#include <string>
#include <vector>

namespace gridscope {

struct PageSection {
  std::string id;     // of the link to it: letters and hyphens
  std::string title;  // text
  std::string html;
};

struct ReportPage {
  std::string title;  // text; the browser's and the heading
  std::string lead;   // text; a sentence below the heading
  std::string tiles;  // HTML, before the sections
  std::vector<PageSection> sections;
  std::string footer;  // text
};

std::string pageHtml(const ReportPage& page);

}  // namespace gridscope
