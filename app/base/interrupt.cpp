// See interrupt.h.
#include "app/base/interrupt.h"

#include <atomic>

namespace gridscope {

static std::atomic<bool> wasAsked = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch it");

Interrupt::Interrupt() {
  wasAsked = false;
  struct sigaction action {};
  action.sa_handler = [](int) { wasAsked = true; };
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, &oldInterrupt_);
  sigaction(SIGTERM, &action, &oldTerminate_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &oldInterrupt_, nullptr);
  sigaction(SIGTERM, &oldTerminate_, nullptr);
}

bool Interrupt::asked() { return wasAsked; }

}  // namespace gridscope
