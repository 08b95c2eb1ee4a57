// The report of `gridscope report` made beside the window: on a thread, a device and a pipeline of its own.
#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/jobs/file_jobs.h"
#include "app/session/options.h"

namespace gridscope {

struct ReportState {
  bool running = false;
  std::string what;    // the step that is done
  float share = 0.0f;  // 0..1 of the steps
};

class ReportJob {
 public:
  ~ReportJob();

  // Begins one; options.page is the file. Nothing where one runs already.
  void start(const Options& options);
  void cancel() { cancel_ = true; }  // after the step that is done
  ReportState state() const;
  std::optional<FileJobs::News> takeNews();  // what became of the last one, once
  void finish();                             // waits: for tests

 private:
  void run(const Options& options);

  mutable std::mutex mutex_;  // guards the next two
  ReportState state_;
  std::optional<FileJobs::News> news_;
  std::atomic<bool> cancel_ = false;
  std::thread thread_;
};

}  // namespace gridscope
