// See page_sections.h; the tables of what was lost lie in page_losses.cpp, the plots in page_plots.cpp.
#include "app/report/page_sections.h"

#include <span>
#include <utility>

#include "app/base/text.h"
#include "app/report/capture_pictures.h"
#include "app/report/page_html.h"
#include "app/report/page_legend.h"
#include "app/session/settings_table.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "core/base/write_file.h"
#include "shaders/shared/views/truth_colours.h"
#include "views/drawing.h"

namespace gridscope {

namespace {

std::string tile(const std::string& figure, const std::string& words, uint32_t colour) {
  return "<div class=\"tile\" style=\"--mark:" + cssColour(colour) + "\"><b>" + markupText(figure) + "</b><span>" + markupText(words) +
         "</span></div>";
}

// An image of the gallery; alone it says all that the comparison adds a wipe to.
std::string figureHtml(const PagePicture& picture) {
  const View& view = *picture.view;
  const Picture& pixels = picture.shown.picture;
  const std::string title = markupText(view.title), name(view.name);
  const char* kind = view.scope == ViewScope::slice ? "slice" : "ray";  // slices are no picture of the frame: nothing to compare
  return std::string("<figure class=\"") + kind + "\" id=\"view-" + name + "\" data-title=\"" + title + "\">" +
         printed("<img class=\"picture\" width=\"%u\" height=\"%u\" alt=\"", pixels.width, pixels.height) + title + "\" src=\"" +
         pngDataUri(pngBytes(pixels)) + "\"/><div class=\"legend\">" + legendHtml(view, picture.shown) + "</div><figcaption><b>" + title +
         "</b>" + markupText(view.about) + "<br/></figcaption></figure>\n";
}

// Which group of pictures a view belongs to.
struct PictureGroup {
  const char* title;
  bool (*has)(const View& view);
};
bool ofTruth(const View& view) { return view.need == ViewNeed::truth || view.need == ViewNeed::triangleCosts; }
bool ofGrid(const View& view) {
  return !ofTruth(view) && (view.needsGrid || view.scope == ViewScope::slice || view.need != ViewNeed::nothing);
}
constexpr PictureGroup kGroups[] = {
    {"What is wrong, and why", ofTruth},
    {"The rays",
     [](const View& view) { return !ofTruth(view) && !ofGrid(view) && (view.scope == ViewScope::ray || view.name == "final"); }},
    {"The grid", ofGrid},
    {"What the camera sees",
     [](const View& view) { return !ofTruth(view) && !ofGrid(view) && view.scope != ViewScope::ray && view.name != "final"; }},
};

constexpr const char* kCompare = R"(<div class="compare" id="compare" hidden="hidden">
<div class="compare-bar">
<label>Left <select data-part="choice-a"></select></label>
<label>Right <select data-part="choice-b"></select></label>
<button type="button" data-part="flip">Swap <kbd>X</kbd></button>
<label class="wide">Wipe <kbd>[</kbd><kbd>]</kbd> <input data-part="wipe" type="range" min="0" max="1000" value="500" aria-label="Where the left picture ends"/></label>
</div>
<div class="stage" data-part="stage"><img data-part="picture-a" alt=""/><img data-part="picture-b" alt=""/><i class="edge"></i><i class="mark" data-part="mark" hidden="hidden"></i><span class="side a" data-part="name-a"></span><span class="side b" data-part="name-b"></span><span class="pixel" data-part="pixel" aria-hidden="true"></span></div>
<div class="legends"><div class="legend" data-part="legend-a"></div><div class="legend" data-part="legend-b"></div></div>
</div>
)";

std::string leadOf(const PageFrame& frame) {
  const TruthTotals& totals = frame.explained.frame.totals;
  std::string lead = printed("%s of %s rays are wrong (%s): holes, wrong voxel hits, hits too far or too near. ",
                             grouped(totals.wrong()).c_str(), grouped(totals.rays).c_str(), percentOf(totals.wrong(), totals.rays).c_str());
  lead += gridText(frame.grid) + "; " + frame.device + ".";
  if (frame.frameCount > 1) lead += printed(" Frame %u of frames 0 to %u.", frame.explained.frameNumber, frame.frameCount - 1);
  if (frame.explained.foreignHits.value_or(0) > 0)
    lead += " " + foreignHitsText(*frame.explained.foreignHits) + "; visits and tests are this trace's.";
  return lead;
}

}  // namespace

std::string tilesHtml(const PageFrame& frame) {
  const TruthTotals& totals = frame.explained.frame.totals;
  const FrameReport& report = frame.rendered.frames.back();
  auto share = [&](uint32_t verdict) { return percentOf(totals.verdicts[verdict], totals.rays); };
  std::string html = "<div class=\"tiles\">" + tile(percentOf(totals.wrong(), totals.rays), "rays wrong", kColourHole);
  for (uint32_t verdict : {kVerdictHole, kVerdictVoxelWrong, kVerdictTooFar, kVerdictTooNear, kVerdictVoxelRight})
    html += tile(share(verdict), std::string(verdictName(verdict).title), verdictColour(verdict));
  if (frame.explained.countsRefused)
    html += tile(percentOf(report.grid.refused(), report.grid.stored() + report.grid.refused()), "references refused", kColourSaturated);
  html += tile(percentOf(report.grid.statistics.saturated, report.grid.statistics.occupied), "occupied cells saturated", kColourSaturated);
  html += tile(byteText(gridByteCount(frame.grid)), "memory of the grid", kColourDim);
  return html + tile(printed(report.times.trace < 100.0 ? "%.2f ms" : "%.0f ms", report.times.trace), "trace", kColourDim) + "</div>\n";
}

std::string picturesHtml(const PageFrame& frame) {
  std::string html = kCompare;
  for (const PictureGroup& group : kGroups) {
    std::string figures;
    for (const PagePicture& picture : frame.pictures)
      if (group.has(*picture.view)) figures += figureHtml(picture);
    if (!figures.empty()) html += std::string("<h3>") + group.title + "</h3><div class=\"gallery\">\n" + figures + "</div>\n";
  }
  return html;
}

std::string statisticsHtml(const PageFrame& frame) {
  PageTable table("", "ll", {"", "of the frame"});
  for (const std::vector<std::string>& row : frame.statistics) table.add({row[0], row[1]});
  bool first = true;
  for (const std::string& warning : frame.warnings) table.add({std::exchange(first, false) ? "warnings" : "", warning});
  return table.html();
}

std::string invariantsHtml(const PageFrame& frame) {
  PageTable table("", "nnl", {"what must hold", "does it?", ""});
  for (const Invariant& invariant : frame.invariants) {
    const char* word = !invariant.whyNot.empty() ? "does not apply" : invariant.holds() ? "holds" : "broken";
    const std::string colour = cssColour(!invariant.whyNot.empty() ? kColourDim : invariant.holds() ? kColourTriangleHit : kColourHole);
    table.add({invariant.name, PageCell::named(word, colour), invariant.holds() ? invariant.whyNot : invariant.fault}, !invariant.holds());
  }
  return table.html();
}

std::string settingsHtml(const PageFrame& frame) {
  PageTable table("", "llll", {"option", "value", "default", ""});
  for (const SettingText& setting : settingTexts(frame.settings))
    table.add({setting.option, setting.value, setting.usual, setting.about}, setting.changed());
  return "<p class=\"dim\">Marked rows differ from the defaults.</p>" + table.html();
}

std::string deviceHtml(const PageFrame& frame) {
  return paragraph("Build, update and trace ran on " + frame.device + ", gridscope " + kVersion +
                   ". The exact hits were found on the CPU, among all triangles, without a grid.") +
         "<h3>Make this page again</h3>" + codeBlock(frame.command);
}

ReportPage reportPage(const PageFrame& frame) {
  ReportPage page{.title = frame.scene, .lead = leadOf(frame), .tiles = tilesHtml(frame)};
  page.sections = {{"pictures", "Pictures", picturesHtml(frame)},       {"verdicts", "Verdicts and causes", verdictsHtml(frame)},
                   {"costs", "What it cost", costsHtml(frame)},         {"plots", "Plots", plotsHtml(frame)},
                   {"statistics", "Statistics", statisticsHtml(frame)}, {"invariants", "Invariants", invariantsHtml(frame)},
                   {"settings", "Settings", settingsHtml(frame)},       {"device", "Device and command", deviceHtml(frame)}};
  page.footer = std::string("Written by gridscope ") + kVersion + ". This page needs no network.";
  return page;
}

size_t writePage(const std::filesystem::path& file, const PageFrame& frame) {
  const std::string html = pageHtml(reportPage(frame));
  try {
    writeWholeFile(file, std::as_bytes(std::span(html)));
  } catch (const Error& error) {
    throw error.within(file.string());
  }
  return html.size();
}

}  // namespace gridscope
