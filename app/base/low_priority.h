// Threads that give way: what a person waits for at the keyboard goes first.
#pragma once

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace gridscope {

// Of the present thread. Threads that it starts inherit it: the drivers' and those of the stages in C++.
inline void lowerThreadPriority() {
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, id_t(syscall(SYS_gettid)), kNice);
}

}  // namespace gridscope
