// The sweep of core/tune/tune.h beside the window: on a thread, a device and a pipeline of its own, over the rays of the frame that is shown.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "app/frame/snapshot.h"
#include "core/tune/choice.h"

namespace gridscope {

// What there is to see of a sweep, done or under way.
struct TuneState {
  bool running = false;
  bool stopped = false;  // by a person: the rows are those done until then
  size_t done = 0;
  size_t total = 0;                // 0: still preparing
  double seconds = 0.0;            // since it began, or that it took
  std::vector<TuneRow> rows;       // the first is the frame's own setting; fronts and recommendation as of now
  size_t recommended = 0;          // into rows
  uint32_t width = 0, height = 0;  // of the frame whose rays are traced
  uint64_t number = 0;             // rises with every change
  std::string fault;               // why it failed; empty: it did not

  double secondsLeft() const;  // below 0: not known
};

// Largest memory and trace time that a person allows.
struct TuneLimits {
  double bytes = 0.0;
  double milliseconds = 0.0;
};

// The rule's own limits for a sweep whose first row is the frame's setting.
TuneLimits usualLimits(const TuneRow& first);
bool within(const TuneRow& row, const TuneLimits& limits);

// The measured row within the limits with the fewest wrong rays; of equally many the one with less memory, then the faster one. Nothing: no
// row is within them.
std::optional<size_t> bestWithin(std::span<const TuneRow> rows, const TuneLimits& limits);

// Takes a setting over: what a sweep varies, nothing else.
void applyTuneRow(const TuneRow& row, FrameSettings& settings);

class TuneJob {
 public:
  ~TuneJob();

  // Begins a sweep over this frame's rays; it must hold rays and instances. Ends the one that runs.
  void start(std::shared_ptr<const FrameSnapshot> frame, const TuneAxes& axes);
  void cancel() { cancel_ = true; }  // after the setting that is being tried

  TuneState state() const;
  uint64_t number() const { return number_; }  // of state(), cheaply

 private:
  void run(const std::shared_ptr<const FrameSnapshot>& frame, const TuneAxes& axes);
  void note(const TuneStep& step);
  template <typename Change>
  void change(const Change& change);

  mutable std::mutex mutex_;  // guards state_
  TuneState state_;
  std::chrono::steady_clock::time_point began_;
  std::atomic<uint64_t> number_ = 0;
  std::atomic<bool> cancel_ = false;
  std::thread thread_;
};

// How many settings a sweep over these axes tries on a frame, about: the device may refuse some.
size_t settingCount(const TuneAxes& axes, bool numberingsToo);

// Can numberings be swept: is the frame's scene a file or built in, without edits?
bool canRenumber(const FrameSnapshot& frame);

}  // namespace gridscope
