// See junit.h.
#include "app/report/junit.h"

#include <algorithm>
#include <fstream>

#include "app/base/text.h"
#include "core/base/error.h"

namespace gridscope {

// Text for XML 1.0: what it can't hold, control characters and bytes that are no ASCII (names come from files), becomes a question mark.
static std::string escaped(const std::string& text) {
  std::string result;
  for (unsigned char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\n')
      result += "&#10;";
    else
      result += c < 0x20 || c > 0x7E ? '?' : char(c);
  }
  return result;
}

static std::string caseText(const std::string& suite, const JUnitCase& one) {
  static constexpr const char* kElements[] = {"", "failure", "error", "skipped"};
  std::string text =
      "  <testcase classname=\"" + escaped(suite) + "\" name=\"" + escaped(one.name) + printed("\" time=\"%.3f\"", one.seconds);
  if (one.outcome == JUnitCase::Outcome::passed) return text + "/>\n";
  const std::string element = kElements[static_cast<size_t>(one.outcome)];
  return text + ">\n    <" + element + " message=\"" + escaped(one.message) + "\">" + escaped(one.details) + "</" + element +
         ">\n  </testcase>\n";
}

std::string junitText(const std::string& suite, const std::vector<JUnitCase>& cases) {
  const auto count = [&](JUnitCase::Outcome outcome) { return std::ranges::count(cases, outcome, &JUnitCase::outcome); };
  double seconds = 0.0;
  std::string body;
  for (const JUnitCase& one : cases) seconds += one.seconds, body += caseText(suite, one);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
         printed("<testsuite name=\"%s\" tests=\"%zu\" failures=\"%td\" errors=\"%td\" skipped=\"%td\" time=\"%.3f\">\n",
                 escaped(suite).c_str(), cases.size(), count(JUnitCase::Outcome::failure), count(JUnitCase::Outcome::error),
                 count(JUnitCase::Outcome::skipped), seconds) +
         body + "</testsuite>\n";
}

void writeJUnit(const std::filesystem::path& path, const std::string& suite, const std::vector<JUnitCase>& cases) {
  std::error_code ignored;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ignored);
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!(file << junitText(suite, cases) << std::flush))
    throw Error("--junit " + path.string() + ": can't be written; check folder, permissions and space");
}

}  // namespace gridscope
