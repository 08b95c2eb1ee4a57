// gridscope report: a page about one frame.
#include "app/commands.h"
#include "app/report.h"

namespace gridscope {

void addReportOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  addPageOption(command, options);
  addJsonOption(command, options);
}

int runReport(const Options&) { return 0; }

}  // namespace gridscope
