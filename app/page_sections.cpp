// See page_sections.h; the tables of what was lost lie in page_losses.cpp, the plots in page_plots.cpp.
#include "app/page_sections.h"

#include <utility>

#include "app/capture_pictures.h"
#include "app/page_html.h"
#include "app/settings_table.h"
#include "app/text.h"
#include "shaders/shared/truth_colours.h"
#include "views/drawing.h"

namespace gridscope {

namespace {

std::string tile(const std::string& figure, const std::string& words, uint32_t colour) {
  return "<div class=\"tile\" style=\"--mark:" + cssColour(colour) + "\"><b>" + markupText(figure) + "</b><span>" + markupText(words) + "</span></div>";
}

// An image of the gallery; alone it says all that the comparison adds a wipe to.
std::string imageHtml(const char* kind, const Picture& picture, const std::string& alt) {
  return printed("<img class=\"%s\" width=\"%u\" height=\"%u\" alt=\"", kind, picture.width, picture.height) + markupText(alt) + "\" src=\"" +
         pngDataUri(pngBytes(picture)) + "\"/>";
}

std::string figureHtml(const PagePicture& picture) {
  const View& view = *picture.view;
  const std::string title(view.title), name(view.name);
  const bool compared = view.scope != ViewScope::slice;
  return std::string("<figure class=\"") + (compared ? "ray" : "slice") + "\" id=\"view-" + name + "\" data-title=\"" + markupText(title) + "\">" +
         imageHtml("picture", picture.picture, title) + imageHtml("legend", picture.legend, "How to read it: " + title) + "<figcaption><b>" + markupText(title) +
         "</b>" + markupText(view.about) + "<br/></figcaption></figure>\n";
}

constexpr const char* kCompare = R"(<div class="compare" id="compare" hidden="hidden">
<div class="compare-bar">
<label>Left (A) <select data-part="choice-a"></select></label>
<label>Right (B) <select data-part="choice-b"></select></label>
<button type="button" data-part="flip">Swap <kbd>X</kbd></button>
<label class="wide">Wipe <kbd>[</kbd> <kbd>]</kbd> <input data-part="wipe" type="range" min="0" max="1000" value="500" aria-label="Where the left picture ends"/></label>
</div>
<div class="stage" data-part="stage"><img data-part="picture-a" alt=""/><img data-part="picture-b" alt=""/><i class="edge"></i><span class="side a" data-part="name-a"></span><span class="side b" data-part="name-b"></span></div>
<div class="legends"><img data-part="legend-a" alt=""/><img data-part="legend-b" alt=""/></div>
</div>
)";

std::string leadOf(const PageFrame& frame) {
  const TruthTotals& totals = frame.explained.frame.totals;
  return printed("%s of %s rays are wrong (%s): holes, wrong voxel hits, hits too far or too near. ", grouped(totals.wrong()).c_str(), grouped(totals.rays).c_str(),
                 percentOf(totals.wrong(), totals.rays).c_str()) +
         gridText(frame.grid) + "; " + frame.device + ".";
}

}  // namespace

std::string tilesHtml(const PageFrame& frame) {
  const TruthTotals& totals = frame.explained.frame.totals;
  const FrameReport& report = frame.rendered.frames.back();
  auto share = [&](uint32_t verdict) { return percentOf(totals.verdicts[verdict], totals.rays); };
  std::string html = "<div class=\"tiles\">" + tile(percentOf(totals.wrong(), totals.rays), "rays wrong", kColourHole);
  for (uint32_t verdict : {kVerdictHole, kVerdictVoxelWrong, kVerdictTooFar, kVerdictTooNear, kVerdictVoxelRight})
    html += tile(share(verdict), std::string(verdictName(verdict).title), verdictColour(verdict));
  html += tile(percentOf(report.grid.refused(), report.grid.stored() + report.grid.refused()), "references refused", kColourSaturated);
  html += tile(percentOf(report.grid.statistics.saturated, report.grid.statistics.occupied), "occupied cells saturated", kColourSaturated);
  html += tile(byteText(gridByteCount(frame.grid)), "memory of the grid", kColourDim);
  return html + tile(printed(report.times.trace < 100.0 ? "%.2f ms" : "%.0f ms", report.times.trace), "trace", kColourDim) + "</div>\n";
}

std::string picturesHtml(const PageFrame& frame) {
  std::string html = kCompare;
  html += "<div class=\"gallery\">\n";
  for (const PagePicture& picture : frame.pictures) html += figureHtml(picture);
  return html + "</div>\n";
}

std::string statisticsHtml(const PageFrame& frame) {
  PageTable table("", "ll", {"", "of the frame"});
  for (const std::vector<std::string>& row : frame.statistics) table.add({row[0], row[1]});
  bool first = true;
  for (const std::string& broken : frame.brokenInvariants) table.add({std::exchange(first, false) ? "invariants" : "", "BROKEN: " + broken}, true);
  if (frame.brokenInvariants.empty()) table.add({"invariants", "all hold"});
  first = true;
  for (const std::string& warning : frame.warnings) table.add({std::exchange(first, false) ? "warnings" : "", warning});
  return table.html();
}

std::string settingsHtml(const PageFrame& frame) {
  PageTable table("", "llll", {"option", "value", "default", ""});
  for (const SettingText& setting : settingTexts(frame.settings))
    table.add({setting.option, setting.value, setting.usual, setting.about}, setting.changed());
  return "<p class=\"dim\">Marked rows differ from the defaults.</p>" + table.html();
}

std::string deviceHtml(const PageFrame& frame) {
  return paragraph("Build, update and trace ran on " + frame.device + ", gridscope " + GRIDSCOPE_VERSION + ". The exact hits were found on the CPU, among all triangles, without a grid.") +
         "<h3>Make this page again</h3>" + codeBlock(frame.command);
}

ReportPage reportPage(const PageFrame& frame) {
  ReportPage page{.title = frame.scene, .lead = leadOf(frame), .tiles = tilesHtml(frame)};
  page.sections = {{"pictures", "Pictures", picturesHtml(frame)},       {"verdicts", "Verdicts and causes", verdictsHtml(frame)},
                   {"costs", "What it cost", costsHtml(frame)},         {"plots", "Plots", plotsHtml(frame)},
                   {"statistics", "Statistics", statisticsHtml(frame)}, {"settings", "Settings", settingsHtml(frame)},
                   {"device", "Device and command", deviceHtml(frame)}};
  page.footer = std::string("Written by gridscope ") + GRIDSCOPE_VERSION + ". This page needs no network.";
  return page;
}

}  // namespace gridscope
