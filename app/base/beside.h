// A value worked out beside the window, on a thread of its own, again whenever what it is made of changes: the window shows the last one
// meanwhile and never waits.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <vector>

#include "app/base/low_priority.h"

namespace gridscope {

template <typename Value>
class Beside {
 public:
  // `sources`: what the value is made of; `make` must hold on to all that it reads.
  void want(const std::vector<const void*>& sources, std::function<Value()> make) {
    if (work_.valid() && work_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) value_ = work_.get();
    if (work_.valid() || (asked_ && *asked_ == sources)) return;
    asked_ = sources;
    work_ = std::async(std::launch::async, [make = std::move(make)] {
      lowerThreadPriority();
      return make();
    });
  }

  // The last finished one; nothing before the first.
  const std::optional<Value>& value() const { return value_; }

 private:
  std::optional<Value> value_;
  std::optional<std::vector<const void*>> asked_;
  std::future<Value> work_;
};

}  // namespace gridscope
