// The window: opens it, runs it until it is closed.
#pragma once

#include <string>

#include "app/session/options.h"

namespace gridscope {

struct WindowOptions {
  uint32_t width = 1600;  // of the window, pixels
  uint32_t height = 900;
  bool logToStandardError = false;  // every line of the log
};

// Why no window can be opened here; empty: one can. Cheap enough to ask first.
std::string whyNoWindow();

// Returns an ExitCode. Throws Error.
int runWindow(const Options& start, const WindowOptions& window);

}  // namespace gridscope
