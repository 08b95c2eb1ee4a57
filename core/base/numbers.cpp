// See numbers.h.
#include "core/base/numbers.h"

#include "core/base/error.h"
#include "core/base/text.h"

namespace gridscope {

void checkNumber(const char* option, float value, float low, float high) {
  if (!(value >= low && value <= high)) throw Error(printed("%s %g: give a number from %g to %g", option, value, low, high));
}

}  // namespace gridscope
