// See report_job.h.
#include "app/jobs/report_job.h"

#include "app/base/low_priority.h"
#include "app/base/text.h"
#include "app/report/page_frame.h"
#include "app/report/page_sections.h"

namespace gridscope {

namespace {

struct Cancelled {};

// Makes the page and writes it; what to say of it.
std::string makeReport(const Options& options, Progress& progress) {
  Session session(options, progress);
  const PageFrame frame = makePageFrame(options, session, progress);
  progress.step("write the page");
  writePage(options.page, frame);
  const TruthTotals& totals = frame.explained.frame.totals;
  return "Reported in " + options.page.string() + ": " + grouped(totals.wrong()) + " of " + grouped(totals.rays) + " rays are wrong";
}

}  // namespace

ReportJob::~ReportJob() {
  cancel();
  finish();
}

void ReportJob::finish() {
  if (thread_.joinable()) thread_.join();
}

void ReportJob::start(const Options& options) {
  if (state().running) return;
  finish();
  cancel_ = false;
  state_ = {.running = true, .what = "start"};
  thread_ = std::thread([this, options] { run(options); });
}

void ReportJob::run(const Options& options) {
  lowerThreadPriority();
  FileJobs::News news;
  try {
    Progress progress(kPageSteps + allViews().size(), [this](float share, const std::string& what) {
      if (cancel_) throw Cancelled();
      const std::lock_guard lock(mutex_);
      state_.share = share, state_.what = what;
    });
    news.text = makeReport(options, progress);
  } catch (const Cancelled&) {
    news.text = "The report was cancelled";
  } catch (const std::exception& error) {
    news = {true, std::string("The report: ") + error.what()};
  }
  const std::lock_guard lock(mutex_);
  news_ = std::move(news);
  state_.running = false;
}

ReportState ReportJob::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::optional<FileJobs::News> ReportJob::takeNews() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, std::nullopt);
}

}  // namespace gridscope
