// Spreads independent work over the cores.
#pragma once

#include <cstddef>
#include <functional>

namespace gridscope {

// Calls work(begin, end) for consecutive ranges of at most chunkSize that cover [0, count), each once, on all cores in any order. Returns when
// all are done; an exception of one range ends the rest early and is thrown on.
void forRanges(size_t count, size_t chunkSize, const std::function<void(size_t begin, size_t end)>& work);

}  // namespace gridscope
