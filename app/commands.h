// The commands: each offers its options and runs. A new one is a file command_NAME.cpp, its two functions here, and a line in kCommands.
#pragma once

#include <span>

#include "app/options.h"

namespace gridscope {

struct Command {
  const char* name;
  const char* about;                                   // one line
  void (*addOptions)(CLI::App& command, Options& options);
  int (*run)(const Options& options);                  // returns an ExitCode; throws Error
};

void addRenderOptions(CLI::App& command, Options& options);
int runRender(const Options& options);

void addScenesOptions(CLI::App& command, Options& options);
int runScenes(const Options& options);

void addInfoOptions(CLI::App& command, Options& options);
int runInfo(const Options& options);

void addBenchOptions(CLI::App& command, Options& options);
int runBench(const Options& options);

inline constexpr Command kCommands[] = {
    {"render", "Run all stages on a scene: pictures of its views, and statistics", addRenderOptions, runRender},
    {"scenes", "List the built-in scenes", addScenesOptions, runScenes},
    {"info", "List the Vulkan devices: what each can do, and its self-test", addInfoOptions, runInfo},
    {"bench", "Time each stage on a scene", addBenchOptions, runBench},
};

}  // namespace gridscope
