// The program's version, from CMakeLists.txt: what captures, reports and JSON say wrote them.
#pragma once

namespace gridscope {

extern const char* const kVersion;

}  // namespace gridscope
