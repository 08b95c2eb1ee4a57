// See worker.h.
#include "app/worker/worker.h"

#include <utility>

#include "app/base/low_priority.h"

namespace gridscope {

// Work that is over sooner is not told of.
static constexpr double kLongWorkSeconds = 0.15;

FrameWorker::FrameWorker(const Options& start, std::function<void()> wake)
    : start_(start), wake_(std::move(wake)), thread_([this] { run(); }) {}

FrameWorker::~FrameWorker() { end(); }

void FrameWorker::end() {
  if (!thread_.joinable()) return;
  stop_ = true;
  { std::lock_guard lock(mutex_); }
  asked_.notify_all();
  thread_.join();
}

void FrameWorker::ask(const FrameRequest& request) {
  {
    std::lock_guard lock(mutex_);
    request_ = request;
    idle_ = false;
    waiting_ = true;
  }
  asked_.notify_all();
}

void FrameWorker::cancel() { cancel_ = true; }

void FrameWorker::capture(const CaptureWish& wish) {
  {
    std::lock_guard lock(mutex_);
    captures_.push_back(wish);
    idle_ = false;
  }
  asked_.notify_all();
}

std::shared_ptr<const FrameSnapshot> FrameWorker::newest() const {
  std::lock_guard lock(mutex_);
  return newest_;
}

std::optional<LongWork> FrameWorker::work() const {
  std::lock_guard lock(mutex_);
  if (!work_) return std::nullopt;
  LongWork work = *work_;
  work.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - workBegan_).count();
  return work.seconds < kLongWorkSeconds ? std::nullopt : std::optional(work);
}

std::vector<LogLine> FrameWorker::takeLines() {
  std::lock_guard lock(mutex_);
  return std::exchange(lines_, {});
}

std::string FrameWorker::shaderFault() const {
  std::lock_guard lock(mutex_);
  return shaderFault_;
}

std::string FrameWorker::deviceFault() const {
  std::lock_guard lock(mutex_);
  return deviceFault_;
}

bool FrameWorker::idle() const {
  std::lock_guard lock(mutex_);
  return idle_;
}

void FrameWorker::say(LogLine::Kind kind, std::string text, bool shown) {
  {
    std::lock_guard lock(mutex_);
    lines_.push_back({kind, 0.0, std::move(text), shown});
  }
  wake_();
}

FrameListener FrameWorker::listener() {
  return {.publish =
              [this](std::shared_ptr<const FrameSnapshot> snapshot) {
                {
                  std::lock_guard lock(mutex_);
                  newest_ = std::move(snapshot);
                }
                wake_();
              },
          .interrupted = [this] { return waiting_ || stop_; },
          .ends = [this] { return stop_.load(); },
          .cancelled = [this] { return cancel_.exchange(false) || stop_; },
          .working =
              [this](std::optional<LongWork> work) {
                const bool toldBefore = this->work().has_value();
                {
                  std::lock_guard lock(mutex_);
                  if (!work_) workBegan_ = std::chrono::steady_clock::now();
                  work_ = std::move(work);
                }
                if (toldBefore || this->work()) wake_();
              },
          .say = [this](LogLine::Kind kind, std::string text) { say(kind, std::move(text)); }};
}

void FrameWorker::run() {
  lowerThreadPriority();
  try {
    GpuContext gpu({.device = start_.onCpu() ? "" : start_.device, .validation = start_.validation});
    work(gpu);
    validationMessages_ = gpu.validationMessages();
  } catch (const std::exception& error) {
    say(LogLine::Kind::error, error.what());
    std::lock_guard lock(mutex_);
    deviceFault_ = error.what();
    idle_ = true;
  }
  wake_();
}

void FrameWorker::work(GpuContext& gpu) {
  FrameMaker maker(gpu, start_, listener());
  uint32_t reloads = 0;
  while (!stop_) {
    std::optional<FrameRequest> request;
    std::vector<CaptureWish> captures;
    {
      std::unique_lock lock(mutex_);
      if (!request_ && captures_.empty()) {
        idle_ = true;
        wake_();
      }
      asked_.wait(lock, [this] { return stop_ || request_ || !captures_.empty(); });
      if (stop_) return;
      request = std::exchange(request_, std::nullopt);
      captures = std::exchange(captures_, {});
      waiting_ = false;
    }
    if (request && request->shaderReloads != reloads) {
      reloads = request->shaderReloads;
      std::string fault;
      try {
        fault = maker.reloadShaders();
      } catch (const std::exception& error) {
        fault = error.what();
      }
      const std::lock_guard lock(mutex_);
      shaderFault_ = fault;
    }
    if (request) maker.make(*request);
    validationMessages_ = gpu.validationMessages();
    for (const CaptureWish& wish : captures) {
      try {
        maker.writeCapture(wish);
        say(LogLine::Kind::note, "Captured " + wish.file, true);
      } catch (const std::exception& error) {
        say(LogLine::Kind::error, error.what(), true);
      }
    }
  }
}

}  // namespace gridscope
