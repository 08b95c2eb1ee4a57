// Ctrl-C as a question instead of an end: work that takes long asks whether the person wants it to stop, and keeps what is done.
#pragma once

#include <csignal>

namespace gridscope {

// While one lives, the first Ctrl-C (or SIGTERM) only sets a flag; a second ends the program as ever.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool asked();

 private:
  struct sigaction oldInterrupt_;
  struct sigaction oldTerminate_;
};

}  // namespace gridscope
