// How long passes took on the device.
#pragma once

#include <map>
#include <string>

namespace gridscope {

// GPU milliseconds by pass name; passes of one name add up.
using PassTimes = std::map<std::string, double>;

// GPU milliseconds of a build or an update.
struct BuildTimes {
  double clear = 0.0;
  double add = 0.0;
};

}  // namespace gridscope
