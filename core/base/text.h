// Text made from numbers.
#pragma once

#include <string>

namespace gridscope {

// As printf, into a string.
[[gnu::format(printf, 1, 2)]] std::string printed(const char* format, ...);

}  // namespace gridscope
