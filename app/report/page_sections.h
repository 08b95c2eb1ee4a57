// The sections of a report's page, each from what was collected about the frame.
#pragma once

#include <filesystem>

#include "app/report/page.h"
#include "app/report/page_frame.h"

namespace gridscope {

std::string tilesHtml(const PageFrame& frame);     // the figures that matter most
std::string picturesHtml(const PageFrame& frame);  // every view, and two of them to compare
std::string verdictsHtml(const PageFrame& frame);  // verdicts and causes
std::string costsHtml(const PageFrame& frame);     // meshes, instances and cells that cost most, the worst rays
std::string plotsHtml(const PageFrame& frame);     // occupancy, demand, visits, tests
std::string statisticsHtml(const PageFrame& frame);
std::string invariantsHtml(const PageFrame& frame);  // what must hold, and whether it does
std::string settingsHtml(const PageFrame& frame);
std::string deviceHtml(const PageFrame& frame);  // and the command to make the page again

// All of it.
ReportPage reportPage(const PageFrame& frame);

// The frame's page as a file of that name; its bytes. Throws Error that names the file.
size_t writePage(const std::filesystem::path& file, const PageFrame& frame);

}  // namespace gridscope
