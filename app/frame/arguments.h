// The command line that makes the frame which the window shows: to copy, and for the report that the window makes.
#pragma once

#include <string>
#include <vector>

#include "app/frame/request.h"
#include "app/session/options.h"

namespace gridscope {

// SCENE and its options, as `gridscope render` and its kin read them; what is as it is by default is left out. A capture fixes everything: its
// file alone. Edits of instances and an up axis other than y can't be said.
std::vector<std::string> frameArguments(const FrameRequest& request);

// The same for a command that looks at one frame: its number too, and the time from which `timeStep` (seconds) counts.
std::vector<std::string> reportArguments(const FrameRequest& request, double timeStep);

// Reads them, as a command that looks at one frame does. Throws Error.
Options optionsFrom(const std::vector<std::string>& arguments);

}  // namespace gridscope
