// The worker: a thread of low priority that owns the device of the stages and makes the frames that are asked for, newest request first.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "app/worker/maker.h"

namespace gridscope {

class FrameWorker {
 public:
  // `start`: the command line. `wake`: called on the worker's thread whenever there is something new.
  FrameWorker(const Options& start, std::function<void()> wake);
  ~FrameWorker();

  void end();  // as soon as it can; nothing may be asked for afterwards

  void ask(const FrameRequest& request);  // replaces what was asked before
  void cancel();                          // the long work
  void capture(const CaptureWish& wish);  // the frame that is shown, once it is complete

  std::shared_ptr<const FrameSnapshot> newest() const;
  std::optional<LongWork> work() const;
  std::vector<LogLine> takeLines();  // what it says; seconds are not filled in
  std::string shaderFault() const;   // the compiler's text of the last reload; empty: none
  std::string deviceFault() const;   // why there is no device at all; empty: there is one, or it is being opened
  bool idle() const;                 // everything that was asked for is made
  uint32_t validationMessages() const { return validationMessages_; }

 private:
  void run();
  void work(GpuContext& gpu);
  FrameListener listener();
  void say(LogLine::Kind kind, std::string text, bool shown = false);

  Options start_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards all below but the atomics
  std::condition_variable asked_;
  std::optional<FrameRequest> request_;  // not taken yet
  std::vector<CaptureWish> captures_;
  std::shared_ptr<const FrameSnapshot> newest_;
  std::optional<LongWork> work_;
  std::chrono::steady_clock::time_point workBegan_;
  std::vector<LogLine> lines_;
  std::string shaderFault_, deviceFault_;
  bool idle_ = false;
  std::atomic<bool> waiting_ = false;  // a request has not been taken: what runs is interrupted
  std::atomic<bool> cancel_ = false;
  std::atomic<bool> stop_ = false;
  std::atomic<uint32_t> validationMessages_ = 0;
  std::thread thread_;
};

}  // namespace gridscope
