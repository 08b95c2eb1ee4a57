// See version.h. The build gives GRIDSCOPE_VERSION to this file alone: a new version compiles nothing else again.
#include "core/base/version.h"

namespace gridscope {

const char* const kVersion = GRIDSCOPE_VERSION;

}  // namespace gridscope
