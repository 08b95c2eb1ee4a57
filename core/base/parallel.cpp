// Spreads independent work over the cores: threads that live for one call and take the next range until none is left.
#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace gridscope {

void forRanges(size_t count, size_t chunkSize, const std::function<void(size_t begin, size_t end)>& work) {
  std::atomic<size_t> next{0};
  std::exception_ptr failure;
  std::mutex failureMutex;
  auto takeRanges = [&] {
    try {
      for (size_t begin = next.fetch_add(chunkSize); begin < count; begin = next.fetch_add(chunkSize))
        work(begin, std::min(begin + chunkSize, count));
    } catch (...) {
      std::lock_guard lock(failureMutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };

  // This thread is one of the workers.
  const size_t rangeCount = (count + chunkSize - 1) / chunkSize;
  const size_t workerCount = std::min<size_t>(rangeCount, std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::thread> others;
  for (size_t i = 1; i < workerCount; ++i) others.emplace_back(takeRanges);
  takeRanges();
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace gridscope
