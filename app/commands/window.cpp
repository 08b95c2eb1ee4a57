// gridscope window: the interactive tool.
#include <CLI/CLI.hpp>

#include "app/commands/commands.h"
#include "app/ui/shell/window.h"

namespace gridscope {

namespace {

WindowOptions windowOptions;

}  // namespace

void addWindowOptions(CLI::App& command, Options& options) {
  addFrameOptions(command, options);
  command.add_flag("--log", windowOptions.logToStandardError, "Every line of the log on standard error too")->group("Window");
}

int runWindowCommand(const Options& options) { return runWindow(options, windowOptions); }

}  // namespace gridscope
