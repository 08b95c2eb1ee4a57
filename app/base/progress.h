// A progress bar on standard error while a command runs; nothing when that is no terminal.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>

namespace gridscope {

class Progress {
 public:
  // Told the share that is done and the step that begins.
  using Listener = std::function<void(float share, const std::string& what)>;

  explicit Progress(uint64_t steps) : planned_(steps) {}
  // For a listener instead of the terminal. What it throws ends the work.
  Progress(uint64_t steps, Listener listener) : terminal_(false), planned_(steps), listener_(std::move(listener)) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // From here on there are that many steps.
  void plan(uint64_t steps) { planned_ = steps, begun_ = 0; }

  // A step begins.
  void step(const std::string& what) {
    ++begun_;
    say(what);
  }

  // What is being done in the present step.
  void say(const std::string& what) {
    const uint64_t before = begun_ == 0 ? 0 : begun_ - 1;
    if (listener_) return listener_(planned_ == 0 ? 0.0f : std::min(1.0f, float(before) / float(planned_)), what);
    if (!terminal_) return;
    const uint64_t full = planned_ == 0 ? 0 : std::min(kWidth, before * kWidth / planned_);
    const std::string bar = std::string(full, '#') + std::string(kWidth - full, '.');
    std::fprintf(stderr, "\r\033[K[%s] %s", bar.c_str(), what.c_str());
    std::fflush(stderr);
    drawn_ = true;
  }

  // A line for the person, above the bar.
  void note(const std::string& line) {
    if (listener_) return;
    clear();
    std::fprintf(stderr, "%s\n", line.c_str());
  }

  // Takes the bar away.
  void clear() {
    if (drawn_) std::fprintf(stderr, "\r\033[K");
    drawn_ = false;
  }

 private:
  static constexpr uint64_t kWidth = 30;  // characters

  bool terminal_ = isatty(STDERR_FILENO) == 1;
  bool drawn_ = false;
  uint64_t planned_;
  uint64_t begun_ = 0;
  Listener listener_;
};

}  // namespace gridscope
