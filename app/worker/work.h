// Long work as FrameMaker tells of it, for the files of maker.h alone.
#pragma once

#include <utility>

#include "app/worker/maker.h"

namespace gridscope {

class FrameMaker::Work {
 public:
  Work(const FrameListener& listener, LongWork::Kind kind, std::string what)
      : listener_(listener), work_{.kind = kind, .what = std::move(what), .share = -1.0f} {
    listener_.cancelled();
    listener_.working(work_);
  }
  ~Work() { listener_.working(std::nullopt); }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  // How much is done, 0..1; below 0: not known. False: the person has cancelled it, or the program ends.
  bool tell(float share) const {
    LongWork now = work_;
    now.share = share;
    listener_.working(now);
    return !listener_.cancelled();
  }
  void call(std::string what) { work_.what = std::move(what); }

 private:
  const FrameListener& listener_;
  LongWork work_;
};

}  // namespace gridscope
