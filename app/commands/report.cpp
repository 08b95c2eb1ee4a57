// gridscope report: one self-contained page about a frame, for a colleague or a CI artifact.
#include <algorithm>

#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/page_frame.h"
#include "app/report/page_sections.h"

namespace gridscope {

void addReportOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  addFrameNumberOption(command, options);
  addTruthOptions(command, options);
  addPageOption(command, options);
}

int runReport(const Options& options) {
  Progress progress(kPageSteps + allViews().size());
  Session session(options, progress);
  const PageFrame frame = makePageFrame(options, session, progress);
  progress.step("write the page");
  const size_t bytes = writePage(options.page, frame);
  progress.clear();

  const TruthTotals& totals = frame.explained.frame.totals;
  std::printf("%s: %s; %s of %s rays are wrong (%s)\n", options.page.string().c_str(), byteText(bytes).c_str(),
              grouped(totals.wrong()).c_str(), grouped(totals.rays).c_str(), percentOf(totals.wrong(), totals.rays).c_str());
  return session.validationMessages() > 0 ? kExitDifferent : kExitDone;
}

}  // namespace gridscope
