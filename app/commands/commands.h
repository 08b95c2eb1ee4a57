// The commands: each offers its options and runs. A new one is a file command_NAME.cpp, its two functions here, and a line in kCommands.
#pragma once

#include <span>

#include "app/session/options.h"

namespace gridscope {

struct Command {
  const char* name;
  const char* about;  // one line
  void (*addOptions)(CLI::App& command, Options& options);
  int (*run)(const Options& options);  // returns an ExitCode; throws Error
};

void addRenderOptions(CLI::App& command, Options& options);
int runRender(const Options& options);

void addScenesOptions(CLI::App& command, Options& options);
int runScenes(const Options& options);

void addInfoOptions(CLI::App& command, Options& options);
int runInfo(const Options& options);

void addBenchOptions(CLI::App& command, Options& options);
int runBench(const Options& options);

void addCaptureOptions(CLI::App& command, Options& options);
int runCapture(const Options& options);

void addInspectOptions(CLI::App& command, Options& options);
int runInspect(const Options& options);

void addReplayOptions(CLI::App& command, Options& options);
int runReplay(const Options& options);

void addDiffOptions(CLI::App& command, Options& options);
int runDiff(const Options& options);

void addRayOptions(CLI::App& command, Options& options);
int runRay(const Options& options);

void addExplainOptions(CLI::App& command, Options& options);
int runExplain(const Options& options);
void addCheckOptions(CLI::App& command, Options& options);
int runCheck(const Options& options);

void addUpdateCapturesOptions(CLI::App& command, Options& options);
int runUpdateCaptures(const Options& options);

void addTuneOptions(CLI::App& command, Options& options);
int runTune(const Options& options);

void addReportOptions(CLI::App& command, Options& options);
int runReport(const Options& options);
void addWindowOptions(CLI::App& command, Options& options);
int runWindowCommand(const Options& options);

inline constexpr Command kCommands[] = {
    {"window", "Open the window: every view live, cells in 3D, one ray stepped forward and back", addWindowOptions, runWindowCommand},
    {"render", "Run all stages on a scene: pictures of its views, and statistics", addRenderOptions, runRender},
    {"scenes", "List the built-in scenes", addScenesOptions, runScenes},
    {"info", "List the Vulkan devices: what each can do, and its self-test", addInfoOptions, runInfo},
    {"bench", "Time each stage on a scene", addBenchOptions, runBench},
    {"capture", "Keep frames of a scene in a file: inputs, grid, rays, hits", addCaptureOptions, runCapture},
    {"inspect", "Say what captures hold", addInspectOptions, runInspect},
    {"replay", "Run the stages of captures again and compare every product bit for bit", addReplayOptions, runReplay},
    {"diff", "Compare two captures by meaning", addDiffOptions, runDiff},
    {"ray", "Follow one ray step by step", addRayOptions, runRay},
    {"tune", "Try other grids and constants on a scene: what each costs in memory, time and wrong rays", addTuneOptions, runTune},
    {"report", "A page about a frame: settings, pictures, statistics, plots, what was lost and what it cost", addReportOptions, runReport},
    {"explain", "Say why rays differ from the exact answer: verdicts, causes and their proof", addExplainOptions, runExplain},
    {"check", "Run the stages and say after each whether everything holds that must; judge budgets", addCheckOptions, runCheck},
    {"update-captures", "Rerecord the captures of a folder after a wanted change, and say what changed", addUpdateCapturesOptions,
     runUpdateCaptures},
};

}  // namespace gridscope
